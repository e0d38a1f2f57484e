/* A referee in step with a mission, in plain C: a slow vehicle of a group is hard to detect.
 *
 *   referee GROUP SLOW_MPS STEALTH      for example: referee hiders 1.0 0.4
 *
 * It subscribes to the reports of all vehicles at the shore. A vehicle of GROUP (empty: every
 * vehicle) that goes more slowly than SLOW_MPS gets STEALTH, from UNC_STEALTH on; one that does not
 * gets 1 again. `shoal run missions/hide_and_seek.toml` starts it.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "shoal_node_report_t.h"
#include "shoal_unc_control_t.h"
#include "step_client.h"

enum { kMaxVehicles = 1000 };

static struct {
  step_client_t* client;
  const char* group;
  double slow_mps, reward;
  struct {
    char name[33];
    double stealth; /* As it has it now. */
    double earned;  /* By its last report. */
  } vehicles[kMaxVehicles];
  int num_vehicles;
} self;

static void on_report(const char* channel, const uint8_t* data, int size, void* unused) {
  (void)channel, (void)unused;
  shoal_node_report_t report;
  if (shoal_node_report_t_decode(data, 0, size, &report) < 0) {
    step_client_count_undecodable(self.client);
    return;
  }
  int i = 0;
  while (i < self.num_vehicles && strcasecmp(self.vehicles[i].name, report.name) != 0) ++i;
  const int plays = self.group[0] == '\0' || strcasecmp(report.group, self.group) == 0;
  if (plays && i == self.num_vehicles && i < kMaxVehicles) {
    snprintf(self.vehicles[i].name, sizeof self.vehicles[i].name, "%s", report.name);
    self.vehicles[i].stealth = 1;
    ++self.num_vehicles;
  }
  if (plays && i < self.num_vehicles) {
    self.vehicles[i].earned = report.speed_mps < self.slow_mps ? self.reward : 1;
  }
  shoal_node_report_t_decode_cleanup(&report);
}

static void think(int64_t utime, void* unused) {
  (void)unused;
  for (int i = 0; i < self.num_vehicles; ++i) {
    if (self.vehicles[i].earned == self.vehicles[i].stealth) continue;
    self.vehicles[i].stealth = self.vehicles[i].earned;
    const shoal_unc_control_t control = {.utime = utime,
                                         .vehicle = self.vehicles[i].name,
                                         .value = self.vehicles[i].stealth,
                                         .text = ""};
    uint8_t bytes[100];
    const int size = shoal_unc_control_t_encode(bytes, 0, sizeof bytes, &control);
    step_client_publish(self.client, "UNC_STEALTH", NULL, bytes, size);
    printf("referee: t=%.1f s: %s has stealth %g\n", (double)utime / 1e6, self.vehicles[i].name,
           self.vehicles[i].stealth);
  }
}

int main(int argc, char** argv) {
  if (argc != 4) {
    fprintf(stderr, "usage: referee GROUP SLOW_MPS STEALTH, for example: referee hiders 1.0 0.4\n");
    return 2;
  }
  self.group = argv[1];
  self.slow_mps = atof(argv[2]);
  self.reward = atof(argv[3]);
  setvbuf(stdout, NULL, _IOLBF, 0);
  self.client = step_client_create("referee");
  step_client_subscribe(self.client, "NODE_REPORT_LOCAL", NULL, on_report, NULL);
  return step_client_run(self.client, think, NULL);
}
