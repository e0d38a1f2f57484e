#include "lib/tools/moos/link_factor.h"

#include "lib/base/text/letters.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {

bool IsLinkFactor(std::string_view moos_key) {
  const std::string key = LowerCase(moos_key);
  return key == "stealth" || key == "earange" || key == "earrange";
}

std::optional<LinkFactorSetting> ParseLinkFactor(const MoosLine& line) {
  const std::string key = LowerCase(line.key) == "stealth" ? "stealth" : "earange";
  const auto fields = ParseFields(line.value);
  if (!fields.ok()) return std::nullopt;
  LinkFactorSetting setting{.vehicle = "", .key = key, .value = ""};
  for (const MoosField& field : *fields) {
    const std::string name = LowerCase(field.key.substr(0, 16));
    if (name == "vname") {
      setting.vehicle = field.value;
    } else if (name == key || (key == "earange" && name == "earrange")) {
      const auto number = NumberIn(field.value);
      if (!number) return std::nullopt;
      setting.value = TomlNumber(*number);
    } else {
      return std::nullopt;
    }
  }
  if (setting.vehicle.empty() || setting.value.empty()) return std::nullopt;
  return setting;
}

}  // namespace shoal
