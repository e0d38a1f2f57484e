/* A program of one's own that takes part in stepping, in plain C: it steers one vessel to a list of
 * waypoints, in place of shoal's helm. docs/step_protocol.md tells the rules; this is all of them.
 *
 *   c_planner VEHICLE X,Y [X,Y]...       x East, y North, metres
 *
 * `shoal run missions/c_planner.toml` starts it and sets the SHOAL_* variables read in main().
 */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <lcm/lcm.h>
#include <math.h>
#include <poll.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <time.h>
#include <unistd.h>

#include "shoal_actuators_t.h"
#include "shoal_nav_t.h"
#include "shoal_resend_t.h"
#include "shoal_step_done_t.h"
#include "shoal_tick_t.h"

enum { kMaxWaypoints = 100, kMaxCommunities = 128, kMaxDatagram = 256 };

static const double kPi = 3.14159265358979323846;
static const double kCaptureRadius_m = 8;
static const double kCruiseThrust_pct = 40;
static const double kRudderGain = 1.5; /* Degrees of rudder per degree of heading error. */
static const double kMaxRudder_deg = 60;

static const int64_t kHelloInterval_ms = 200;
static const int64_t kRepeatInterval_ms = 50;
static const int64_t kGiveUpAfter_ms = 3000;
static const int64_t kLinger_ms = 250; /* After END: the clock may not have heard the answer. */

/* A datagram as it was sent, so that it can be sent again. */
typedef struct {
  int64_t step;
  uint8_t bytes[kMaxDatagram];
  unsigned size;
} sent_t;

static struct {
  char name[101];
  char nav_channel[64], actuators_channel[64];
  lcm_t *tick_bus, *done_bus, *vehicle_bus;
  int64_t mission_id;

  double waypoints_m[kMaxWaypoints][2];
  int num_waypoints, next_waypoint;
  shoal_nav_t nav; /* The newest that a step has handed over. */
  bool has_nav;

  int64_t step;           /* The last one answered; -1: none. */
  shoal_step_done_t done; /* That answer, to be given again. */
  shoal_step_count_t published;
  sent_t sent[2]; /* This step's ACTUATORS and the last one's. */

  shoal_tick_t* pending; /* The tick whose messages are not all here yet. */
  int64_t pending_since_ms, next_repeat_ms;
  shoal_nav_t heard[2]; /* NAV by parity of the step: its one sender says it once per step. */
  int64_t heard_step[2];

  bool ended;
  int64_t missed, foreign, undecodable;
} self;

static void die(int exit_code, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  fprintf(stderr, "c_planner: ");
  vfprintf(stderr, format, arguments);
  fprintf(stderr, "\n");
  va_end(arguments);
  exit(exit_code);
}

