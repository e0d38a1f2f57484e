#include "lib/sea/ocean/current_zones.h"

#include <algorithm>

namespace shoal {

namespace {

constexpr Zone kSpeeds[] = {{"dead", {0, 0}},    {"typical", {0.05, 0.5}}, {"moderate", {0.5, 1}},
                            {"swift", {1, 1.8}}, {"fast", {1.8, 2.5}},     {"any", {0, 2.5}}};

constexpr Zone kSpeedDeviations[] = {{"constant", {0, 0}},
                                     {"steady", {0.01, 0.1}},
                                     {"varied", {0.1, 0.5}},
                                     {"unsteady", {0.5, 1.5}},
                                     {"any", {0, 1.5}}};

constexpr Zone kDirections[] = {{"east", {-kPi / 8, kPi / 8}},
                                {"northeast", {kPi / 8, 3 * kPi / 8}},
                                {"north", {3 * kPi / 8, 5 * kPi / 8}},
                                {"northwest", {5 * kPi / 8, 7 * kPi / 8}},
                                {"west", {7 * kPi / 8, 9 * kPi / 8}},
                                {"southwest", {-7 * kPi / 8, -5 * kPi / 8}},
                                {"south", {-5 * kPi / 8, -3 * kPi / 8}},
                                {"southeast", {-3 * kPi / 8, -kPi / 8}},
                                {"any", {-kPi, kPi}}};

constexpr Zone kDirectionDeviations[] = {{"constant", {0, 0}},
                                         {"steady", {0.01, kPi / 18}},
                                         {"varied", {kPi / 18, kPi / 8}},
                                         {"unsteady", {kPi / 8, kPi / 2}},
                                         {"any", {0, kPi / 2}}};

constexpr Zone kHalfPeriods[] = {{"calm", {600, 600}},
                                 {"smooth", {90, 150}},
                                 {"regular", {30, 90}},
                                 {"choppy", {10, 30}},
                                 {"any", {10, 600}}};

template <class Named>
const Named* FindNamed(std::span<const Named> all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

double Draw(const DrawRange& range, const StreamKey& key) {
  return range.low + (range.high - range.low) * Stream(key).Uniform();
}

}  // namespace

std::span<const Zone> CurrentSpeedZones() { return kSpeeds; }
std::span<const Zone> CurrentSpeedDeviationZones() { return kSpeedDeviations; }
std::span<const Zone> CurrentDirectionZones() { return kDirections; }
std::span<const Zone> CurrentDirectionDeviationZones() { return kDirectionDeviations; }
std::span<const Zone> CurrentHalfPeriodZones() { return kHalfPeriods; }

const Zone* FindZone(std::span<const Zone> zones, std::string_view name) {
  return FindNamed(zones, name);
}

CurrentParams DrawCurrent(const CurrentRanges& ranges, const StreamKey& key) {
  return {.speed_mps = {.mean = Draw(ranges.speed_mps, key.With("speed")),
                        .deviation = Draw(ranges.speed_deviation_mps, key.With("speed_deviation")),
                        .half_period_s =
                            Draw(ranges.speed_half_period_s, key.With("speed_half_period"))},
          .direction_rad = {
              .mean = WrapPi(Draw(ranges.direction_rad, key.With("direction"))),
              .deviation = Draw(ranges.direction_deviation_rad, key.With("direction_deviation")),
              .half_period_s =
                  Draw(ranges.direction_half_period_s, key.With("direction_half_period"))}};
}

}  // namespace shoal
