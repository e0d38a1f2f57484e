#include "lib/tools/view/view_clock.h"

#include <cmath>

namespace shoal {

ViewClock ViewClockOf(const clock_state_t& clock) {
  constexpr size_t kMaxAwaitedShown = 100;
  constexpr size_t kMaxClockText = 200;
  ViewClock view{.state = "running"};
  if (clock.state == "gathering" || clock.state == "paused") view.state = clock.state;
  if (clock.state == "ending") view.state = "ended";
  if (std::isfinite(clock.warp) && clock.warp >= 0) view.warp = clock.warp;
  if (std::isfinite(clock.factor) && clock.factor >= 0) view.factor = clock.factor;
  for (const std::string& name : clock.awaited) {
    if (view.awaited.size() == kMaxAwaitedShown) break;
    view.awaited.push_back(name.substr(0, kMaxClockText));
  }
  view.note = clock.refusal.substr(0, kMaxClockText);
  return view;
}

}  // namespace shoal
