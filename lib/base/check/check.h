// Invariants that hold or the program is wrong.
//
//   SHOAL_CHECK(dt_s > 0, "a step must move time forward");
//
// Always on. A broken one prints file, line, expression and reason, and aborts. Never use it for
// anything that a user, a file or a peer can bring about: those are values
// (lib/base/check/result.h).
#pragma once

#include <cstdio>
#include <cstdlib>

#define SHOAL_CHECK(condition, reason)                                                           \
  do {                                                                                           \
    if (!(condition)) [[unlikely]] {                                                             \
      std::fprintf(stderr, "%s:%d: broken invariant: %s (%s)\n", __FILE__, __LINE__, #condition, \
                   reason);                                                                      \
      std::abort();                                                                              \
    }                                                                                            \
  } while (false)
