// What two builds of shoal must share to work on one mission: the version and the arithmetic. Their
// build ids may differ; so a computer with another processor takes part.
#pragma once

#include <string>

namespace shoal {

struct BuildFacts {
  std::string version = {};
  std::string build = {};       ///< BuildId().
  std::string arithmetic = {};  ///< ArithmeticId().

  bool operator==(const BuildFacts&) const = default;
};

/// Returns those of the program that runs.
[[nodiscard]] BuildFacts OwnBuild();

/// Returns "0.2.0 (build 0123456789abcdef, arithmetic 0123456789abcdef)".
[[nodiscard]] std::string TextOf(const BuildFacts& facts);

/// Returns why two builds cannot share a mission, and the remedy: "its arithmetic is ..., not ...:
/// ..."; empty: they can. `its` is the build that is judged, `own` the other.
[[nodiscard]] std::string WhyNotTogether(const BuildFacts& its, const BuildFacts& own);

}  // namespace shoal
