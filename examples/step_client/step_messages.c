#define _POSIX_C_SOURCE 200809L
#include "step_messages.h"

#include <stdlib.h>
#include <string.h>

static const uint64_t kMagic = 0x53484f4c; /* "SHOL" */

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

unsigned append_seal(uint8_t* message, unsigned size, const char* publisher, int64_t mission_id,
                     int64_t step, uint32_t sequence) {
  const size_t name_size = strlen(publisher);
  uint8_t* at = message + size;
  memcpy(at, publisher, name_size);
  at = put(at + name_size, name_size, 1);
  at = put(at, (uint64_t)mission_id, 8);
  at = put(at, (uint64_t)step, 8);
  at = put(at, sequence, 4);
  at = put(at, kMagic, 4);
  return (unsigned)(at - message);
}

bool read_seal(message_t* message, int64_t* mission_id) {
  if (message->size < kSealSize) return false;
  const uint8_t* seal = message->data + message->size - kSealSize;
  const size_t name_size = seal[0];
  if (get(seal + 21, 4) != kMagic || name_size == 0 || message->size < kSealSize + name_size) {
    return false;
  }
  message->publisher = strndup((const char*)seal - name_size, name_size);
  if (message->publisher == NULL) abort();
  *mission_id = (int64_t)get(seal + 1, 8);
  message->step = (int64_t)get(seal + 9, 8);
  message->sequence = (uint32_t)get(seal + 17, 4);
  message->size -= (unsigned)(kSealSize + name_size);
  return true;
}
