// VIEW_COMMS_PULSE has the pulses of a step as columns, which are a sixth of a list's size; logs
// of 0.1 and 0.2 have lists. What reads pulses reads both as the list:
//
//   Subscribe(bus, channels::ViewCommsPulse(), [](const comms_pulses_t& pulses) { ... });
//   comms_pulses_t pulses;
//   if (Decode(data, &pulses)) ...
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "lib/bus/bus/bus.h"
#include "shoal/comms_pulse_columns_t.hpp"
#include "shoal/comms_pulses_t.hpp"

namespace shoal {

/// Decodes a comms_pulses_t, or a comms_pulse_columns_t as one.
template <>
[[nodiscard]] bool Decode(std::span<const uint8_t> data, comms_pulses_t* message);

/// The bound of all texts of a message's pulses: one long name could stand for many.
inline constexpr size_t kMaxPulseTexts_bytes = size_t{64} << 20;  ///< Of any number of pulses ...
inline constexpr size_t kMaxTextOfPulse_bytes = 256;              ///< ... and this more for each.

/// Makes a list of columns. Returns false if an index, or the length of a column, does not fit the
/// others, or if the list's texts would have more bytes than the constants above allow.
[[nodiscard]] bool ListOf(const comms_pulse_columns_t& columns, comms_pulses_t* list);

/// Returns the bytes of a comms_pulses_t, made in `storage`, if `message` is a
/// comms_pulse_columns_t; else `message` itself.
[[nodiscard]] std::span<const uint8_t> WithPulsesAsList(std::span<const uint8_t> message,
                                                        Bytes* storage);

}  // namespace shoal
