// What the processes of a mission answer a TICK with: STEP_DONE of one participant, or STEP_DONES
// of several of one process. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "shoal/step_dones_t.hpp"

namespace shoal {

/// True for the channels of answers.
inline bool IsStepAnswer(std::string_view channel) {
  return channel == topics::kStepDone || channel == topics::kStepDones;
}

/// Reads a message of one of these channels, without its seal; it has one answer at least. Absent:
/// it is none.
inline std::optional<step_dones_t> DecodeStepAnswers(std::string_view channel,
                                                     std::span<const uint8_t> message) {
  step_dones_t answers{};
  const bool is_decoded = channel == topics::kStepDone
                              ? Decode(message, &answers.dones.emplace_back())
                              : Decode(message, &answers) && !answers.dones.empty();
  return is_decoded ? std::optional(std::move(answers)) : std::nullopt;
}

}  // namespace shoal
