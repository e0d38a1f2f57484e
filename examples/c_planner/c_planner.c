/* A program of one's own that takes part in stepping, in plain C: it steers one vessel to a list of
 * waypoints, in place of shoal's helm.
 *
 *   c_planner VEHICLE X,Y [X,Y]...       x East, y North, metres
 *
 * `shoal run missions/c_planner.toml` starts it and sets the SHOAL_* variables that step_client
 * reads.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "shoal_actuators_t.h"
#include "shoal_nav_t.h"
#include "step_client.h"

enum { kMaxWaypoints = 100 };

static const double kPi = 3.14159265358979323846;
static const double kCaptureRadius_m = 8;
static const double kCruiseThrust_pct = 40;
static const double kRudderGain = 1.5; /* Degrees of rudder per degree of heading error. */
static const double kMaxRudder_deg = 60;

static struct {
  step_client_t* client;
  const char *vehicle, *actuators_channel;
  double waypoints_m[kMaxWaypoints][2];
  int num_waypoints, next_waypoint;
  shoal_nav_t nav; /* The newest that a step has handed over. */
  bool has_nav;
} self;

static shoal_actuators_t steer(int64_t utime) {
  shoal_actuators_t command = {.utime = utime, .thrust_pct = 0, .rudder_deg = 0};
  if (!self.has_nav) return command;
  while (self.next_waypoint < self.num_waypoints) {
    const double* target_m = self.waypoints_m[self.next_waypoint];
    const double east_m = target_m[0] - self.nav.x_m, north_m = target_m[1] - self.nav.y_m;
    if (hypot(east_m, north_m) > kCaptureRadius_m) {
      const double bearing_deg = atan2(east_m, north_m) * 180 / kPi;
      const double error_deg = remainder(bearing_deg - self.nav.heading_deg, 360);
      command.thrust_pct = kCruiseThrust_pct;
      command.rudder_deg = fmax(-kMaxRudder_deg, fmin(kMaxRudder_deg, kRudderGain * error_deg));
      return command;
    }
    ++self.next_waypoint;
    printf("c_planner: t=%.1f s: at waypoint %d of %d\n", (double)utime / 1e6, self.next_waypoint,
           self.num_waypoints);
  }
  return command;
}

static void on_nav(const char* channel, const uint8_t* data, int size, void* unused) {
  (void)channel, (void)unused;
  shoal_nav_t nav;
  if (shoal_nav_t_decode(data, 0, size, &nav) < 0) {
    step_client_count_undecodable(self.client);
    return;
  }
  self.nav = nav;
  self.has_nav = true;
}

static void think(int64_t utime, void* unused) {
  (void)unused;
  const shoal_actuators_t command = steer(utime);
  uint8_t bytes[100];
  const int size = shoal_actuators_t_encode(bytes, 0, sizeof bytes, &command);
  step_client_publish(self.client, self.actuators_channel, self.vehicle, bytes, size);
}

static void usage(void) {
  fprintf(stderr, "usage: c_planner VEHICLE X,Y [X,Y]...\n");
  exit(2);
}

static void read_command_line(int argc, char** argv) {
  if (argc < 3 || argc - 2 > kMaxWaypoints) usage();
  for (int i = 2; i < argc; ++i) {
    double* point_m = self.waypoints_m[self.num_waypoints++];
    if (sscanf(argv[i], "%lf,%lf", &point_m[0], &point_m[1]) != 2) {
      fprintf(stderr, "c_planner: '%s' is not X,Y\n", argv[i]);
      exit(2);
    }
  }
}

int main(int argc, char** argv) {
  read_command_line(argc, argv);
  setvbuf(stdout, NULL, _IOLBF, 0);
  self.vehicle = argv[1];
  self.actuators_channel = step_client_channel("ACTUATORS", self.vehicle);
  self.client = step_client_create("c_planner");
  step_client_subscribe(self.client, step_client_channel("NAV", self.vehicle), self.vehicle, on_nav,
                        NULL);
  return step_client_run(self.client, think, NULL);
}
