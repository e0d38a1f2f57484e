/* A vehicle simulator from outside of shoal, in plain C and with nothing but sockets: reports over
 * netsim's interface where its vehicle is, and pings others through a raw modem.
 *
 *   netsim_outsider [ADDRESS [PORT [MODEM_PORT]]]      default: 127.0.0.1 61999 62000
 *
 * It waits a minute for the servers and ends when they close. `shoal run missions/netsim_hil.toml`
 * is the mission that it plays in.
 */
#include <arpa/inet.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

static double now_s(void) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int connect_to(const char* address, int port) {
  struct sockaddr_in to = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
  if (inet_pton(AF_INET, address, &to.sin_addr) != 1) return -1;
  for (double give_up = now_s() + 60; now_s() < give_up; usleep(100 * 1000)) {
    const int s = socket(AF_INET, SOCK_STREAM, 0);
    if (connect(s, (struct sockaddr*)&to, sizeof to) == 0) return s;
    close(s);
  }
  return -1;
}

/* Protobuf by hand: a key is 8 * field + type; integers are varints, doubles eight bytes. */
typedef struct {
  uint8_t bytes[200];
  size_t size;
} message_t;

static void put_varint(message_t* message, uint64_t value) {
  for (; value >= 0x80; value >>= 7) message->bytes[message->size++] = (uint8_t)(value | 0x80);
  message->bytes[message->size++] = (uint8_t)value;
}

static void put_int(message_t* message, int field, uint64_t value) {
  put_varint(message, (uint64_t)field << 3);
  put_varint(message, value);
}

static void put_double(message_t* message, int field, double value) {
  put_varint(message, (uint64_t)field << 3 | 1);
  memcpy(message->bytes + message->size, &value, 8); /* Little-endian, as this machine is. */
  message->size += 8;
}

static void send_base64_line(int s, const message_t* message) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  char line[400] = "NETSIM|netsim.protobuf.NetSimManagerRequest|";
  size_t n = strlen(line);
  for (size_t i = 0; i < message->size; i += 3) {
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < message->size ? message->bytes[i + k] : 0);
    }
    for (size_t k = 0; k < 4; ++k) {
      line[n++] = i + k > message->size ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
  }
  line[n++] = '\n';
  if (send(s, line, n, MSG_NOSIGNAL) < 0) perror("position");
}

/* NetSimManagerRequest{id = 1, nav = 2: NavUpdate{port = 1, time, lat, lon, depth, speed,
 * heading}}. */
static void send_position(int s, int id, int modem_port) {
  message_t nav = {.size = 0};
  put_int(&nav, 1, (uint64_t)modem_port);
  put_double(&nav, 2, now_s());
  put_double(&nav, 3, 43.8253);
  put_double(&nav, 4, -70.3117 + 1e-6 * id); /* It drifts East, 0.16 m/s. */
  put_double(&nav, 5, 12);
  put_double(&nav, 6, 0.16);
  put_double(&nav, 7, 90);
  message_t request = {.size = 0};
  put_int(&request, 1, (uint64_t)id);
  put_varint(&request, 2 << 3 | 2);
  put_varint(&request, nav.size);
  memcpy(request.bytes + request.size, nav.bytes, nav.size);
  request.size += nav.size;
  send_base64_line(s, &request);
}

static void send_ping(int modem, int number) {
  char text[32];
  const int n = snprintf(text + 2, sizeof text - 2, "ping %d", number);
  text[0] = 0; /* The length comes first, its high byte before the low one. */
  text[1] = (char)n;
  if (send(modem, text, (size_t)n + 2, MSG_NOSIGNAL) < 0) perror("ping");
}

int main(int argc, char** argv) {
  const char* address = argc > 1 ? argv[1] : "127.0.0.1";
  const int port = argc > 2 ? atoi(argv[2]) : 61999;
  const int modem_port = argc > 3 ? atoi(argv[3]) : 62000;
  setvbuf(stdout, NULL, _IOLBF, 0);
  const int manager = connect_to(address, port);
  const int modem = connect_to(address, modem_port);
  if (manager < 0 || modem < 0) {
    fprintf(stderr, "no connection to %s ports %d and %d; is the mission running?\n", address, port,
            modem_port);
    return 1;
  }
  printf("netsim_outsider: connected\n");
  double next_position = now_s();
  double next_ping = now_s() + 3; /* Packets need a position first. */
  double pinged = 0;
  int num_positions = 0, num_pings = 0;
  for (;;) {
    if (now_s() >= next_position) {
      send_position(manager, num_positions++, modem_port);
      next_position += 0.5;
    }
    if (now_s() >= next_ping) {
      pinged = now_s();
      send_ping(modem, num_pings++);
      next_ping += 5;
    }
    struct pollfd fds[] = {{.fd = manager, .events = POLLIN}, {.fd = modem, .events = POLLIN}};
    poll(fds, 2, 50);
    char text[1000];
    if (fds[0].revents != 0) {
      const ssize_t n = recv(manager, text, sizeof text - 1, 0);
      if (n <= 0) break; /* The mission has ended. */
      text[n] = '\0';
      /* The status is the last varint: 1 is accepted, and "EAE=" or "AQ==" in base64. */
      if (num_positions <= 3) printf("netsim_outsider: answered %s", text);
    }
    if (fds[1].revents != 0) {
      const ssize_t n = recv(modem, text, sizeof text - 1, 0);
      if (n <= 0) break;
      if (n > 2) {
        printf("netsim_outsider: received %.*s after %.1f s\n", (int)n - 2, text + 2,
               now_s() - pinged);
      }
    }
  }
  printf("netsim_outsider: the other side has closed\n");
  return 0;
}
