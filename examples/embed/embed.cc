// Runs a mission inside a program of one's own, and looks at what a vehicle does.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/simulation.h"

int main(int argc, char** argv) {
  auto opened = shoal::Simulation::Open({.mission_file = argc > 1 ? argv[1] : "", .seed = 7});
  if (!opened.ok()) return std::fprintf(stderr, "embed: %s\n", opened.error().c_str()), 2;
  shoal::Simulation& simulation = *opened;
  double farthest_m = 0;
  shoal::Subscribe(simulation.bus(), shoal::channels::Nav("alpha"), [&](const shoal::nav_t& nav) {
    farthest_m = std::max(farthest_m, std::hypot(nav.x_m, nav.y_m));
  });
  while (simulation.Step()) {
  }
  std::printf("alpha was %.0f m from the origin\n%s", farthest_m, simulation.Summary().c_str());
  return simulation.Passed() ? 0 : 1;
}
