#include "apps/shoal/send_clock.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <optional>

#include "apps/shoal/send_command.h"
#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/run/orders/clock_watch.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

/// The clock publishes its state twice per second, and at once after an order.
constexpr int64_t kClockPatience_us = 3'000'000;
/// The time to wait for the first measurement of a new speed.
constexpr int64_t kFactorPatience_us = 1'000'000;

bool PollUntil(LcmBus& bus, int64_t patience_us, const std::function<bool()>& is_done) {
  const int64_t begin = MonotonicMicroseconds();
  while (!is_done()) {
    if (MonotonicMicroseconds() - begin > patience_us || !bus.error().empty()) return false;
    bus.Poll(kSendPoll_us);
  }
  return true;
}

}  // namespace

int SendClock(LcmBus& bus, const OrderToClock& order) {
  std::optional<clock_state_t> state;
  std::optional<ClockWatch> watch;
  Subscribe(bus, channels::ClockState(), [&](const clock_state_t& received) {
    state = received;
    if (watch) watch->OnState(received);
  });
  const bool is_there = PollUntil(bus, kClockPatience_us, [&] { return state.has_value(); });
  if (!BusWorks(bus)) return kExitEnvironment;
  if (is_there) {
    watch.emplace(order.command, state);
    Publish(bus, Order(order));
  }
  if (!is_there || !PollUntil(bus, kClockPatience_us, [&] { return watch->IsSettled(); })) {
    fmt::print(stderr,
               "shoal: the mission's clock does not answer: it is stopped, or this is a broker "
               "without a mission; `shoal status shoal` shows whether the launcher answers\n");
    return kExitEnvironment;
  }
  if (!watch->refusal().empty()) {
    fmt::print(stderr, "clock: {} refused: {}\n", order.command.command, watch->refusal());
    return kExitUsage;
  }
  PollUntil(bus, kFactorPatience_us,
            [&] { return state->state != "running" || state->factor > 0; });
  fmt::print("clock: {}\n", ClockText(*state));
  if (state->state == "gathering") {
    fmt::print("the mission has not begun{}{}\n",
               state->awaited.empty()
                   ? ""
                   : fmt::format("; it waits for {}", fmt::join(state->awaited, ", ")),
               order.command.command == "pause" ? ", and then for `shoal send clock resume`" : "");
  }
  return kExitOk;
}

}  // namespace shoal
