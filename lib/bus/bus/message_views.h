// What the subscribers of one process have made of one message: its decoded form and what follows
// from it, each made once by the first that asks.
//
//   const Decoded<nav_t>& nav = views.Get<Decoded<nav_t>>([&](Decoded<nav_t>* view) { ... });
//   views.Clear();   // the next message; storage is kept
#pragma once

#include <memory>
#include <vector>

namespace shoal {

class MessageViews {
 public:
  /// Returns the view of this type, which `make(View*)` fills at the first call since Clear. The
  /// View may still hold what it was before. It stays where it is until then; `make` may ask for
  /// views of other types.
  template <class View, class Make>
  const View& Get(const Make& make) {
    const Slot& slot = SlotOf<View>();
    View* view = static_cast<View*>(slot.value.get());
    if (!slot.is_made) {
      make(view);
      SlotOf<View>().is_made = true;  // Where it is now: `make` may have added slots.
    }
    return *view;
  }

  /// Returns the view of this type for the caller to fill, and counts it as made.
  template <class View>
  View* Made() {
    Slot& slot = SlotOf<View>();
    slot.is_made = true;
    return static_cast<View*>(slot.value.get());
  }

  /// Forgets what was made.
  void Clear() {
    first_.is_made = false;
    for (Slot& slot : others_) slot.is_made = false;
  }

 private:
  /// Its address stands for a type.
  template <class View>
  static inline char kTypeKey = 0;

  struct Slot {
    const void* type = nullptr;
    bool is_made = false;
    std::shared_ptr<void> value = nullptr;
  };

  template <class View>
  Slot& SlotOf() {
    const void* type = &kTypeKey<View>;
    if (first_.type == type) return first_;
    for (Slot& slot : others_) {
      if (slot.type == type) return slot;
    }
    Slot& slot = first_.type == nullptr ? first_ : others_.emplace_back();
    slot.type = type;
    slot.value = std::make_shared<View>();
    return slot;
  }

  Slot first_;  ///< Most messages have no other.
  std::vector<Slot> others_;
};

}  // namespace shoal
