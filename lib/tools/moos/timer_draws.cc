#include "lib/tools/moos/timer_draws.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {

namespace {

/// Draws as uTimerScript does, in 10,000 steps.
double DrawUniform(double low, double high, Stream* stream) {
  constexpr uint64_t kSteps = 10'000;
  return low + (high - low) * static_cast<double>(stream->UniformInt(kSteps)) / kSteps;
}

}  // namespace

std::optional<TimeRange> ParseTimeRange(std::string_view text) {
  const size_t colon = text.find(':');
  const auto low = NumberIn(text.substr(0, colon));
  const auto high = colon == text.npos ? low : NumberIn(text.substr(colon + 1));
  if (!low || !high || *low < 0 || *high < *low) return std::nullopt;
  return TimeRange{*low, *high};
}

double DrawTime(const TimeRange& range, Stream* stream) {
  return range.low_s == range.high_s ? range.low_s : DrawUniform(range.low_s, range.high_s, stream);
}

double TimerRounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

std::optional<RandomVariable> ParseRandomVariable(std::string_view text) {
  const auto fields = ParseFields(text);
  if (!fields.ok()) return std::nullopt;
  RandomVariable variable;
  for (const MoosField& field : *fields) {
    const std::string key = LowerCase(field.key.substr(0, 16));
    const auto number = NumberIn(field.value);
    if (key == "varname") {
      variable.name = field.value;
    } else if (key == "key") {
      variable.key = LowerCase(field.value);
    } else if (key == "type") {
      variable.is_gaussian = LowerCase(field.value) == "gaussian";
    } else {
      double* const place = key == "min"     ? &variable.min
                            : key == "max"   ? &variable.max
                            : key == "snap"  ? &variable.snap
                            : key == "mu"    ? &variable.mu
                            : key == "sigma" ? &variable.sigma
                                             : nullptr;
      if (place == nullptr || !number) return std::nullopt;
      *place = *number;
    }
  }
  const bool is_drawn =
      variable.key == "at_start" || variable.key == "at_reset" || variable.key == "at_post";
  if (variable.name.empty() || !is_drawn || !(variable.min <= variable.max)) return std::nullopt;
  return variable;
}

void Draw(RandomVariable* variable, Stream* stream) {
  double value = variable->is_gaussian ? variable->mu + variable->sigma * stream->Normal()
                                       : DrawUniform(variable->min, variable->max, stream);
  if (variable->snap > 0) value = std::round(value / variable->snap) * variable->snap;
  if (variable->is_gaussian) value = std::clamp(value, variable->min, variable->max);
  variable->value = TimerRounded(value);
}

std::string WithTimerSums(std::string text) {
  constexpr int kMostPairs = 100;
  for (int i = 0; i < kMostPairs; ++i) {
    const size_t close = text.find('}');
    const size_t open = close == text.npos ? text.npos : text.rfind('{', close);
    if (open == text.npos || text.find('{', close) != text.npos) return text;
    const std::string inner = text.substr(open + 1, close - open - 1);
    std::optional<double> result;
    for (const char sign : std::string_view("*/+-")) {
      const size_t at = inner.find(sign, 1);
      if (at == inner.npos) continue;
      const auto left = NumberIn(std::string_view(inner).substr(0, at));
      const auto right = NumberIn(std::string_view(inner).substr(at + 1));
      if (!left || !right) continue;
      result = sign == '*' ? *left * *right : sign == '+' ? *left + *right : *left - *right;
      if (sign == '/') result = *left / *right;
      break;
    }
    if (!result || !std::isfinite(*result)) return text;
    text.replace(open, close - open + 1, TomlNumber(TimerRounded(*result)));
  }
  return text;
}

void ReplaceTimerMacro(std::string* text, const std::string& macro, const std::string& value) {
  for (const std::string& form : {"$[" + macro + "]", "$(" + macro + ")"}) {
    for (size_t at = text->find(form); at != text->npos; at = text->find(form, at + value.size())) {
      text->replace(at, form.size(), value);
    }
  }
}

bool HasTimerMacro(std::string_view text) {
  return text.find("$[") != text.npos || text.find("$(") != text.npos ||
         text.find("%(") != text.npos || text.find("${") != text.npos;
}

}  // namespace shoal
