/* Where a mission's channels live, by the variables that `shoal run` sets. For step_client.c. */
#ifndef SHOAL_EXAMPLES_STEP_BUSES_H
#define SHOAL_EXAMPLES_STEP_BUSES_H

#include <lcm/lcm.h>

enum { kMaxBuses = 131 }; /* Ticks, answers, the shore, and 128 communities. */

typedef struct {
  const char* program; /* Begins the lines that it prints. */
  int port_base;
  struct {
    int port;
    lcm_t* lcm;
  } items[kMaxBuses];
  int count;
} step_buses_t;

/* Prints why this program cannot go on, and ends it. */
void die(const step_buses_t* self, int exit_code, const char* format, ...);

/* Returns the value of a variable; ends the program where it is not set. */
const char* environment(const step_buses_t* self, const char* name);

/* Returns the bus at a port, which is opened where it was not; ends the program where that fails.
 */
lcm_t* bus_at(step_buses_t* self, int port);

/* Returns the shore's bus (NULL), or in the layout `communities` the vehicle's own. */
lcm_t* bus_of(step_buses_t* self, const char* vehicle);

#endif
