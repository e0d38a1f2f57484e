// Takes orders for a running mission from the viewer, as `shoal send` does from the shell, and
// finds out what became of them.
//
//   CommandDesk desk(bus, {.mission = "berta", .vehicles = {"alpha", "bravo"}});
//   const Result<CommandRecord> record = desk.Send("alpha", words, t_s);   // from any thread
//   bus.Poll(20'000), desk.OnTime(now_us);                // in the bus's thread, every 20 ms or so
//   desk.records();                                       // taken, or refused and why
//
//   sent --the page from before is here, or 300 ms--> published --+--> taken
//                                                                 +--> refused, with the reason
//                        5 s without an answer: "no answer yet" --+    (it is still awaited)
#pragma once

#include <cstdint>
#include <deque>
#include <list>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/bus.h"
#include "lib/run/orders/clock_watch.h"
#include "lib/run/orders/command_record.h"
#include "lib/run/orders/order.h"
#include "lib/run/orders/order_watch.h"
#include "shoal/appcast_t.hpp"
#include "shoal/clock_state_t.hpp"

namespace shoal {

class CommandDesk {
 public:
  static constexpr size_t kMaxRecords = 20;  ///< Older ones are forgotten.

  /// Subscribes to APPCAST and CLOCK_STATE. @pre no message has been handled on `bus` yet
  CommandDesk(Bus& bus, OrderScope scope);

  /// Takes an order and returns its record, whose state is "sent"; or returns what is wrong with
  /// it, in the words of `shoal send`, and publishes nothing. It is published in OnTime, after all
  /// that were taken before. `t_s` is mission time. May be called from any thread.
  Result<CommandRecord> Send(std::string_view target, std::span<const std::string> words,
                             double t_s);

  /// Publishes what is due and looks what became of what was published. `now_us`: wall time of any
  /// epoch, never backward. Only in the bus's thread.
  void OnTime(int64_t now_us);

  /// Returns the last orders, the newest last. May be called from any thread.
  [[nodiscard]] std::vector<CommandRecord> records() const;

 private:
  /// An order that is not settled yet.
  struct Pending {
    int64_t id = 0;
    Order order;
    OrderWatch watch;  ///< Of the participants that show on their pages what they made of it.
    std::optional<ClockWatch> clock;  ///< Of an order to the clock.
    bool is_published = false;
    int64_t waited_us = 0;  ///< For an answer; while the mission is paused, this stands still.
  };

  void TakeIn();
  void PublishDue();
  void Request(bool is_paused);
  void Settle();

  Bus& bus_;
  const OrderScope scope_;
  std::list<Pending> pending_;  ///< In the order of Send.
  std::optional<clock_state_t> clock_state_;
  int64_t now_us_ = 0;

  mutable std::mutex mutex_;  ///< Of what follows.
  std::deque<CommandRecord> records_;
  std::vector<std::pair<int64_t, Order>> inbox_;
  int64_t last_id_ = 0;
};

}  // namespace shoal
