// What a decision may be, whatever the objectives want: a part of the domain.
//
//   const GridDecision decision = Decide(domain, aims, allowed);
//   if (decision.wanted) ...   // The weighted sum alone has its best point outside.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "lib/helm/decision/domain.h"

namespace shoal {

/// Indices of an axis, ends included.
struct IndexRange {
  int first = 0;
  int last = -1;  ///< Below first: none.

  bool empty() const { return last < first; }
  bool Has(int index) const { return first <= index && index <= last; }
  IndexRange And(const IndexRange& other) const {
    return {.first = std::max(first, other.first), .last = std::min(last, other.last)};
  }

  bool operator==(const IndexRange&) const = default;
};

struct AllowedPart {
  std::vector<IndexRange> speeds = {};    ///< Of each course; empty: all.
  std::optional<IndexRange> depths = {};  ///< Absent: all.

  bool operator==(const AllowedPart&) const = default;
};

/// Returns true where some course has a speed that is allowed.
[[nodiscard]] inline bool AllowsAny(const std::vector<IndexRange>& speeds) {
  return speeds.empty() || std::any_of(speeds.begin(), speeds.end(),
                                       [](const IndexRange& range) { return !range.empty(); });
}

/// Restricts `allowed` to what `other` allows too, course and speed apart from depth; each stays as
/// it is where nothing would be left.
void Restrict(AllowedPart* allowed, const AllowedPart& other);

}  // namespace shoal
