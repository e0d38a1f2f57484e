/* What a step_client keeps of a mission's messages, and the seal behind each. For step_client.c. */
#ifndef SHOAL_EXAMPLES_STEP_MESSAGES_H
#define SHOAL_EXAMPLES_STEP_MESSAGES_H

#include <lcm/lcm.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
  kSecretSize = 32,
  kTagSize = 16,
  kSealSize = 41, /* Without the publisher's name. */
};

/* A message that came, or one that was sent: then `data` has its seal. */
typedef struct {
  const char* channel; /* Not owned. */
  char* publisher;     /* NULL: from outside the step protocol, or our own. */
  int64_t step;
  uint32_t sequence;
  uint8_t* data;
  unsigned size;
  lcm_t* bus; /* On which it was sent. */
} message_t;

typedef struct {
  message_t* items;
  size_t count, capacity;
} messages_t;

/* Returns zeroed memory; where there is none, the process ends. */
void* allocate(size_t size);

message_t* add_message(messages_t* list);

/* Returns true where a message of the same publisher, step and sequence is there already. */
bool holds_message(const messages_t* list, const message_t* message);

/* Returns how many messages a publisher's channel has of a step. */
int count_messages(const messages_t* list, const char* channel, const char* publisher,
                   int64_t step);

/* Removes the messages of steps before `step`. */
void forget_before(messages_t* list, int64_t step);

/* Compares for qsort: channel, then messages from outside, then publisher, then sequence. */
int in_fixed_order(const void* left, const void* right);

/* Reads the mission's secret: from the descriptor that SHOAL_SECRET_FD numbers, or the file that
 * SHOAL_SECRET_FILE names. Returns false where neither has it. */
bool read_secret(uint8_t secret[kSecretSize]);

/* Appends publisher, length of that name, mission id, step, sequence, the tag, "SHO2"; returns the
 * size with them. */
unsigned append_seal(uint8_t* message, unsigned size, const char* publisher, int64_t mission_id,
                     int64_t step, uint32_t sequence, const uint8_t secret[kSecretSize],
                     const char* channel);

/* Fills publisher, step, sequence and the size without the seal; `is_genuine`: it was made with
 * `secret`, for the message's channel. Returns false, with all as it was, for a message from
 * outside the step protocol. */
bool read_seal(message_t* message, int64_t* mission_id, const uint8_t secret[kSecretSize],
               bool* is_genuine);

#endif
