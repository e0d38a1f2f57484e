/* One end of an acoustic ping between two vehicles, in plain C and in step with the mission.
 *
 *   acoustic_ping VEHICLE PERIOD_S       PERIOD_S 0: it only answers
 *
 * Every PERIOD_S it sends "ping N" from VEHICLE on ACOUSTIC_TX; to each "ping N" that VEHICLE gets
 * on ACOUSTIC_RX_<VEHICLE> it answers "pong N". `shoal run missions/acoustic_ping.toml` starts two
 * of them.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shoal_acoustic_rx_t.h"
#include "shoal_acoustic_tx_t.h"
#include "step_client.h"

enum { kMaxText = 32 };

static struct {
  step_client_t* client;
  char* vehicle;
  int64_t period_us, next_ping_utime;
  int num_pings;
  char answer[kMaxText]; /* Empty: nothing to answer. */
} self;

static void send_text(int64_t utime, char* text) {
  const shoal_acoustic_tx_t packet = {.utime = utime,
                                      .source = self.vehicle,
                                      .num_bytes = (int32_t)strlen(text),
                                      .payload = (uint8_t*)text};
  uint8_t bytes[200];
  const int size = shoal_acoustic_tx_t_encode(bytes, 0, sizeof bytes, &packet);
  step_client_publish(self.client, "ACOUSTIC_TX", NULL, bytes, size);
}

static void on_packet(const char* channel, const uint8_t* data, int size, void* unused) {
  (void)channel, (void)unused;
  shoal_acoustic_rx_t packet;
  if (shoal_acoustic_rx_t_decode(data, 0, size, &packet) < 0) {
    step_client_count_undecodable(self.client);
    return;
  }
  char text[kMaxText] = ""; /* The payload is bytes: it has no 0 at its end. */
  if (packet.num_bytes < kMaxText) memcpy(text, packet.payload, (size_t)packet.num_bytes);
  printf("acoustic_ping: t=%.1f s: %s receives %s of %s, after %.2f s\n",
         (double)packet.utime / 1e6, self.vehicle, text, packet.source,
         (double)(packet.arrived_utime - packet.sent_utime) / 1e6);
  int number;
  if (sscanf(text, "ping %d", &number) == 1) {
    snprintf(self.answer, sizeof self.answer, "pong %d", number);
  }
  shoal_acoustic_rx_t_decode_cleanup(&packet);
}

static void think(int64_t utime, void* unused) {
  (void)unused;
  /* One packet per step at most: two packets of one step would collide with each other. */
  if (self.answer[0] != '\0') {
    send_text(utime, self.answer);
    self.answer[0] = '\0';
  } else if (self.period_us > 0 && utime >= self.next_ping_utime) {
    char text[kMaxText];
    snprintf(text, sizeof text, "ping %d", self.num_pings++);
    send_text(utime, text);
    self.next_ping_utime = utime + self.period_us;
  }
}

int main(int argc, char** argv) {
  if (argc != 3) {
    fprintf(stderr, "usage: acoustic_ping VEHICLE PERIOD_S, for example: acoustic_ping alpha 10\n");
    return 2;
  }
  self.vehicle = argv[1];
  self.period_us = (int64_t)(atof(argv[2]) * 1e6);
  self.next_ping_utime = self.period_us; /* A vehicle can send once it has reported. */
  setvbuf(stdout, NULL, _IOLBF, 0);
  self.client = step_client_create("acoustic_ping");
  step_client_subscribe(self.client, step_client_channel("ACOUSTIC_RX", self.vehicle), self.vehicle,
                        on_packet, NULL);
  return step_client_run(self.client, think, NULL);
}