static int64_t now_ms(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

/* ---- the seal: publisher, length of that name, mission id, step, sequence, "SHOL" ---- */

static uint8_t* put(uint8_t* at, uint64_t value, int num_bytes) {
  for (int shift = 8 * (num_bytes - 1); shift >= 0; shift -= 8) *at++ = (uint8_t)(value >> shift);
  return at;
}

static uint64_t get(const uint8_t* at, int num_bytes) {
  uint64_t value = 0;
  for (int i = 0; i < num_bytes; ++i) value = value << 8 | at[i];
  return value;
}

static unsigned append_seal(uint8_t* message, unsigned size, int64_t step, uint32_t sequence) {
  uint8_t* at = message + size;
  const size_t name_size = strlen(self.name);
  memcpy(at, self.name, name_size);
  at = put(at + name_size, name_size, 1);
  at = put(at, (uint64_t)self.mission_id, 8);
  at = put(at, (uint64_t)step, 8);
  at = put(at, sequence, 4);
  at = put(at, 0x53484f4c, 4);
  return (unsigned)(at - message);
}

/* Reads mission id and step; false for a message from outside the step protocol. */
static bool read_seal(const lcm_recv_buf_t* datagram, int64_t* mission_id, int64_t* step) {
  if (datagram->data_size < 25) return false;
  const uint8_t* seal = (const uint8_t*)datagram->data + datagram->data_size - 25;
  if (get(seal + 21, 4) != 0x53484f4c) return false;
  *mission_id = (int64_t)get(seal + 1, 8);
  *step = (int64_t)get(seal + 9, 8);
  return true;
}

/* ---- what this program is for ---- */

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

/* ---- one step: take what the step before said, think, publish, answer ---- */

static void send_done(void) { shoal_step_done_t_publish(self.done_bus, "STEP_DONE", &self.done); }

/* Answers a tick; step -1 is the hello before the first. */
static void answer(int64_t utime, int64_t step, int32_t num_published, char* fault) {
  self.published.channel = self.actuators_channel;
  self.published.count = 1;
  self.done = (shoal_step_done_t){.utime = utime,
                                  .mission_id = self.mission_id,
                                  .step = step,
                                  .participant = self.name,
                                  .pid = (int32_t)getpid(),
                                  .repeated = self.missed,
                                  .foreign = self.foreign,
                                  .undecodable = self.undecodable,
                                  .fault = fault,
                                  .num_published = num_published,
                                  .published = &self.published};
  send_done();
}

static void run_step(const shoal_tick_t* tick) {
  const int slot = (tick->step - 1) & 1;
  if (self.heard_step[slot] == tick->step - 1) {
    self.nav = self.heard[slot];
    self.has_nav = true;
  }
  self.step = tick->step;
  self.ended = tick->kind == SHOAL_TICK_T_END;
  if (!self.ended) {
    const shoal_actuators_t command = steer(tick->utime);
    sent_t* sent = &self.sent[tick->step & 1];
    sent->step = tick->step;
    const int size = shoal_actuators_t_encode(sent->bytes, 0, kMaxDatagram, &command);
    sent->size = append_seal(sent->bytes, (unsigned)size, tick->step, 0);
    lcm_publish(self.vehicle_bus, self.actuators_channel, sent->bytes, sent->size);
  }
  answer(tick->utime, tick->step, self.ended ? 0 : 1, "");
}

/* Runs the pending step if all is here; otherwise asks for what is missing when that is due. */
static void try_step(void) {
  const shoal_tick_t* tick = self.pending;
  bool complete = true;
  for (int i = 0; i < tick->num_totals; ++i) {
    const shoal_step_total_t* total = &tick->totals[i];
    if (strcmp(total->channel, self.nav_channel) != 0 || total->count == 0) continue;
    if (self.heard_step[(tick->step - 1) & 1] == tick->step - 1) continue;
    complete = false;
    if (now_ms() < self.next_repeat_ms) continue;
    ++self.missed;
    const shoal_resend_t request = {.utime = tick->utime,
                                    .mission_id = self.mission_id,
                                    .step = tick->step - 1,
                                    .requester = self.name,
                                    .publisher = total->publisher,
                                    .channel = total->channel};
    shoal_resend_t_publish(self.tick_bus, "RESEND", &request);
    self.next_repeat_ms = now_ms() + kRepeatInterval_ms;
    if (now_ms() > self.pending_since_ms + kGiveUpAfter_ms) {
      answer(tick->utime, tick->step, 0, "the NAV of the step before never reached it");
    }
  }
  if (!complete) return;
  run_step(tick);
  shoal_tick_t_destroy(self.pending);
  self.pending = NULL;
}

/* ---- what comes off the bus ---- */

static void on_tick(const lcm_recv_buf_t* datagram, const char* channel, const shoal_tick_t* tick,
                    void* unused) {
  (void)datagram, (void)channel, (void)unused;
  if (self.mission_id == 0) self.mission_id = tick->mission_id;
  if (tick->mission_id != self.mission_id) {
    ++self.foreign;
  } else if (tick->step == self.step) {
    send_done(); /* The clock did not hear the answer. */
  } else if (tick->step > self.step && (self.pending == NULL || tick->step > self.pending->step)) {
    if (self.pending != NULL) shoal_tick_t_destroy(self.pending);
    self.pending = shoal_tick_t_copy(tick);
    self.pending_since_ms = now_ms();
    self.next_repeat_ms = self.pending_since_ms + kRepeatInterval_ms;
  }
}

static void on_resend(const lcm_recv_buf_t* datagram, const char* channel,
                      const shoal_resend_t* request, void* unused) {
  (void)datagram, (void)channel, (void)unused;
  if (request->mission_id != self.mission_id || strcmp(request->publisher, self.name) != 0) return;
  for (int i = 0; i < 2; ++i) {
    const sent_t* sent = &self.sent[i];
    if (sent->step == request->step && strcmp(request->channel, self.actuators_channel) == 0) {
      lcm_publish(self.vehicle_bus, self.actuators_channel, sent->bytes, sent->size);
    }
  }
}

static void on_nav(const lcm_recv_buf_t* datagram, const char* channel, void* unused) {
  (void)channel, (void)unused;
  int64_t mission_id = 0, step = 0;
  shoal_nav_t nav;
  if (!read_seal(datagram, &mission_id, &step)) return;
  if (mission_id != self.mission_id) {
    ++self.foreign;
  } else if (shoal_nav_t_decode(datagram->data, 0, (int)datagram->data_size, &nav) < 0) {
    ++self.undecodable;
  } else if (step >= 0 && step >= self.step) {
    self.heard[step & 1] = nav;
    self.heard_step[step & 1] = step;
  }
}

static lcm_t* open_bus(int port) {
  char url[100];
  snprintf(url, sizeof url, "udpm://239.255.76.67:%d?ttl=0&recv_buf_size=200000", port);
  lcm_t* bus = lcm_create(url);
  if (bus == NULL) die(3, "cannot open %s; run `shoal doctor`", url);
  return bus;
}

static const char* environment(const char* name) {
  const char* value = getenv(name);
  if (value == NULL) die(2, "%s is not set; `shoal run missions/c_planner.toml` sets it", name);
  return value;
}

/* The shore's port, or in the layout `communities` the vehicle's own. */
static int port_of_vehicle(int port_base, const char* vehicle) {
  if (strcmp(environment("SHOAL_LAYOUT"), "communities") != 0) return port_base + 2;
  const char* name = environment("SHOAL_VEHICLES");
  for (int i = 0;; ++i) {
    const size_t size = strcspn(name, ",");
    if (size == strlen(vehicle) && strncasecmp(name, vehicle, size) == 0) {
      return port_base + 3 + i % kMaxCommunities;
    }
    if (name[size] == '\0') die(2, "no vehicle '%s' in this mission", vehicle);
    name += size + 1;
  }
}

static void name_channel(char* channel, size_t size, const char* topic, const char* vehicle) {
  snprintf(channel, size, "%s_%s", topic, vehicle);
  for (char* c = channel; *c != '\0'; ++c) *c = (char)toupper((unsigned char)*c);
}

static void read_command_line(int argc, char** argv) {
  if (argc < 3 || argc - 2 > kMaxWaypoints) die(2, "usage: c_planner VEHICLE X,Y [X,Y]...");
  for (int i = 2; i < argc; ++i) {
    double* point_m = self.waypoints_m[self.num_waypoints++];
    if (sscanf(argv[i], "%lf,%lf", &point_m[0], &point_m[1]) != 2) {
      die(2, "'%s' is not X,Y", argv[i]);
    }
  }
}

int main(int argc, char** argv) {
  read_command_line(argc, argv);
  setvbuf(stdout, NULL, _IOLBF, 0);
  const char* vehicle = argv[1];
  const int port_base = atoi(environment("SHOAL_PORT"));
  self.mission_id = strtoll(environment("SHOAL_MISSION_ID"), NULL, 10);
  snprintf(self.name, sizeof self.name, "%s", environment("SHOAL_PARTICIPANT"));
  name_channel(self.nav_channel, sizeof self.nav_channel, "NAV", vehicle);
  name_channel(self.actuators_channel, sizeof self.actuators_channel, "ACTUATORS", vehicle);
  self.step = self.sent[0].step = self.sent[1].step = self.heard_step[0] = self.heard_step[1] = -1;

  self.tick_bus = open_bus(port_base);
  self.done_bus = open_bus(port_base + 1);
  self.vehicle_bus = open_bus(port_of_vehicle(port_base, vehicle));
  shoal_tick_t_subscription_set_queue_capacity(
      shoal_tick_t_subscribe(self.tick_bus, "TICK", on_tick, NULL), 0);
  shoal_resend_t_subscription_set_queue_capacity(
      shoal_resend_t_subscribe(self.tick_bus, "RESEND", on_resend, NULL), 0);
  lcm_subscription_set_queue_capacity(
      lcm_subscribe(self.vehicle_bus, self.nav_channel, on_nav, NULL), 0);

  lcm_t* heard_buses[2] = {self.tick_bus, self.vehicle_bus};
  struct pollfd waiting[2] = {{.fd = lcm_get_fileno(self.tick_bus), .events = POLLIN},
                              {.fd = lcm_get_fileno(self.vehicle_bus), .events = POLLIN}};
  int64_t next_hello_ms = 0, last_news_ms = 0;
  while (!self.ended || now_ms() < last_news_ms + kLinger_ms) {
    if (self.step < 0 && self.pending == NULL && now_ms() >= next_hello_ms) {
      answer(0, -1, 0, ""); /* Hello. */
      next_hello_ms = now_ms() + kHelloInterval_ms;
    }
    if (poll(waiting, 2, (int)kRepeatInterval_ms) > 0) last_news_ms = now_ms();
    for (int i = 0; i < 2; ++i) {
      if (waiting[i].revents & POLLIN) lcm_handle(heard_buses[i]);
    }
    if (self.pending != NULL) try_step();
  }
  lcm_destroy(self.tick_bus);
  lcm_destroy(self.done_bus);
  lcm_destroy(self.vehicle_bus);
  return 0;
}
