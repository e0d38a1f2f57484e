/* Stands in for the hardware of a vessel with vehicle_sim = "none", and is late by purpose: turns
 * ACTUATORS into NAV, and sleeps in some steps before it answers.
 *
 *   late_driver VEHICLE EVERY LATE_MS     LATE_MS in each step that EVERY divides, but step 0
 */
#define _DEFAULT_SOURCE
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "shoal_actuators_t.h"
#include "shoal_nav_t.h"
#include "step_client.h"

static const double kTick_s = 0.1;
static const double kSpeedPerThrust_mps = 0.02;
static const double kTurnPerRudder = 0.1;

static struct {
  step_client_t* client;
  const char *vehicle, *nav_channel;
  long every, late_ms, step;
  shoal_actuators_t command;
  shoal_nav_t nav;
} self;

static void on_actuators(const char* channel, const uint8_t* data, int size, void* unused) {
  (void)channel, (void)unused;
  if (shoal_actuators_t_decode(data, 0, size, &self.command) < 0) {
    step_client_count_undecodable(self.client);
  }
}

static void think(int64_t utime, void* unused) {
  (void)unused;
  if (self.step > 0 && self.step % self.every == 0) usleep((useconds_t)(1000 * self.late_ms));
  ++self.step;
  shoal_nav_t* nav = &self.nav;
  nav->utime = utime;
  nav->surge_mps = nav->speed_mps = nav->speed_over_ground_mps =
      kSpeedPerThrust_mps * self.command.thrust_pct;
  nav->heading_deg =
      fmod(nav->heading_deg + kTurnPerRudder * self.command.rudder_deg * nav->speed_mps + 360, 360);
  nav->course_over_ground_deg = nav->heading_deg;
  nav->x_m += kTick_s * nav->speed_mps * sin(nav->heading_deg * acos(-1) / 180);
  nav->y_m += kTick_s * nav->speed_mps * cos(nav->heading_deg * acos(-1) / 180);
  uint8_t bytes[400];
  const int size = shoal_nav_t_encode(bytes, 0, sizeof bytes, nav);
  step_client_publish(self.client, self.nav_channel, self.vehicle, bytes, size);
}

int main(int argc, char** argv) {
  if (argc != 4 || (self.every = atol(argv[2])) <= 0 || (self.late_ms = atol(argv[3])) < 0) {
    fprintf(stderr, "usage: late_driver VEHICLE EVERY LATE_MS\n");
    return 2;
  }
  self.vehicle = argv[1];
  self.nav_channel = step_client_channel("NAV", self.vehicle);
  self.nav.altitude_m = -1;
  self.client = step_client_create("late_driver");
  step_client_subscribe(self.client, step_client_channel("ACTUATORS", self.vehicle), self.vehicle,
                        on_actuators, NULL);
  return step_client_run(self.client, think, NULL);
}
