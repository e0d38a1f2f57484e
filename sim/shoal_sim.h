/* A whole mission in one process, for programs in C and for every language that calls C. The same
 * steps and the same log, byte for byte, as `shoal sim`. In C++: sim/simulation.h.
 *
 *   shoal_sim* sim = shoal_sim_new("berta.toml");
 *   shoal_sim_watch(sim, "NAV_ALPHA");
 *   if (shoal_sim_open(sim) != SHOAL_SIM_OK) return fail(shoal_sim_error(sim));
 *   while (shoal_sim_step(sim, 10) == 10) {
 *     const void* data; size_t size; int64_t count;
 *     shoal_sim_read(sim, "NAV_ALPHA", &data, &size, &count);  // an encoded shoal_nav_t
 *   }
 *   puts(shoal_sim_summary(sim));
 *   shoal_sim_free(sim);
 *
 * Functions that can fail return SHOAL_SIM_OK or another shoal_sim_code; shoal_sim_error() has the
 * text then. Null in place of a shoal_sim or a text is an error, never a crash. No C++ exception
 * leaves a function. One thread at a time may use one shoal_sim; several of them are independent.
 * docs/extending/embedding.md
 */
#ifndef SHOAL_SIM_H
#define SHOAL_SIM_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Of this header. It grows by one with every change that old callers do not survive. */
#define SHOAL_SIM_ABI_VERSION 0

/** One mission: set up, open, step, free. */
typedef struct shoal_sim shoal_sim; /* NOLINT(modernize-use-using): C reads it. */

enum shoal_sim_code {
  SHOAL_SIM_OK = 0,
  SHOAL_SIM_MISUSE = -1,   /**< A wrong argument, or a call at a wrong time. */
  SHOAL_SIM_MISSION = -2,  /**< The mission file or an override is wrong. */
  SHOAL_SIM_FAULT = -3,    /**< The mission cannot go on: disk full, a participant is lost. */
  SHOAL_SIM_INTERNAL = -4, /**< No memory, or an error inside shoal. */
};

/** Returns SHOAL_SIM_ABI_VERSION of the library: compare it with that of the header. */
int shoal_sim_abi_version(void);
/** Returns the version of shoal, the id of this build and that of its arithmetic, such as "0.2.0
 * (build 1f..., arithmetic 9b...)". */
const char* shoal_sim_version(void);

/** Returns a mission that is not opened yet, or null where there is no memory. */
shoal_sim* shoal_sim_new(const char* mission_file);
/** Ends the mission, closes its log, and frees it. Null: without effect. */
void shoal_sim_free(shoal_sim* sim);

/** Returns what was wrong in the last call that failed; "" where none did. Errors of a mission file
 * have one line each. Valid until the next call that fails, or shoal_sim_free(). */
const char* shoal_sim_error(const shoal_sim* sim);

/* Before shoal_sim_open(): */

/** Overrides a key of the mission file, as --set does: "comms.comms_range=100". */
int shoal_sim_set(shoal_sim* sim, const char* override_text);
/** In place of the mission file's seed. */
int shoal_sim_set_seed(shoal_sim* sim, uint64_t seed);
/** Writes a log of the mission, in place of a file of this name. */
int shoal_sim_set_log(shoal_sim* sim, const char* path);
/** Keeps the last message of a channel for shoal_sim_read(). Also after shoal_sim_open(), but
 * before the first step. */
int shoal_sim_watch(shoal_sim* sim, const char* channel);
/** Keeps every message of a channel for shoal_sim_take(), up to 64 MiB; beyond that
 * shoal_sim_step() fails until some are taken. When: as shoal_sim_watch(), which it includes. */
int shoal_sim_collect(shoal_sim* sim, const char* channel);

/** Loads the mission. */
int shoal_sim_open(shoal_sim* sim);

/* After it: */

/** Takes up to `count` steps. Returns how many it took: fewer, down to 0, at the end of the
 * mission, when the log is complete. Negative: a shoal_sim_code. */
int64_t shoal_sim_step(shoal_sim* sim, int64_t count);
/** Ends the mission before its last step. Without effect after the end. */
int shoal_sim_end(shoal_sim* sim);

/** Gives the last message of a channel that is watched: what was published up to the step before
 * the last, as on any bus of shoal; after the end all there was. *data is an encoded LCM message,
 * valid until the next step; null where there was none yet. *count is the number of messages so
 * far. `size` and `count` may be null. */
int shoal_sim_read(shoal_sim* sim, const char* channel, const void** data, size_t* size,
                   int64_t* count);
/** Takes the oldest message of a channel that is collected, in the order in which an app would get
 * them. Returns 1, and *data as shoal_sim_read() gives it, valid until the next call for this
 * channel; 0: none is left. `size` may be null. Negative: a shoal_sim_code. */
int shoal_sim_take(shoal_sim* sim, const char* channel, const void** data, size_t* size);
/** Publishes an encoded LCM message, as the participant "embedder". It reaches the others in the
 * second step from now. A channel has 1 to 63 letters, digits, '_' and '.'. A message that is not
 * of the channel's type is dropped by those who read it. */
int shoal_sim_write(shoal_sim* sim, const char* channel, const void* data, size_t size);

/** The number of the last step taken, from 0; -1 before the first. */
int64_t shoal_sim_step_number(const shoal_sim* sim);
/** Mission time of the last step, microseconds. */
int64_t shoal_sim_utime(const shoal_sim* sim);
/** Duration of a step, microseconds. 0 before shoal_sim_open(). */
int64_t shoal_sim_tick_us(const shoal_sim* sim);
/** 1 when the mission has ended, else 0. */
int shoal_sim_has_ended(const shoal_sim* sim);

int64_t shoal_sim_num_vehicles(const shoal_sim* sim);
/** Returns a vehicle's name in the order of the mission, or null where there is no vehicle `index`.
 */
const char* shoal_sim_vehicle(const shoal_sim* sim, int64_t index);

/** 1 where the mission would pass, should it end now; else 0. */
int shoal_sim_passed(const shoal_sim* sim);
/** Returns the mission's last page, should it end now; its last line is PASS, FAIL, or, before the
 * end, INCOMPLETE. Valid until the next call of this function. */
const char* shoal_sim_summary(shoal_sim* sim);

#ifdef __cplusplus
}
#endif

#endif
