// Future events of the acoustic network, in order of time.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shoal {

inline constexpr int kMaxAcousticNodes = 1 << 22;

/// At the same moment, ends come first: packets that only touch do not meet.
enum class AcousticEventKind : uint8_t { kReceptionEnds, kReceptionStarts, kTransmissionStarts };

/// Returns a number that grows with the time: its bits (IEEE 754) without the sign grow with its
/// size. @pre time_s is not NaN
inline uint64_t OrderOf(double time_s) {
  const auto bits = std::bit_cast<uint64_t>(time_s + 0.0);  // + 0.0 makes -0 a 0.
  constexpr uint64_t kSign = uint64_t{1} << 63;
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

/// Returns the time whose OrderOf this is.
inline double TimeOf(uint64_t order) {
  constexpr uint64_t kSign = uint64_t{1} << 63;
  return std::bit_cast<double>((order & kSign) != 0 ? order & ~kSign : ~order);
}

struct AcousticEvent {
  uint64_t time_order = 0;  ///< OrderOf the moment.
  uint64_t rank = 0;  ///< Among events of the same moment: kind, turn, receiver, high bits first.
  int32_t slot = -1;  ///< Of the reception, or of the transmission that starts.

  AcousticEventKind kind() const { return static_cast<AcousticEventKind>(rank >> 62); }

  /// An order that does not depend on the other events in the queue. In whole numbers, since
  /// comparing them takes no branch.
  bool operator<(const AcousticEvent& other) const {
    return (time_order < other.time_order) |
           ((time_order == other.time_order) & (rank < other.rank));
  }
};

/// `turn` counts transmissions. @pre 0 <= turn < 2^40, 0 <= receiver < kMaxAcousticNodes
inline AcousticEvent MakeEvent(AcousticEventKind kind, double time_s, int64_t turn,
                               int32_t receiver, int32_t slot) {
  return {OrderOf(time_s),
          uint64_t{static_cast<uint8_t>(kind)} << 62 | static_cast<uint64_t>(turn) << 22 |
              static_cast<uint64_t>(receiver),
          slot};
}

/// Returns what a reception that starts will be when it ends.
inline AcousticEvent EndOf(const AcousticEvent& start, double end_s) {
  constexpr uint64_t kBelowKind = (uint64_t{1} << 62) - 1;
  return {OrderOf(end_s),
          uint64_t{static_cast<uint8_t>(AcousticEventKind::kReceptionEnds)} << 62 |
              (start.rank & kBelowKind),
          start.slot};
}

/// A heap: the cost of each event grows with the logarithm of those queued. Four children to a
/// parent, which takes half the levels, and so half the cache misses, of two.
class EventQueue {
 public:
  void Push(const AcousticEvent& event) {
    size_t place = events_.size();
    events_.push_back(event);
    while (place > 0) {
      const size_t parent = (place - 1) / kChildren;
      if (!(event < events_[parent])) break;
      events_[place] = events_[parent];
      place = parent;
    }
    events_[place] = event;
  }

  bool HasEventUntil(double time_s) const {
    return !events_.empty() && events_.front().time_order <= OrderOf(time_s);
  }

  bool IsEmpty() const { return events_.empty(); }

  /// @pre the queue is not empty, for the next three.
  const AcousticEvent& First() const { return events_.front(); }
  void PopFirst() {
    const AcousticEvent last = events_.back();
    events_.pop_back();
    if (!events_.empty()) ReplaceFirst(last);
  }
  void ReplaceFirst(const AcousticEvent& event) {
    const size_t size = events_.size();
    size_t place = 0;
    for (size_t child = 1; child < size; child = kChildren * place + 1) {
      const size_t end = std::min(child + kChildren, size);
      size_t least = child;
      for (size_t other = child + 1; other < end; ++other) {
        // Without a branch, which would be unpredictable.
        least += (other - least) * static_cast<size_t>(events_[other] < events_[least]);
      }
      if (!(events_[least] < event)) break;
      events_[place] = events_[least];
      place = least;
    }
    events_[place] = event;
  }

 private:
  static constexpr size_t kChildren = 4;

  std::vector<AcousticEvent> events_;
};

}  // namespace shoal
