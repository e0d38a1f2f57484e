/* A thousand missions, one after the other, take no more memory than a hundred: resident set size.
 *
 *   shoal_sim_leak_test MISSION NUMBER
 *
 * C11, to show that the header is. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "sim/shoal_sim.h"

static long resident_kib(void) {
  FILE* file = fopen("/proc/self/statm", "r");
  long total = 0;
  long resident = 0;
  if (file == NULL) return -1;
  const int read = fscanf(file, "%ld %ld", &total, &resident);
  fclose(file);
  return read == 2 ? resident * (sysconf(_SC_PAGESIZE) / 1024) : -1;
}

static int run_once(const char* mission) {
  shoal_sim* sim = shoal_sim_new(mission);
  const void* data = NULL;
  int is_sound = shoal_sim_watch(sim, "NAV_ALPHA") == SHOAL_SIM_OK;
  is_sound = is_sound && shoal_sim_open(sim) == SHOAL_SIM_OK && shoal_sim_step(sim, 20) == 20;
  is_sound = is_sound && shoal_sim_read(sim, "NAV_ALPHA", &data, NULL, NULL) == SHOAL_SIM_OK;
  is_sound = is_sound && data != NULL && shoal_sim_summary(sim)[0] != '\0';
  if (!is_sound) fprintf(stderr, "%s\n", shoal_sim_error(sim));
  shoal_sim_free(sim);
  /* A mission that cannot be opened is freed, too. */
  sim = shoal_sim_new("/nowhere.toml");
  is_sound = is_sound && shoal_sim_open(sim) == SHOAL_SIM_MISSION;
  shoal_sim_free(sim);
  return is_sound;
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const int number = atoi(argv[2]);
  const int warm_up = number / 10;
  long before_kib = 0;
  for (int i = 0; i < number; ++i) {
    if (i == warm_up) before_kib = resident_kib();
    if (!run_once(argv[1])) return 1;
  }
  const long grown_kib = resident_kib() - before_kib;
  printf("%d missions after the first %d: %ld KiB more than the %ld KiB before\n", number - warm_up,
         warm_up, grown_kib, before_kib);
  /* One forgotten node report for each mission would be more. */
  return grown_kib <= 512 ? 0 : 1;
}
