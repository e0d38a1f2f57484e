// The words of `shoal send` as messages, and as the help that lists them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/lcm_bus.h"
#include "lib/check/result.h"
#include "lib/routing/control.h"
#include "shoal/helm_command_t.hpp"
#include "shoal/node_message_t.hpp"
#include "shoal/sim_command_t.hpp"
#include "shoal/unc_control_t.hpp"

namespace shoal {

/// Return the message that the words stand for, or what is wrong with them and how to write them.
/// `words` begin with the command, but for rules, where they follow the rule's name.
[[nodiscard]] Result<helm_command_t> ParseHelmWords(std::span<const std::string> words);
[[nodiscard]] Result<sim_command_t> ParseSimWords(std::span<const std::string> words);
[[nodiscard]] Result<unc_control_t> ParseRuleWords(const ControlRow& row,
                                                   std::span<const std::string> words);
/// DEST VAR VALUE, with --double and --ack anywhere. Sender and ack_id are left empty.
[[nodiscard]] Result<node_message_t> ParseMessageWords(std::span<const std::string> words);

/// Returns the text of `shoal send --help`'s list of commands.
std::string SendCommandsText();

/// Prints why nothing can have left, where that is so. Returns true where the bus works.
bool BusWorks(const LcmBus& bus);

}  // namespace shoal
