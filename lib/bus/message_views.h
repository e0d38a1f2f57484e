// What the subscribers of one process have made of one message: its decoded form and what follows
// from it, each made once by the first that asks.
//
//   const Decoded<nav_t>& nav = views.Get<Decoded<nav_t>>([&](Decoded<nav_t>* view) { ... });
//   views.Clear();   // the next message; storage is kept
#pragma once

#include <deque>
#include <memory>

namespace shoal {

class MessageViews {
 public:
  /// Returns the view of this type, which `make(View*)` fills at the first call since Clear. The
  /// View may still hold what it was before. It stays where it is until then; `make` may ask for
  /// views of other types.
  template <class View, class Make>
  const View& Get(const Make& make) {
    Slot& slot = SlotOf(&kTypeKey<View>);
    if (slot.value == nullptr) slot.value = std::make_shared<View>();
    View* view = static_cast<View*>(slot.value.get());
    if (!slot.is_made) make(view);
    slot.is_made = true;
    return *view;
  }

  /// Forgets what was made.
  void Clear() {
    for (Slot& slot : slots_) slot.is_made = false;
  }

 private:
  /// Its address stands for a type.
  template <class View>
  static inline char kTypeKey = 0;

  struct Slot {
    const void* type = nullptr;
    std::shared_ptr<void> value = nullptr;
    bool is_made = false;
  };

  Slot& SlotOf(const void* type) {
    for (Slot& slot : slots_) {
      if (slot.type == type) return slot;
    }
    return slots_.emplace_back(Slot{.type = type});
  }

  std::deque<Slot> slots_;  ///< One or two; a slot never moves.
};

}  // namespace shoal
