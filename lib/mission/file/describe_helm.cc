// The tables beside behaviors: [[vehicle.mode]], [vehicle.variables], [vehicle.domain],
// [[obstacle]].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>

#include "lib/helm/modes/mode_tree.h"
#include "lib/helm/modes/value_text.h"
#include "lib/mission/file/behavior_fields.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

constexpr int kMaxDomainPoints = 10'001;

/// An axis as [first, last, number of points].
void DescribeAxis(Fields& fields, std::string_view key, Axis& axis, double max) {
  if (!fields.Has(key, axis.count > 0)) return;
  Eigen::Vector3d triple(axis.first, axis.count > 0 ? axis.Last() : 0, axis.count);
  fields.Triple(key, triple, Between(0, std::max<double>(max, kMaxDomainPoints)));
  const double count = triple.z();
  if (triple.x() >= triple.y() || triple.y() > max || count != std::floor(count) || count < 2 ||
      count > kMaxDomainPoints) {
    fields.Refuse(key, fmt::format("{} must be [first, last, number of points]: first less than "
                                   "last, last at most {}, 2 to {} points",
                                   key, max, kMaxDomainPoints));
    return;
  }
  axis = {.first = triple.x(),
          .step = (triple.y() - triple.x()) / (count - 1),
          .count = static_cast<int>(count)};
}

}  // namespace

void Describe(Fields& fields, ModeOptions& mode) {
  fields.Require("set", "set = \"MODE = ACTIVE\"");
  fields.Text("set", mode.set, {.min_length = 1, .max_length = 200});
  ConditionTexts(fields, "condition", mode.condition);
  fields.Text("else", mode.otherwise, {});
  fields.CalledElsewhere("else", "otherwise");
  if (!mode.set.empty() && ParseConditions(mode.condition).ok()) {
    const auto tree = ModeTree::Parse(std::span(&mode, 1));
    if (!tree.ok()) fields.Refuse("set", tree.error());
  }
}

void Describe(Fields& fields, Domain& domain) {
  DescribeAxis(fields, "speed", domain.speed_mps, kFastest_mps);
  DescribeAxis(fields, "depth", domain.depth_m, kDepthRange.max);
  fields.NoKey("course", "courses are always whole degrees");
  if (domain.speed_mps.first != 0) {
    fields.Refuse("speed", "the first speed must be 0, so that a vessel can stop");
    domain.speed_mps.first = 0;
  }
}

void Describe(Fields& fields, Obstacle& obstacle) {
  fields.Require("id", "id = \"rock\"");
  fields.Text("id", obstacle.id, {.min_length = 1});
  if (!obstacle.id.empty() && !VariableNameProblem(obstacle.id).empty()) {
    fields.Refuse("id", Quoted(obstacle.id) + " is not an id: letters, digits and _ . - are");
  }
  fields.Require("polygon", "polygon = [[40, -10], [60, -10], [60, 10], [40, 10]]");
  ConvexCorners(fields, "polygon", obstacle.polygon_m, true);
  if (obstacle.polygon_m.empty() && fields.Has("polygon", true)) {
    fields.Refuse("polygon", "polygon needs at least three corners");
  }
}

void DescribeVariables(Fields& fields, std::map<std::string, VariableValue>& variables) {
  fields.Scalars("variables", variables, kMaxVariables);
  for (const auto& [name, value] : variables) {
    const std::string problem = VariableNameProblem(name);
    if (!problem.empty()) fields.Refuse("variables", problem);
  }
}

}  // namespace shoal
