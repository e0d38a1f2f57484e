#include "lib/mission/toml/polygon_text.h"

#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/text/blanks.h"
#include "lib/base/text/numbers.h"

namespace shoal {
namespace {

constexpr double kMaxRadialCorners = 1000;

/// Calls `each` with every part of `text` between separators, trimmed.
template <class Each>
void Split(std::string_view text, char separator, const Each& each) {
  while (true) {
    const size_t end = text.find(separator);
    each(Trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

std::string_view WithoutWrapping(std::string_view text) {
  text = Trimmed(text);
  if (text.starts_with("pts")) {
    const size_t sign = text.find('=');
    if (sign != std::string_view::npos) text = Trimmed(text.substr(sign + 1));
  }
  if (text.starts_with('{') && text.ends_with('}')) text = text.substr(1, text.size() - 2);
  return Trimmed(text);
}

Result<std::vector<Eigen::Vector2d>> RadialPolygon(std::string_view text) {
  std::map<std::string, double, std::less<>> numbers;
  std::string problem;
  Split(text, ',', [&](std::string_view part) {
    const size_t sign = part.find('=');
    const auto number =
        sign == std::string_view::npos ? std::nullopt : NumberIn(part.substr(sign + 1));
    const std::string_view key = Trimmed(part.substr(0, sign));
    if (number) {
      numbers.emplace(key, *number);
    } else if (key != "label" && key != "msg" && problem.empty()) {
      problem = "'" + std::string(part) + "' is not key = number";
    }
  });
  const auto number = [&](std::string_view key, double otherwise) {
    const auto found = numbers.find(key);
    return found == numbers.end() ? otherwise : found->second;
  };
  const double radius_m = number("radius", 0);
  const double count = number("pts", 0);
  const double snap_m = number("snap", 0);
  if (!problem.empty()) return Error{problem};
  if (!numbers.contains("x") || !numbers.contains("y") || radius_m <= 0 || count < 3 ||
      count > kMaxRadialCorners || snap_m < 0) {
    return Error{
        "a radial polygon needs x, y, radius > 0 and pts of 3 to 1000, like radial:: "
        "x=0, y=0, radius=30, pts=8"};
  }
  std::vector<Eigen::Vector2d> corners;
  const int num_corners = static_cast<int>(count);
  for (int i = 0; i < num_corners; ++i) {
    const double angle_rad = 2 * std::numbers::pi * (i + 0.5) / num_corners;
    Eigen::Vector2d corner(number("x", 0) + radius_m * Sin(angle_rad),
                           number("y", 0) + radius_m * Cos(angle_rad));
    if (snap_m > 0) corner = (corner / snap_m).array().round() * snap_m;
    corners.push_back(corner);
  }
  return corners;
}

}  // namespace

Result<std::vector<Eigen::Vector2d>> ParsePoints(std::string_view text) {
  std::vector<Eigen::Vector2d> points;
  std::string problem;
  Split(WithoutWrapping(text), ':', [&](std::string_view part) {
    const size_t comma = part.find(',');
    const auto x = NumberIn(part.substr(0, comma));
    const auto y =
        comma == std::string_view::npos ? std::nullopt : NumberIn(part.substr(comma + 1));
    if (x && y) {
      points.emplace_back(*x, *y);
    } else if (problem.empty()) {
      problem = "'" + std::string(part) + "' is not a point; write points like 0,0:100,0";
    }
  });
  if (!problem.empty()) return Error{problem};
  return points;
}

Result<std::vector<Eigen::Vector2d>> ParsePolygon(std::string_view text) {
  constexpr std::string_view kFormat = "format";
  constexpr std::string_view kRadial = "radial::";
  text = Trimmed(text);
  if (text.starts_with(kRadial)) return RadialPolygon(text.substr(kRadial.size()));
  if (text.starts_with(kFormat)) {
    const size_t comma = text.find(',');
    const size_t sign = text.find('=');
    if (comma != std::string_view::npos && sign < comma &&
        Trimmed(text.substr(sign + 1, comma - sign - 1)) == "radial") {
      return RadialPolygon(text.substr(comma + 1));
    }
  }
  return ParsePoints(text);
}

}  // namespace shoal
