#include "lib/run/moos_text/numbers.h"

#include <fmt/format.h>

#include <cmath>
#include <system_error>

#include "lib/base/text/blanks.h"
#include "lib/run/moos_text/fields.h"

namespace shoal {
namespace {

constexpr uint64_t kMicro = 1'000'000;

}  // namespace

std::string NumberText(double number) {
  // Some readers would take -0 for an integer, which has no sign of its own.
  if (number == 0 && std::signbit(number)) return "-0.0";
  return fmt::format("{}", number);
}

std::string SecondsText(int64_t utime) {
  const auto bits = static_cast<uint64_t>(utime);
  const uint64_t micros = utime < 0 ? 0 - bits : bits;
  std::string text = fmt::format("{}{}", utime < 0 ? "-" : "", micros / kMicro);
  if (micros % kMicro == 0) return text;
  text += fmt::format(".{:06}", micros % kMicro);
  return text.substr(0, text.find_last_not_of('0') + 1);
}

}  // namespace shoal
