/* Sends acoustic bytes over a raw modem port: sends its words, and prints what it receives.
 *
 *   netsim_raw_modem 127.0.0.1 62001 hello      sends "hello", then receives
 *   netsim_raw_modem 127.0.0.1 62002            only receives
 */
#include <arpa/inet.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>

/* Each piece: two bytes of length, the most significant first, then the bytes. */
static int send_words(int modem, const char* words) {
  const size_t length = strlen(words);
  if (length == 0 || length > UINT16_MAX) return 0;
  const uint8_t head[2] = {(uint8_t)(length >> 8), (uint8_t)(length & 0xFF)};
  return send(modem, head, 2, MSG_NOSIGNAL) == 2 &&
         send(modem, words, length, MSG_NOSIGNAL) == (ssize_t)length;
}

int main(int argc, char** argv) {
  struct sockaddr_in address = {.sin_family = AF_INET};
  if (argc < 3 || inet_pton(AF_INET, argv[1], &address.sin_addr) != 1) {
    fprintf(stderr, "usage: netsim_raw_modem ADDRESS PORT [WORDS ...]\n");
    return 2;
  }
  address.sin_port = htons((uint16_t)atoi(argv[2]));
  const int modem = socket(AF_INET, SOCK_STREAM, 0);
  if (connect(modem, (const struct sockaddr*)&address, sizeof address) != 0) {
    perror("netsim_raw_modem: is the mission running, and this its modem port? connect");
    return 3;
  }
  setvbuf(stdout, NULL, _IOLBF, 0);
  for (int i = 3; i < argc; ++i) {
    if (!send_words(modem, argv[i])) return 3;
  }
  static uint8_t received[UINT16_MAX];
  uint8_t head[2];
  while (recv(modem, head, 2, MSG_WAITALL) == 2) {
    const size_t length = (size_t)(head[0] << 8 | head[1]);
    if (recv(modem, received, length, MSG_WAITALL) != (ssize_t)length) break;
    printf("received %zu bytes: %.*s\n", length, (int)length, (const char*)received);
  }
  return 0;
}
