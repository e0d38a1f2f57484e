// COMMS_FATES has the fates of a step as columns, which are a tenth of a list's size; logs of 0.1
// and 0.2 have lists. What reads fates reads both as the list:
//
//   Subscribe(bus, channels::CommsFates(), [](const comms_fates_t& fates) { ... });
//   comms_fates_t fates;
//   if (Decode(data, &fates)) ...
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "shoal/comms_fate_columns_t.hpp"
#include "shoal/comms_fates_t.hpp"

namespace shoal {

/// Decodes a comms_fates_t, or a comms_fate_columns_t as one.
template <>
[[nodiscard]] bool Decode(std::span<const uint8_t> data, comms_fates_t* message);

/// What the texts of a message's fates may have together: one long name could stand for many. A
/// fate of shoal's own has at most 150 bytes of text.
inline constexpr size_t kMaxFateTexts_bytes = size_t{64} << 20;  ///< Of any number of fates ...
inline constexpr size_t kMaxTextOfFate_bytes = 256;              ///< ... and this more for each.

/// Makes a list of columns. Returns false where they do not fit one another: an index, or the
/// length of a column, is not what the others make it, or where the list's texts would have more
/// bytes than the constants above allow.
[[nodiscard]] bool ListOf(const comms_fate_columns_t& columns, comms_fates_t* list);

/// Returns the bytes of a comms_fates_t, made in `storage`, where `message` is a
/// comms_fate_columns_t; all else as it is.
[[nodiscard]] std::span<const uint8_t> WithFatesAsList(std::span<const uint8_t> message,
                                                       Bytes* storage);

}  // namespace shoal
