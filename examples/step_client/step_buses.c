#include "step_buses.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

void die(const step_buses_t* self, int exit_code, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  fprintf(stderr, "%s: ", self->program);
  vfprintf(stderr, format, arguments);
  fprintf(stderr, "\n");
  va_end(arguments);
  exit(exit_code);
}

const char* environment(const step_buses_t* self, const char* name) {
  const char* value = getenv(name);
  if (value == NULL) die(self, 2, "%s is not set; `shoal run` sets it", name);
  return value;
}

static int port_of(const step_buses_t* self, const char* vehicle) {
  const int shore_port = self->port_base + 2;
  if (vehicle == NULL || strcmp(environment(self, "SHOAL_LAYOUT"), "communities") != 0) {
    return shore_port;
  }
  const char* name = environment(self, "SHOAL_VEHICLES");
  for (int i = 0;; ++i) {
    const size_t size = strcspn(name, ",");
    if (size == strlen(vehicle) && strncasecmp(name, vehicle, size) == 0) {
      return shore_port + 1 + i % 128;
    }
    if (name[size] == '\0') die(self, 2, "no vehicle '%s' in this mission", vehicle);
    name += size + 1;
  }
}

lcm_t* bus_at(step_buses_t* self, int port) {
  for (int i = 0; i < self->count; ++i) {
    if (self->items[i].port == port) return self->items[i].lcm;
  }
  char url[100];
  snprintf(url, sizeof url, "udpm://239.255.76.67:%d?ttl=0&recv_buf_size=200000", port);
  lcm_t* lcm = self->count < kMaxBuses ? lcm_create(url) : NULL;
  if (lcm == NULL) die(self, 3, "cannot open %s; run `shoal doctor`", url);
  self->items[self->count].port = port;
  self->items[self->count++].lcm = lcm;
  return lcm;
}

lcm_t* bus_of(step_buses_t* self, const char* vehicle) {
  return bus_at(self, port_of(self, vehicle));
}
