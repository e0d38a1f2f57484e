#define _POSIX_C_SOURCE 200809L
#include "step_messages.h"

#include <fcntl.h>
#include <sodium.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const uint64_t kMagic = 0x53484f32; /* "SHO2" */
enum { kNumbersSize = 1 + 8 + 8 + 4, kMagicSize = 4 };

void* allocate(size_t size) {
  void* memory = calloc(1, size == 0 ? 1 : size);
  if (memory == NULL) abort();
  return memory;
}

message_t* add_message(messages_t* list) {
  if (list->count == list->capacity) {
    list->capacity = list->capacity == 0 ? 16 : 2 * list->capacity;
    list->items = realloc(list->items, list->capacity * sizeof *list->items);
    if (list->items == NULL) abort();
  }
  memset(&list->items[list->count], 0, sizeof *list->items);
  return &list->items[list->count++];
}

bool holds_message(const messages_t* list, const message_t* message) {
  for (size_t i = 0; i < list->count; ++i) {
    const message_t* each = &list->items[i];
    if (each->publisher != NULL && each->step == message->step &&
        each->sequence == message->sequence && strcmp(each->publisher, message->publisher) == 0) {
      return true;
    }
  }
  return false;
}

int count_messages(const messages_t* list, const char* channel, const char* publisher,
                   int64_t step) {
  int count = 0;
  for (size_t i = 0; i < list->count; ++i) {
    const message_t* each = &list->items[i];
    if (each->publisher != NULL && each->step == step && strcmp(each->channel, channel) == 0 &&
        strcmp(each->publisher, publisher) == 0) {
      ++count;
    }
  }
  return count;
}

void forget_before(messages_t* list, int64_t step) {
  size_t kept = 0;
  for (size_t i = 0; i < list->count; ++i) {
    if (list->items[i].step >= step) {
      list->items[kept++] = list->items[i];
    } else {
      free(list->items[i].publisher);
      free(list->items[i].data);
    }
  }
  list->count = kept;
}

int in_fixed_order(const void* left, const void* right) {
  const message_t *a = left, *b = right;
  const int channel = strcmp(a->channel, b->channel);
  if (channel != 0) return channel;
  if ((a->publisher == NULL) != (b->publisher == NULL)) return a->publisher == NULL ? -1 : 1;
  const int publisher = a->publisher == NULL ? 0 : strcmp(a->publisher, b->publisher);
  if (publisher != 0) return publisher;
  return (a->sequence > b->sequence) - (a->sequence < b->sequence);
}

static uint8_t* put(uint8_t* at, uint64_t value, int num_bytes) {
  for (int shift = 8 * (num_bytes - 1); shift >= 0; shift -= 8) *at++ = (uint8_t)(value >> shift);
  return at;
}

static uint64_t get(const uint8_t* at, int num_bytes) {
  uint64_t value = 0;
  for (int i = 0; i < num_bytes; ++i) value = value << 8 | at[i];
  return value;
}

static void tag_of(uint8_t tag[kTagSize], const uint8_t* tagged, size_t size,
                   const uint8_t secret[kSecretSize], const char* channel) {
  crypto_generichash_state state; /* BLAKE2b */
  crypto_generichash_init(&state, secret, kSecretSize, kTagSize);
  crypto_generichash_update(&state, (const uint8_t*)channel, strlen(channel) + 1);
  crypto_generichash_update(&state, tagged, size);
  crypto_generichash_final(&state, tag, kTagSize);
}

/* Reads 64 hexadecimal digits and a line break. */
static bool read_digits(int descriptor, uint8_t secret[kSecretSize]) {
  char text[2 * kSecretSize + 1];
  size_t size = 0;
  return pread(descriptor, text, sizeof text, 0) == (ssize_t)sizeof text &&
         sodium_hex2bin(secret, kSecretSize, text, 2 * kSecretSize, NULL, &size, NULL) == 0 &&
         size == kSecretSize;
}

bool read_secret(uint8_t secret[kSecretSize]) {
  const char* number = getenv("SHOAL_SECRET_FD");
  if (number != NULL && read_digits(atoi(number), secret)) return true;
  const char* path = getenv("SHOAL_SECRET_FILE");
  const int opened = path == NULL ? -1 : open(path, O_RDONLY);
  if (opened < 0) return false;
  const bool is_read = read_digits(opened, secret);
  close(opened);
  return is_read;
}

unsigned append_seal(uint8_t* message, unsigned size, const char* publisher, int64_t mission_id,
                     int64_t step, uint32_t sequence, const uint8_t secret[kSecretSize],
                     const char* channel) {
  const size_t name_size = strlen(publisher);
  uint8_t* at = message + size;
  memcpy(at, publisher, name_size);
  at = put(at + name_size, name_size, 1);
  at = put(at, (uint64_t)mission_id, 8);
  at = put(at, (uint64_t)step, 8);
  at = put(at, sequence, 4);
  tag_of(at, message, (size_t)(at - message), secret, channel);
  at = put(at + kTagSize, kMagic, kMagicSize);
  return (unsigned)(at - message);
}

bool read_seal(message_t* message, int64_t* mission_id, const uint8_t secret[kSecretSize],
               bool* is_genuine) {
  if (message->size < kSealSize) return false;
  const uint8_t* end = message->data + message->size;
  const uint8_t* tag = end - kMagicSize - kTagSize;
  const uint8_t* numbers = tag - kNumbersSize;
  const size_t name_size = numbers[0];
  if (get(end - kMagicSize, kMagicSize) != kMagic || name_size == 0 ||
      message->size < kSealSize + name_size) {
    return false;
  }
  uint8_t expected[kTagSize];
  tag_of(expected, message->data, (size_t)(tag - message->data), secret, message->channel);
  *is_genuine = sodium_memcmp(expected, tag, kTagSize) == 0;
  message->publisher = strndup((const char*)numbers - name_size, name_size);
  if (message->publisher == NULL) abort();
  *mission_id = (int64_t)get(numbers + 1, 8);
  message->step = (int64_t)get(numbers + 9, 8);
  message->sequence = (uint32_t)get(numbers + 17, 4);
  message->size -= (unsigned)(kSealSize + name_size);
  return true;
}
