/* Runs a mission inside a program in C, and looks at what its first vehicle does.
 *
 *   embed_c MISSION [LOG]
 *
 * It needs libshoal_sim and the C message types, and nothing else of shoal:
 * docs/extending/embedding.md. */
#include <ctype.h>
#include <math.h>
#include <shoal_nav_t.h>
#include <stdio.h>
#include <time.h>

#include "sim/shoal_sim.h"

static int fail(shoal_sim* sim) {
  fprintf(stderr, "embed_c: %s\n", shoal_sim_error(sim));
  shoal_sim_free(sim);
  return 2;
}

/* Writes "NAV_" and the vehicle's name in upper case. */
static void name_channel(const char* vehicle, char* channel, size_t size) {
  const int used = snprintf(channel, size, "NAV_%s", vehicle);
  for (int i = 0; i < used && (size_t)i < size; ++i) {
    channel[i] = (char)toupper((unsigned char)channel[i]);
  }
}

int main(int argc, char** argv) {
  if (argc < 2) return fprintf(stderr, "usage: embed_c MISSION [LOG]\n"), 2;
  if (shoal_sim_abi_version() != SHOAL_SIM_ABI_VERSION) {
    return fprintf(stderr, "embed_c: built for another version of libshoal_sim\n"), 2;
  }
  shoal_sim* sim = shoal_sim_new(argv[1]);
  if (argc > 2) shoal_sim_set_log(sim, argv[2]);
  if (shoal_sim_open(sim) != SHOAL_SIM_OK) return fail(sim);
  const char* vehicle = shoal_sim_vehicle(sim, 0);
  if (vehicle == NULL) return fprintf(stderr, "embed_c: no vehicle\n"), shoal_sim_free(sim), 2;
  char channel[64];
  name_channel(vehicle, channel, sizeof channel);
  if (shoal_sim_watch(sim, channel) != SHOAL_SIM_OK) return fail(sim);

  struct timespec begin;
  struct timespec end;
  clock_gettime(CLOCK_MONOTONIC, &begin);
  double farthest_m = 0;
  int64_t taken = 0;
  while ((taken = shoal_sim_step(sim, 1)) == 1) {
    const void* data = NULL;
    size_t size = 0;
    shoal_nav_t nav;
    if (shoal_sim_read(sim, channel, &data, &size, NULL) != SHOAL_SIM_OK) return fail(sim);
    if (data == NULL || shoal_nav_t_decode(data, 0, (int)size, &nav) < 0) continue;
    farthest_m = fmax(farthest_m, hypot(nav.x_m, nav.y_m));
    shoal_nav_t_decode_cleanup(&nav);
  }
  if (taken < 0) return fail(sim);
  clock_gettime(CLOCK_MONOTONIC, &end);
  const double wall_s =
      (double)(end.tv_sec - begin.tv_sec) + 1e-9 * (double)(end.tv_nsec - begin.tv_nsec);
  const double vehicle_steps =
      (double)(shoal_sim_step_number(sim) + 1) * (double)shoal_sim_num_vehicles(sim);
  printf("%s was %.0f m from the origin; %.0f vehicle steps per second\n%s", vehicle, farthest_m,
         vehicle_steps / wall_s, shoal_sim_summary(sim));
  const int passed = shoal_sim_passed(sim);
  shoal_sim_free(sim);
  return passed ? 0 : 1;
}
