#include "lib/run/broker/comms_example.h"

#include <fmt/format.h>

#include <string_view>

#include "lib/comms/routing/rules.h"
#include "lib/mission/file/load_comms.h"

namespace shoal {

std::string CommsExample() {
  std::string text = "[comms]\n";
  for (const std::string& line : ExplainComms({})) {
    const std::string_view key = std::string_view(line).substr(0, line.find(' '));
    for (const RuleRow& row : kRuleTable) {
      if (row.rule != key) continue;
      text +=
          fmt::format("{:<37} # {}{}{}\n", line, row.unit, row.unit.empty() ? "" : ": ", row.about);
    }
  }
  return text;
}

}  // namespace shoal
