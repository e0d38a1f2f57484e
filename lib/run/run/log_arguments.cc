#include "lib/run/run/log_arguments.h"

#include <fmt/format.h>

namespace shoal {

namespace {

void AddChannels(Command command, std::vector<std::string>* only, std::string_view verb) {
  command
      .AddOption("--channels,--channel", only,
                 fmt::format("{} only these channels, e.g. 'NAV_*'; * and ? are wild", verb))
      .Repeatable();
}

}  // namespace

void AddChannelChoice(Command command, ChannelChoice* choice, std::string_view verb) {
  AddChannels(command, &choice->only, verb);
  AddWithout(command, &choice->without);
}

void AddWithout(Command command, std::vector<std::string>* without) {
  command
      .AddOption("--without", without,
                 "Leave out these channels, e.g. VIEW_COMMS_PULSE; * and ? are wild")
      .Repeatable();
}

void AddLogSelection(Command command, LogSelection* selection) {
  AddChannels(command, &selection->channels, "Take");
  AddWithout(command, &selection->without);
  command.AddOption("--from", &selection->from_s, "From this time on, seconds");
  command.AddOption("--to", &selection->to_s, "Up to this time, seconds");
}

void AddLogTypes(Command command, std::vector<std::string>* types) {
  command.AddOption("--types", types, "A .lcm file of message types that are not shoal's")
      .Repeatable();
}

}  // namespace shoal
