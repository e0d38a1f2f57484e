#define _POSIX_C_SOURCE 200809L
#include "step_client.h"

#include <ctype.h>
#include <lcm/lcm.h>
#include <poll.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "shoal_resend_t.h"
#include "shoal_step_done_t.h"
#include "shoal_tick_t.h"
#include "step_buses.h"
#include "step_messages.h"

enum {
  kMaxChannels = 64,   /* To subscribe to, and to publish on. */
  kMaxOutside = 10000, /* Messages from outside the protocol in one step; more are dropped. */
};

static const int64_t kHelloInterval_ms = 200;
static const int64_t kRepeatInterval_ms = 50;
static const int64_t kGiveUpAfter_ms = 3000;
static const int64_t kLinger_ms = 300; /* After END: the clock may not have received the answer. */
typedef struct {
  const char* channel;
  step_client_message_fn on_message;
  void* user;
} subscription_t;

struct step_client {
  step_buses_t buses;
  char* name;
  int64_t mission_id;
  uint8_t secret[kSecretSize]; /* Of the mission. */

  char* names[2 * kMaxChannels]; /* Of all channels. */
  int num_names;
  subscription_t subscriptions[kMaxChannels];
  int num_subscriptions;

  int64_t step; /* The last one answered; -1: none. */
  bool in_step, ended;
  uint32_t sequence;
  shoal_step_done_t done; /* The last answer, to be given again. */
  shoal_step_count_t published[kMaxChannels];
  messages_t sent;    /* In this step and the last one. */
  messages_t waiting; /* Came, but their step has not been taken. */

  shoal_tick_t* pending; /* The tick whose messages are not all here yet. */
  int64_t pending_since_ms, next_repeat_ms;
  int64_t repeated, foreign, undecodable, outside, refused;
  uint32_t num_outside; /* Of these, the ones that wait. */

  step_client_think_fn think;
  void* user;
};

