#include "lib/mission/file/behavior_fields.h"

#include <fmt/format.h>

#include <span>
#include <utility>

#include "lib/base/geometry/convex_polygon.h"
#include "lib/helm/modes/condition.h"
#include "lib/helm/modes/flag.h"
#include "lib/helm/modes/value_text.h"
#include "lib/mission/toml/polygon_text.h"

namespace shoal {
namespace {

constexpr size_t kMaxBehaviorCorners = 1000;
constexpr NumberLimits kBehaviorPlace = Between(-kFarthest_m, kFarthest_m);

}  // namespace

void OrOff(Fields& fields, std::string_view key, double& value, double max) {
  fields.Number(key, value, Between(-1, max));
  if (value < 0 && value != -1) {
    fields.Refuse(key, fmt::format("{} = {} is neither -1 (off) nor 0 to {}", key, value, max));
    value = -1;
  }
}

void TextsOrOne(Fields& fields, std::string_view key, std::vector<std::string>& texts,
                size_t max_count) {
  if (!fields.HoldsText(key)) return fields.Texts(key, texts, max_count);
  std::string text;
  fields.Text(key, text, {.min_length = 1, .max_length = 4096});
  texts = {text};
}

void FlagTexts(Fields& fields, std::string_view key, std::vector<std::string>& flags) {
  TextsOrOne(fields, key, flags, kMaxFlags);
  const auto parsed = ParseFlags(flags);
  if (!parsed.ok()) fields.Refuse(key, parsed.error());
}

void ConditionTexts(Fields& fields, std::string_view key, std::vector<std::string>& conditions) {
  TextsOrOne(fields, key, conditions, kMaxFlags);
  const auto parsed = ParseConditions(conditions);
  if (!parsed.ok()) fields.Refuse(key, parsed.error());
}

void VariableName(Fields& fields, std::string_view key, std::string& name) {
  fields.Text(key, name, {});
  const std::string problem = name.empty() ? "" : VariableNameProblem(name);
  if (!problem.empty()) fields.Refuse(key, problem);
}

void OneWordOf(Fields& fields, std::string_view key, std::string& word,
               std::initializer_list<std::string_view> words) {
  fields.Word(key, word, std::span(words.begin(), words.size()));
}

void ConvexCorners(Fields& fields, std::string_view key, std::vector<Eigen::Vector2d>& corners,
                   bool may_lack) {
  if (fields.HoldsText(key)) {
    std::string text;
    fields.Text(key, text, {.max_length = 4096});
    auto polygon = ParsePolygon(text);
    if (polygon.ok()) {
      corners = std::move(*polygon);
    } else {
      fields.Refuse(key, fmt::format("{}: {}", key, polygon.error()));
      return;
    }
  } else {
    fields.Pairs(key, corners, kBehaviorPlace, kMaxBehaviorCorners);
  }
  if (corners.empty() && may_lack) return;
  if (corners.empty() && !fields.Has(key, true)) return;  // That was refused.
  if (!IsConvex(corners)) {
    fields.Refuse(key, fmt::format("{} is not convex: give at least three corners that all turn to "
                                   "the same side",
                                   key));
  }
}

void PointList(Fields& fields, std::string_view key, std::vector<Eigen::Vector2d>& points) {
  if (!fields.HoldsText(key)) return fields.Pairs(key, points, kBehaviorPlace, kMaxBehaviorPoints);
  std::string text;
  fields.Text(key, text, {.max_length = 100'000});
  auto read = ParsePoints(text);
  if (read.ok()) {
    points = std::move(*read);
  } else {
    fields.Refuse(key, fmt::format("{}: {}", key, read.error()));
  }
}

void MayBePoint(Fields& fields, std::string_view key, std::optional<Eigen::Vector2d>& point) {
  if (!fields.Has(key, point.has_value())) return;
  Eigen::Vector2d read = point.value_or(Eigen::Vector2d(0, 0));
  fields.Pair(key, read, kBehaviorPlace);
  point = read;
}

}  // namespace shoal
