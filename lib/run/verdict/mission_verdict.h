// The verdict on a mission as a file that other programs read: what `shoal run` leaves for the
// viewer, and verdict.txt of a recording.
//
//   result<TAB>PASS
//   why<TAB>
//   end_s<TAB>600
//   expectation<TAB>pass<TAB>VALUE<TAB>UNIT<TAB>MARGIN<TAB>WHERE<TAB>TEXT<TAB>NUMBERS
//
// A number that there is not is empty.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/run/verdict/judge.h"

namespace shoal {

struct VerdictLine {
  bool passed = false;
  std::optional<double> value = {};  ///< The number that decided.
  std::string unit = {};
  std::optional<double> margin = {};  ///< To the limit; negative: beyond it.
  std::string where = {};             ///< "file:line" of the expectation.
  std::string text = {};
  std::string numbers = {};

  bool operator==(const VerdictLine&) const = default;
};

struct MissionVerdict {
  static constexpr size_t kMaxLines = 10'000;

  std::string result = {};  ///< PASS, FAIL or INCOMPLETE.
  std::string why = {};     ///< FailuresOf; empty where it passed.
  double end_s = 0;         ///< Mission time since the start.
  std::vector<VerdictLine> lines = {};

  bool operator==(const MissionVerdict&) const = default;
};

/// Returns the verdict, should the mission end at `end_s`; INCOMPLETE where it is not `complete`.
[[nodiscard]] MissionVerdict VerdictOf(const Mission& mission, const Judge& judge, double end_s,
                                       bool complete);

[[nodiscard]] std::string TextOf(const MissionVerdict& verdict);

/// Returns what TextOf wrote; nothing for other text. Lines that are not known are left out.
[[nodiscard]] std::optional<MissionVerdict> ReadVerdict(std::string_view text);

}  // namespace shoal
