// The words of an order, as `shoal send` and the viewer take them, as messages, and as the help
// that lists them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lib/base/check/result.h"
#include "lib/comms/routing/control.h"
#include "shoal/clock_command_t.hpp"
#include "shoal/helm_command_t.hpp"
#include "shoal/node_message_t.hpp"
#include "shoal/sim_command_t.hpp"
#include "shoal/unc_control_t.hpp"

namespace shoal {

/// Return the message that the words stand for, or what is wrong with them and how to write them.
/// `words` begin with the command, but for rules, where they follow the rule's name, and for the
/// clock, where they follow "clock".
[[nodiscard]] Result<helm_command_t> ParseHelmWords(std::span<const std::string> words);
[[nodiscard]] Result<sim_command_t> ParseSimWords(std::span<const std::string> words);
[[nodiscard]] Result<unc_control_t> ParseRuleWords(const ControlRow& row,
                                                   std::span<const std::string> words);
[[nodiscard]] Result<clock_command_t> ParseClockWords(std::span<const std::string> words);
/// DEST VAR VALUE, with --double and --ack anywhere. Sender and ack_id are left empty.
[[nodiscard]] Result<node_message_t> ParseMessageWords(std::span<const std::string> words);

/// Returns the number of mission seconds per wall second that the word stands for, 0 for "max";
/// nothing where it is neither that nor one that a clock can have.
[[nodiscard]] std::optional<double> ParseWarp(std::string_view word);

/// Returns the text of `shoal send --help`'s list of commands.
std::string SendCommandsText();

}  // namespace shoal
