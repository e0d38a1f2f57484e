// What became of an order, from the status pages of its addressees: before it, and after it.
//
//   OrderWatch watch(TracesOf(order));
//   while (!watch.IsReady(now_us)) ...   // ask for the pages of Due(now_us), hand over what comes
//   Publish(bus, order);
//   watch.Sent(now_us, {});
//   while (!watch.IsSettled()) ...       // the same again
//
// Helm, simulator and broker list their recent events on their pages: orders that they took, and
// orders that they refused. The n-th new event of an order's kind is what became of the n-th order.
#pragma once

#include <cstdint>
#include <list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shoal/appcast_t.hpp"

namespace shoal {

/// Where one participant reports what it made of an order. Two orders are of one kind where `taken`
/// and `refused` are the same.
struct OrderTrace {
  std::string app;          ///< The participant: "helm_alpha".
  std::string participant;  ///< For people: "alpha".
  std::string taken;    ///< The first words of the event that reports it as taken: "command: goto".
  std::string refused;  ///< The first words of the event that reports it as refused.
};

enum class OrderOutcome { kOpen, kTaken, kRefused };

class OrderWatch {
 public:
  struct Answer {
    OrderTrace trace;
    OrderOutcome outcome = OrderOutcome::kOpen;
    std::string reason;  ///< Why it was refused.

    std::optional<appcast_t> before;  ///< The last page from before the order.
    /// Orders of this kind to this participant that were open when it was sent.
    int num_ahead = 0;
  };

  explicit OrderWatch(std::vector<OrderTrace> traces);

  /// Returns the participants whose pages are wanted now, and counts them as asked.
  /// `interval_us`: the time between two requests.
  std::vector<std::string> Due(int64_t now_us, int64_t interval_us = kRequestInterval_us);

  void OnPage(const appcast_t& page, int64_t now_us);

  /// True where all pages from before the order are here, or have been waited for in vain. The
  /// first Due() starts the wait.
  [[nodiscard]] bool IsReady(int64_t now_us) const;

  /// The order has been published, after those that `earlier` watch.
  void Sent(int64_t now_us, const std::vector<const OrderWatch*>& earlier);

  [[nodiscard]] bool IsSettled() const;
  [[nodiscard]] const std::vector<Answer>& answers() const { return answers_; }

  static constexpr int64_t kRequestInterval_us = 100'000;

 private:
  std::vector<Answer> answers_;
  std::optional<int64_t> first_request_us_;
  std::optional<int64_t> sent_us_;
  int64_t next_request_us_ = 0;
};

/// Of an order that some refused: what was done all the same, "alpha: deploy; bravo: set"; empty
/// where nothing was refused, or nothing done.
[[nodiscard]] std::string DoneBesideRefusals(const std::vector<OrderWatch::Answer>& answers);

}  // namespace shoal
