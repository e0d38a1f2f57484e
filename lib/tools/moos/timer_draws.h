// What a script of uTimerScript draws and computes: times, random variables, {a+b}, macros.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/base/random/stream.h"

namespace shoal {

/// "10", or "10:20": each time is drawn from it.
struct TimeRange {
  double low_s = 0;
  double high_s = 0;
};

/// Returns nothing where the text is no such range, or begins below 0.
[[nodiscard]] std::optional<TimeRange> ParseTimeRange(std::string_view text);

[[nodiscard]] double DrawTime(const TimeRange& range, Stream* stream);

/// randvar = varname=X, min=0, max=9, snap=1, key=at_reset
struct RandomVariable {
  std::string name;
  double min = 0;
  double max = 1;
  double snap = 0.001;
  double mu = 0;
  double sigma = 1;
  bool is_gaussian = false;
  std::string key;  ///< at_start, at_reset or at_post: when it is drawn.
  double value = 0;
};

[[nodiscard]] std::optional<RandomVariable> ParseRandomVariable(std::string_view text);

/// Draws its value.
void Draw(RandomVariable* variable, Stream* stream);

/// Drops what sums leave behind the sixth place.
[[nodiscard]] double TimerRounded(double value);

/// Computes {a+b}, the innermost pair of braces first, of two numbers each; any other text stays.
[[nodiscard]] std::string WithTimerSums(std::string text);

/// Returns true where a text has a macro of uTimerScript or nsplug left.
[[nodiscard]] bool HasTimerMacro(std::string_view text);

/// Replaces $[macro] and $(macro).
void ReplaceTimerMacro(std::string* text, const std::string& macro, const std::string& value);

}  // namespace shoal
