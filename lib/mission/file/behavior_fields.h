// What the descriptions of behaviors share: kinds of values, and their greatest numbers. Part of
// describe_behavior.cc and its neighbours; the rest of the library needs none of it.
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/any_behavior.h"
#include "lib/mission/file/describe.h"

namespace shoal {

inline constexpr size_t kMaxBehaviorPoints = 10'000;
inline constexpr size_t kMaxFlags = 100;
inline constexpr size_t kMaxVariables = 1000;
inline constexpr NumberLimits kDistanceRange = Between(0, kFarthest_m);
inline constexpr NumberLimits kSpeedRange = Between(0, kFastest_mps);
inline constexpr NumberLimits kSecondsRange = Between(0, kLongest_s);
inline constexpr NumberLimits kDepthRange = Between(0, 20'000);
inline constexpr NumberLimits kDegreesRange = Between(0, 180);
inline constexpr NumberLimits kPercentRange = Between(0, 100);

/// A number where -1, the default, means that it is off.
void OrOff(Fields& fields, std::string_view key, double& value, double max);

/// One text, or an array of them.
void TextsOrOne(Fields& fields, std::string_view key, std::vector<std::string>& texts,
                size_t max_count);

/// Flags, which parse.
void FlagTexts(Fields& fields, std::string_view key, std::vector<std::string>& flags);

/// Conditions, which parse.
void ConditionTexts(Fields& fields, std::string_view key, std::vector<std::string>& conditions);

/// The name of a variable, or nothing.
void VariableName(Fields& fields, std::string_view key, std::string& name);

/// One of some words.
void OneWordOf(Fields& fields, std::string_view key, std::string& word,
               std::initializer_list<std::string_view> words);

/// Corners as an array, or as a text of MOOS-IvP's: "radial:: x=0, y=0, radius=30, pts=8".
void ConvexCorners(Fields& fields, std::string_view key, std::vector<Eigen::Vector2d>& corners,
                   bool may_lack);

/// Points as an array, or as a text of MOOS-IvP's.
void PointList(Fields& fields, std::string_view key, std::vector<Eigen::Vector2d>& points);

/// A point that may be absent.
void MayBePoint(Fields& fields, std::string_view key, std::optional<Eigen::Vector2d>& point);

/// The keys of each kind of behavior, one function for each alternative of AnyBehavior.
/// `is_recipe`: what is filled in when a behavior is made may be absent.
void DescribeKind(Fields& fields, WaypointOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, LoiterOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, StationKeepOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, LegRunOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, FixedTurnOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, ZigzagOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, AvoidCollisionOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, ColregsOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, AvoidObstacleOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, TrailOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, CutRangeOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, ConvoyOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, ShadowOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, ConstantDepthOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, ConstantSpeedOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, ConstantHeadingOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, TimerOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, PeriodicSurfaceOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, MaxDepthOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, MaxSpeedOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, GoToDepthOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, OpRegionOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, MemoryTurnLimitOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, PeriodicSpeedOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, FullStopOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, TestFailureOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, MaintainHeadingOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, HeadingBiasOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, HysteresisOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, MinAltitudeOptions& o, bool is_recipe);
void DescribeKind(Fields& fields, RubberBandOptions& o, bool is_recipe);

}  // namespace shoal
