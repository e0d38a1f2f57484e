#include "lib/run/run/log_arguments.h"

namespace shoal {

void AddLogSelection(Command command, LogSelection* selection) {
  command
      .AddOption("--channels,--channel", &selection->channels,
                 "Only these channels; * and ? are wild")
      .Repeatable();
  command.AddOption("--without", &selection->without, "Leave out these channels; * and ? are wild")
      .Repeatable();
  command.AddOption("--from", &selection->from_s, "From this time on, seconds");
  command.AddOption("--to", &selection->to_s, "Up to this time, seconds");
}

void AddLogTypes(Command command, std::vector<std::string>* types) {
  command.AddOption("--types", types, "A .lcm file of message types that are not shoal's")
      .Repeatable();
}

}  // namespace shoal
