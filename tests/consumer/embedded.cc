// Embeds a mission, and asks the mission itself and its director.
#include <cstdio>

#include "lib/mission/model/mission.h"
#include "sim/director_app.h"
#include "sim/simulation.h"

int main(int, char** argv) {
  auto opened = shoal::Simulation::Open({.mission_file = argv[1]});
  if (!opened.ok()) return std::fprintf(stderr, "%s\n", opened.error().c_str()), 2;
  int num_nav = 0;
  shoal::Subscribe(opened->bus(), shoal::channels::Nav("alpha"),
                   [&](const shoal::nav_t&) { ++num_nav; });
  while (opened->Step()) {
  }
  std::printf("%zu vehicles, %d messages\n%s", opened->mission().vehicles.size(), num_nav,
              opened->director().Summary(true).c_str());
  return opened->Passed() && num_nav > 100 ? 0 : 1;
}
