/* Takes part in the stepping of a mission, in plain C: LCM and shoal's message types are all that
 * it needs. docs/extending/step_protocol.md has the rules; this is all of them.
 *
 *   step_client_t* client = step_client_create("my_program");     reads the SHOAL_* variables
 *   step_client_subscribe(client, "NAV_ALPHA", "alpha", on_nav, NULL);
 *   return step_client_run(client, think, NULL);                  think() calls
 * step_client_publish()
 *
 * Trouble with the environment ends the process: 2 for a variable that is missing, 3 for LCM.
 */
#ifndef SHOAL_EXAMPLES_STEP_CLIENT_H
#define SHOAL_EXAMPLES_STEP_CLIENT_H

#include <stdint.h>

typedef struct step_client step_client_t;

/* Called for each message of the step before, in the fixed order. `data` holds the LCM message. */
typedef void (*step_client_message_fn)(const char* channel, const uint8_t* data, int size,
                                       void* user);
/* Called once per step, after its messages. Others receive in the next what is published here. */
typedef void (*step_client_think_fn)(int64_t utime, void* user);

/* `program` begins the lines that it prints. */
step_client_t* step_client_create(const char* program);

/* Subscribes to a channel that lives in the community of `vehicle`, or at the shore where that is
 * NULL. To be called before step_client_run. */
void step_client_subscribe(step_client_t* client, const char* channel, const char* vehicle,
                           step_client_message_fn on_message, void* user);

/* Publishes an encoded LCM message. Only from within a step. */
void step_client_publish(step_client_t* client, const char* channel, const char* vehicle,
                         const uint8_t* data, int size);

/* Counts a message that did not decode. */
void step_client_count_undecodable(step_client_t* client);

/* Steps to the mission's end, destroys the client and returns the exit code. */
int step_client_run(step_client_t* client, step_client_think_fn think, void* user);

/* Returns "TOPIC_VEHICLE" in upper case, in memory of its own. */
char* step_client_channel(const char* topic, const char* vehicle);

#endif
