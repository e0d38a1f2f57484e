#include "apps/shoal/send_helm.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "apps/shoal/send_command.h"
#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/run/orders/order_watch.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

/// The time to wait for an answer from the helm: a step, and its publishing interval of 1 s.
constexpr int64_t kAnswerPatience_us = 1'500'000;

/// Asks for the pages that are due, and receives what comes.
void ReceivePages(LcmBus& bus, OrderWatch* watch) {
  for (const std::string& app : watch->Due(MonotonicMicroseconds())) {
    appcast_req_t request{};
    request.app = app;
    Publish(bus, channels::AppcastReq(), request);
  }
  bus.Poll(kSendPoll_us);
}

}  // namespace

int SendHelm(LcmBus& bus, const OrderByName& named, const std::vector<std::string>& without_helm) {
  OrderWatch watch(TracesOf(named));
  std::set<std::string> vehicles;
  for (const OrderToHelms& order : named.orders) {
    vehicles.insert(order.vehicles.begin(), order.vehicles.end());
  }
  bool is_sent = false;
  std::map<std::string, helm_state_t> states;  ///< The last that came after the order, by vehicle.
  for (const std::string& vehicle : vehicles) {
    Subscribe(bus, channels::HelmState(vehicle), [&, vehicle](const helm_state_t& state) {
      if (is_sent) states[vehicle] = state;
    });
  }
  Subscribe(bus, channels::Appcast(),
            [&](const appcast_t& page) { watch.OnPage(page, MonotonicMicroseconds()); });

  while (!watch.IsReady(MonotonicMicroseconds()) && bus.error().empty()) ReceivePages(bus, &watch);
  Publish(bus, Order(named));
  if (!BusWorks(bus)) return kExitEnvironment;
  const int64_t sent_us = MonotonicMicroseconds();
  watch.Sent(sent_us, {});
  is_sent = true;
  for (const OrderToHelms& order : named.orders) {
    fmt::print("sent {} to {}\n", order.command.command, fmt::join(order.vehicles, ", "));
  }
  std::fflush(stdout);
  const auto is_done = [&] {
    bool done = true;
    for (const OrderWatch::Answer& answer : watch.answers()) {
      // A helm without a status page, such as a user's own, can only show its state.
      const bool is_open = answer.outcome == OrderOutcome::kOpen && answer.before;
      const bool is_refused = answer.outcome == OrderOutcome::kRefused;
      done = done && !is_open && (is_refused || states.contains(answer.trace.participant));
    }
    return done;
  };
  while (!is_done() && MonotonicMicroseconds() - sent_us < kAnswerPatience_us)
    ReceivePages(bus, &watch);

  bool is_any_refused = false;
  size_t num_silent = 0;
  size_t num_without = 0;
  std::set<std::string> shown;
  for (const OrderWatch::Answer& answer : watch.answers()) {
    const std::string& vehicle = answer.trace.participant;
    if (answer.outcome == OrderOutcome::kRefused) {
      is_any_refused = true;
      fmt::print(stderr, "{} refused: {}\n", vehicle, answer.reason);
      continue;
    }
    if (!shown.insert(vehicle).second) continue;
    if (const auto state = states.find(vehicle); state != states.end()) {
      fmt::print("{}: {} {} ({})\n", vehicle, state->second.state, state->second.task,
                 state->second.all_stop);
    } else if (std::ranges::find(without_helm, vehicle) != without_helm.end()) {
      ++num_without;
      fmt::print(stderr, "{} has no helm (helm = \"none\"), and no program answered in its place\n",
                 vehicle);
    } else {
      ++num_silent;
    }
  }
  if (const std::string done = DoneBesideRefusals(watch.answers()); !done.empty()) {
    fmt::print(stderr, "done all the same: {}\n", done);
  }
  if (num_silent > 0) {
    fmt::print(
        "{} of {} helms have published nothing since; `shoal status` shows which participants "
        "run, and whether the mission is paused\n",
        num_silent, vehicles.size() - num_without);
  }
  return is_any_refused || num_without == vehicles.size() ? kExitUsage : kExitOk;
}

}  // namespace shoal
