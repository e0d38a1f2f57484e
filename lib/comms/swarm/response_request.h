// What a BROADCAST/REQUEST asks of the vehicle that receives it: to answer in a slot of its own.
//
// The slot begins at start_us + slot * (the mission's length of a response slot).
#pragma once

#include <cstdint>

namespace shoal {

struct ResponseRequest {
  int64_t start_us = 0;  ///< When slot 0 of the answers begins; mission time.
  int slot = 0;          ///< Place of this vehicle in the order of answers, from 0.

  bool operator==(const ResponseRequest&) const = default;
};

}  // namespace shoal