static int64_t now_ms(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

/* Returns the channel's name in memory that lasts. */
static const char* lasting_name(step_client_t* self, const char* channel) {
  for (int i = 0; i < self->num_names; ++i) {
    if (strcmp(self->names[i], channel) == 0) return self->names[i];
  }
  if (self->num_names == 2 * kMaxChannels) die(&self->buses, 2, "too many channels");
  self->names[self->num_names] = strdup(channel);
  return self->names[self->num_names++];
}

/* ---- one step: take the messages of the step before, think, publish, answer ---- */

/* Seals `data` in place, which has room for it, and publishes it. */
static void publish_sealed(step_client_t* self, int port, const char* channel, uint8_t* data,
                           int size, int64_t step) {
  const unsigned sealed = append_seal(data, (unsigned)size, self->name, self->mission_id, step, 0,
                                      self->secret, channel);
  lcm_publish(bus_at(&self->buses, port), channel, data, sealed);
}

static void send_done(step_client_t* self) {
  const int size = shoal_step_done_t_encoded_size(&self->done);
  uint8_t* data = allocate((size_t)size + strlen(self->name) + kSealSize);
  shoal_step_done_t_encode(data, 0, size, &self->done);
  publish_sealed(self, self->buses.port_base + 1, "STEP_DONE", data, size, self->done.step);
  free(data);
}

static void send_resend(step_client_t* self, const shoal_resend_t* request) {
  const int size = shoal_resend_t_encoded_size(request);
  uint8_t* data = allocate((size_t)size + strlen(self->name) + kSealSize);
  shoal_resend_t_encode(data, 0, size, request);
  publish_sealed(self, self->buses.port_base, "RESEND", data, size, request->step);
  free(data);
}

/* A participant waits until the clock waits for the answers of this very process. */
static int takes_part(const step_client_t* self, const shoal_tick_t* tick) {
  if (self->step >= 0 || self->pending != NULL) return 1;
  if (tick->kind == SHOAL_TICK_T_END) return 1;
  for (int i = 0; i < tick->num_joined; ++i) {
    if (strcmp(tick->joined[i], self->name) == 0 && tick->joined_pids[i] == (int32_t)getpid()) {
      return 1;
    }
  }
  return 0;
}

/* Answers a tick; step -1 is the hello before the first. */
static void answer(step_client_t* self, int64_t utime, int64_t step, char* fault) {
  self->done.utime = utime;
  self->done.mission_id = self->mission_id;
  self->done.step = step;
  self->done.participant = self->name;
  self->done.pid = (int32_t)getpid();
  self->done.repeated = self->repeated;
  self->done.outside = self->outside;
  self->done.foreign = self->foreign;
  self->done.undecodable = self->undecodable;
  self->done.refused = self->refused;
  self->done.fault = fault;
  self->done.published = self->published;
  send_done(self);
}

static const shoal_step_total_t* find_total(const shoal_tick_t* tick, const message_t* message) {
  for (int i = 0; i < tick->num_totals; ++i) {
    const shoal_step_total_t* total = &tick->totals[i];
    if (strcmp(total->channel, message->channel) == 0 &&
        strcmp(total->publisher, message->publisher) == 0) {
      return total;
    }
  }
  return NULL;
}

static void handle(const step_client_t* self, const message_t* message) {
  for (int i = 0; i < self->num_subscriptions; ++i) {
    const subscription_t* each = &self->subscriptions[i];
    if (strcmp(each->channel, message->channel) != 0) continue;
    each->on_message(message->channel, message->data, (int)message->size, each->user);
  }
}

static void run_step(step_client_t* self, const shoal_tick_t* tick) {
  if (self->waiting.count > 0) {
    qsort(self->waiting.items, self->waiting.count, sizeof *self->waiting.items, in_fixed_order);
  }
  for (size_t i = 0; i < self->waiting.count; ++i) {
    message_t* message = &self->waiting.items[i];
    const bool is_from_outside = message->publisher == NULL;
    if (is_from_outside) message->step = tick->step - 1; /* Of the step in which it arrived. */
    /* What no total announces was published by a participant that was lost. */
    const bool counts = is_from_outside || find_total(tick, message) != NULL;
    if (message->step == tick->step - 1 && counts) handle(self, message);
  }
  forget_before(&self->waiting, tick->step);
  self->num_outside = 0;
  self->step = tick->step;
  self->sequence = 0;
  self->done.num_published = 0;
  forget_before(&self->sent, tick->step - 1);
  self->ended = tick->kind == SHOAL_TICK_T_END;
  self->in_step = true;
  if (!self->ended) self->think(tick->utime, self->user);
  self->in_step = false;
  answer(self, tick->utime, tick->step, "");
}

static bool subscribes(const step_client_t* self, const char* channel) {
  for (int i = 0; i < self->num_subscriptions; ++i) {
    if (strcmp(self->subscriptions[i].channel, channel) == 0) return true;
  }
  return false;
}

/* Runs the pending step if all is here; otherwise asks for what is missing when that is due. */
static void try_step(step_client_t* self) {
  shoal_tick_t* tick = self->pending;
  const bool is_due = now_ms() >= self->next_repeat_ms;
  bool complete = true;
  for (int i = 0; i < tick->num_totals; ++i) {
    const shoal_step_total_t* total = &tick->totals[i];
    if (!subscribes(self, total->channel)) continue;
    if (count_messages(&self->waiting, total->channel, total->publisher, tick->step - 1) >=
        total->count)
      continue;
    complete = false;
    if (!is_due) continue;
    ++self->repeated;
    const shoal_resend_t request = {.utime = tick->utime,
                                    .mission_id = self->mission_id,
                                    .step = tick->step - 1,
                                    .requester = self->name,
                                    .publisher = total->publisher,
                                    .channel = total->channel};
    send_resend(self, &request);
  }
  if (complete) {
    self->pending = NULL;
    run_step(self, tick);
    shoal_tick_t_destroy(tick);
  } else if (is_due) {
    self->next_repeat_ms = now_ms() + kRepeatInterval_ms;
    if (now_ms() > self->pending_since_ms + kGiveUpAfter_ms) {
      self->done.num_published = 0;
      answer(self, tick->utime, tick->step, "messages of the step before never reached it");
    }
  }
}

/* ---- what comes off the bus ---- */

/* Takes the seal off a message of the step protocol itself. Returns the size of the message within
 * `datagram`; -1: refused, and counted. */
static int open_sealed(step_client_t* self, const lcm_recv_buf_t* datagram, const char* channel) {
  message_t message = {.channel = channel, .data = datagram->data, .size = datagram->data_size};
  int64_t mission_id = 0;
  bool is_genuine = false;
  const bool is_sealed = read_seal(&message, &mission_id, self->secret, &is_genuine);
  free(message.publisher);
  if (is_sealed && self->mission_id != 0 && mission_id != self->mission_id) {
    ++self->foreign;
  } else if (!is_genuine) {
    ++self->refused;
  } else {
    return (int)message.size;
  }
  return -1;
}

static void handle_tick(step_client_t* self, const shoal_tick_t* tick) {
  if (self->mission_id == 0) self->mission_id = tick->mission_id;
  if (tick->step == self->step) {
    send_done(self); /* The clock did not receive the answer. */
  } else if (tick->step > self->step && !self->ended && takes_part(self, tick) &&
             (self->pending == NULL || tick->step > self->pending->step)) {
    if (self->pending != NULL) shoal_tick_t_destroy(self->pending);
    self->pending = shoal_tick_t_copy(tick);
    for (int i = 0; self->step < 0 && i < tick->num_totals; ++i) {
      /* What a process of this name published before is gone with it. */
      shoal_step_total_t* total = &self->pending->totals[i];
      if (strcmp(total->publisher, self->name) == 0) total->count = 0;
    }
    self->pending_since_ms = now_ms();
    self->next_repeat_ms = self->pending_since_ms + kRepeatInterval_ms;
  }
}

static void handle_resend(const step_client_t* self, const shoal_resend_t* request) {
  if (request->mission_id != self->mission_id || strcmp(request->publisher, self->name) != 0) {
    return;
  }
  for (size_t i = 0; i < self->sent.count; ++i) {
    const message_t* sent = &self->sent.items[i];
    if (sent->step != request->step || strcmp(request->channel, sent->channel) != 0) continue;
    lcm_publish(sent->bus, sent->channel, sent->data, sent->size);
  }
}

static void on_tick(const lcm_recv_buf_t* datagram, const char* channel, void* user) {
  step_client_t* self = user;
  const int size = open_sealed(self, datagram, channel);
  shoal_tick_t tick;
  if (size < 0) return;
  if (shoal_tick_t_decode(datagram->data, 0, size, &tick) < 0) {
    ++self->undecodable;
    return;
  }
  handle_tick(self, &tick);
  shoal_tick_t_decode_cleanup(&tick);
}

static void on_resend(const lcm_recv_buf_t* datagram, const char* channel, void* user) {
  step_client_t* self = user;
  const int size = open_sealed(self, datagram, channel);
  shoal_resend_t request;
  if (size < 0) return;
  if (shoal_resend_t_decode(datagram->data, 0, size, &request) < 0) {
    ++self->undecodable;
    return;
  }
  handle_resend(self, &request);
  shoal_resend_t_decode_cleanup(&request);
}

static void on_datagram(const lcm_recv_buf_t* datagram, const char* channel, void* user) {
  step_client_t* self = user;
  message_t message = {0};
  message.channel = lasting_name(self, channel);
  message.size = datagram->data_size;
  message.data = allocate(message.size);
  memcpy(message.data, datagram->data, message.size);
  int64_t mission_id = self->mission_id;
  bool is_wanted = true, is_genuine = false;
  if (read_seal(&message, &mission_id, self->secret, &is_genuine)) {
    if (mission_id != self->mission_id) {
      ++self->foreign;
    } else if (!is_genuine) {
      ++self->refused;
    }
    is_wanted = mission_id == self->mission_id && is_genuine && message.step >= self->step &&
                (self->step < 0 || message.step <= self->step + 2) &&
                !holds_message(&self->waiting, &message);
  } else {
    /* What outside programs published before the first tick belongs before the mission. */
    is_wanted =
        (self->step >= 0 || self->pending != NULL) && self->num_outside < (uint32_t)kMaxOutside;
    message.step = INT64_MAX;
    if (is_wanted) ++self->outside, message.sequence = self->num_outside++;
  }
  if (is_wanted) {
    *add_message(&self->waiting) = message;
  } else {
    free(message.publisher);
    free(message.data);
  }
}

/* ---- what a program calls ---- */

step_client_t* step_client_create(const char* program) {
  step_client_t* self = allocate(sizeof *self);
  self->buses.program = program;
  self->buses.port_base = atoi(environment(&self->buses, "SHOAL_PORT"));
  self->mission_id = strtoll(environment(&self->buses, "SHOAL_MISSION_ID"), NULL, 10);
  self->name = strdup(environment(&self->buses, "SHOAL_PARTICIPANT"));
  self->step = -1;
  if (!read_secret(self->secret)) {
    die(&self->buses, 3,
        "no secret of the mission: neither SHOAL_SECRET_FD nor SHOAL_SECRET_FILE leads to it; "
        "`shoal run` sets both");
  }
  lcm_t* ticks = bus_at(&self->buses, self->buses.port_base);
  bus_at(&self->buses, self->buses.port_base + 1);
  lcm_subscription_set_queue_capacity(lcm_subscribe(ticks, "TICK", on_tick, self), 0);
  lcm_subscription_set_queue_capacity(lcm_subscribe(ticks, "RESEND", on_resend, self), 0);
  return self;
}

void step_client_subscribe(step_client_t* self, const char* channel, const char* vehicle,
                           step_client_message_fn on_message, void* user) {
  if (self->num_subscriptions == kMaxChannels) die(&self->buses, 2, "too many channels subscribed");
  if (!subscribes(self, channel)) {
    lcm_subscription_set_queue_capacity(
        lcm_subscribe(bus_of(&self->buses, vehicle), channel, on_datagram, self), 0);
  }
  subscription_t* added = &self->subscriptions[self->num_subscriptions++];
  added->channel = lasting_name(self, channel);
  added->on_message = on_message;
  added->user = user;
}

void step_client_publish(step_client_t* self, const char* channel, const char* vehicle,
                         const uint8_t* data, int size) {
  if (!self->in_step)
    die(&self->buses, 2, "%s: messages are published within a step only", channel);
  shoal_step_count_t* count = NULL;
  for (int i = 0; i < self->done.num_published; ++i) {
    if (strcmp(self->published[i].channel, channel) == 0) count = &self->published[i];
  }
  if (count == NULL) {
    if (self->done.num_published == kMaxChannels)
      die(&self->buses, 2, "too many channels published");
    count = &self->published[self->done.num_published++];
    count->channel = (char*)lasting_name(self, channel);
    count->count = 0;
  }
  ++count->count;
  message_t* sent = add_message(&self->sent);
  sent->data = allocate((size_t)size + strlen(self->name) + kSealSize);
  memcpy(sent->data, data, (size_t)size);
  sent->size = append_seal(sent->data, (unsigned)size, self->name, self->mission_id, self->step,
                           self->sequence++, self->secret, channel);
  sent->step = self->step;
  sent->channel = count->channel;
  sent->bus = bus_of(&self->buses, vehicle);
  lcm_publish(sent->bus, channel, sent->data, sent->size);
}

void step_client_count_undecodable(step_client_t* self) { ++self->undecodable; }

int step_client_run(step_client_t* self, step_client_think_fn think, void* user) {
  self->think = think;
  self->user = user;
  int64_t next_hello_ms = 0, last_news_ms = 0;
  while (!self->ended || now_ms() < last_news_ms + kLinger_ms) {
    if (self->step < 0 && self->pending == NULL && now_ms() >= next_hello_ms) {
      answer(self, 0, -1, ""); /* Hello. */
      next_hello_ms = now_ms() + kHelloInterval_ms;
    }
    struct pollfd waiting[kMaxBuses];
    for (int i = 0; i < self->buses.count; ++i) {
      waiting[i] =
          (struct pollfd){.fd = lcm_get_fileno(self->buses.items[i].lcm), .events = POLLIN};
    }
    const int num_buses = self->buses.count;
    if (poll(waiting, (nfds_t)num_buses, (int)kRepeatInterval_ms) > 0) last_news_ms = now_ms();
    for (int i = 0; i < num_buses; ++i) {
      if (waiting[i].revents & POLLIN) lcm_handle(self->buses.items[i].lcm);
    }
    if (self->pending != NULL) try_step(self);
  }
  for (int i = 0; i < self->buses.count; ++i) lcm_destroy(self->buses.items[i].lcm);
  return 0; /* The system takes the memory back. */
}

char* step_client_channel(const char* topic, const char* vehicle) {
  char* channel = allocate(strlen(topic) + strlen(vehicle) + 2);
  sprintf(channel, "%s_%s", topic, vehicle);
  for (char* c = channel; *c != '\0'; ++c) *c = (char)toupper((unsigned char)*c);
  return channel;
}
