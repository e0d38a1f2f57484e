// What is on the air at one receiver on one channel, and what overlaps what.
//
// Packets start and end in order of time; at the same time all ends come before all starts, so that
// packets which only touch do not overlap. One that has ended is kept as long as it overlaps one
// that has not: it may have to be reported for the other, or XORed with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace shoal {

class AirLane {
 public:
  struct Packet {
    double start_s = 0;
    double end_s = 0;
    int32_t transmission = -1;  ///< The caller's number for its bytes.
  };

  /// A packet that has started.
  struct Ticket {
    int64_t position = -1;          ///< It was the lane's packet of this number to start.
    int64_t num_on_air_before = 0;  ///< Packets on the air when it started.
  };

  bool IsIdle() const { return num_on_air_ == 0; }

  /// @pre packet.start_s < packet.end_s; nothing has started later or ended later than start_s
  Ticket Start(const Packet& packet);

  /// Returns how many packets have overlapped this one until now. Takes constant time.
  int64_t NumOverlapping(const Ticket& ticket) const {
    return ticket.num_on_air_before + (num_started_ - 1 - ticket.position);
  }

  /// Calls `use` with packets that have overlapped this one until now, at most `limit` of them:
  /// those that started before it, the last first, then those that started after it. Takes time in
  /// proportion to the packets returned, and to shorter ones between them.
  /// @pre The packet has not ended.
  template <class Use>
  void ForOverlapping(const Ticket& ticket, int64_t limit, Use use) const;

  /// Ends a packet; appends to `unneeded` the transmissions of packets that are not kept any more.
  /// @pre No packet that has not ended ends before this one.
  void End(const Ticket& ticket, std::vector<int32_t>* unneeded);

 private:
  struct Kept {
    Packet packet;
    bool has_ended = false;
  };

  const Kept& At(int64_t position) const {
    return kept_[static_cast<size_t>(position - first_kept_)];
  }
  void Forget(int64_t end, std::vector<int32_t>* unneeded);

  std::vector<Kept> kept_;    ///< In order of start; the front `forgotten_` are gone already.
  int64_t first_kept_ = 0;    ///< Position of kept_[0].
  int64_t forgotten_ = 0;     ///< Before this position all are forgotten.
  int64_t first_on_air_ = 0;  ///< Before this position all have ended.
  int64_t num_started_ = 0;
  int64_t num_on_air_ = 0;
};

template <class Use>
void AirLane::ForOverlapping(const Ticket& ticket, int64_t limit, Use use) const {
  const double start_s = At(ticket.position).packet.start_s;
  int64_t num_before = ticket.num_on_air_before;
  for (int64_t i = ticket.position - 1; num_before > 0 && limit > 0; --i) {
    const Packet& other = At(i).packet;
    if (other.end_s <= start_s) continue;
    use(other);
    --num_before;
    --limit;
  }
  for (int64_t i = ticket.position + 1; i < num_started_ && limit > 0; ++i, --limit) {
    use(At(i).packet);
  }
}

}  // namespace shoal
