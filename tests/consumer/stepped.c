/* Steps a mission by the C interface. */
#include <shoal_nav_t.h>
#include <sim/shoal_sim.h>
#include <stdio.h>

int main(int argc, char** argv) {
  shoal_sim* sim = shoal_sim_new(argc > 1 ? argv[1] : NULL);
  shoal_sim_watch(sim, "NAV_ALPHA");
  if (shoal_sim_open(sim) != SHOAL_SIM_OK) return puts(shoal_sim_error(sim)), 2;
  while (shoal_sim_step(sim, 10) == 10) {
  }
  const void* data = NULL;
  size_t size = 0;
  shoal_nav_t nav;
  shoal_sim_read(sim, "NAV_ALPHA", &data, &size, NULL);
  if (shoal_nav_t_decode(data, 0, (int)size, &nav) < 0) return 1;
  printf("alpha at %.1f, %.1f\n%s", nav.x_m, nav.y_m, shoal_sim_summary(sim));
  const int passed = shoal_sim_passed(sim);
  shoal_sim_free(sim);
  return passed ? 0 : 1;
}
