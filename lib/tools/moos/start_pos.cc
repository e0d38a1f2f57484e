#include "lib/tools/moos/start_pos.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {
namespace {

constexpr std::array<std::string_view, 5> kStartOrder = {"x", "y", "heading", "speed", "depth"};

}  // namespace

std::string_view StartKey(std::string_view moos_key) {
  if (moos_key == "x") return "x_m";
  if (moos_key == "y") return "y_m";
  if (moos_key == "heading" || moos_key == "hdg" || moos_key == "deg") return "heading_deg";
  if (moos_key == "speed" || moos_key == "spd") return "speed_mps";
  return "";
}

std::string ReadStartPos(std::string_view text, std::map<std::string, double>* given) {
  std::string problem;
  size_t place = 0;
  for (const std::string_view part : TrimmedParts(text, ',')) {
    const size_t equals = part.find('=');
    const bool is_named = equals != part.npos;
    if (!is_named && place >= kStartOrder.size())
      return "has more than x, y, heading, speed, depth";
    std::string name =
        is_named ? LowerCase(Trimmed(part.substr(0, equals))) : std::string(kStartOrder[place]);
    ++place;
    if (StartKey(name).empty() && name != "depth") {
      return fmt::format(
          "{} is not one of x, y, heading, speed and depth: what follows is not read",
          Quoted(name));
    }
    const auto number = NumberIn(is_named ? part.substr(equals + 1) : part);
    if (!number && !Trimmed(text).empty()) problem = fmt::format("{} is taken as 0", Quoted(part));
    if (name == "hdg" || name == "deg") name = "heading";
    if (name == "spd") name = "speed";
    (*given)[name] = number.value_or(0);
  }
  return problem;
}

}  // namespace shoal
