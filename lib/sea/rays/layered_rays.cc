#include "lib/sea/rays/layered_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/sea/rays/ray_column.h"

namespace shoal {

namespace {

/// Between two critical angles the range is looked at here: at both ends, and in between at most
/// this far apart. Between two looks it has one extremum at most.
constexpr int kMinLooks = 6;
constexpr double kLongestLook_rad = 0.07;
/// The ends themselves are horizontal somewhere, where slopes are infinite.
constexpr double kEnd = 1e-7;
constexpr int kMaxRefinements = 100;

/// How often a path has each part; one cycle more adds two of each.
struct History {
  bool starts_down = false;
  bool ends_down = false;
  int ups = 0;
  int betweens = 0;
  int downs = 0;

  History WithCycles(int cycles) const {
    return {starts_down, ends_down, ups + 2 * cycles, betweens + 2 * cycles, downs + 2 * cycles};
  }
};

/// The four kinds of history, without a whole cycle.
std::array<History, 4> HistoriesBetween(bool receiver_is_deeper) {
  const bool deeper = receiver_is_deeper;
  return {{{deeper, deeper, 0, 1, 0},
           {false, true, 2, 1, 0},
           {true, false, 0, 1, 2},
           {!deeper, !deeper, 2, 1, 2}}};
}

/// A ray that was looked at.
struct Look {
  double u = 0;  ///< In (0, 1), along the interval of its kind.
  double launch_rad = 0;
  double slope_factor = 0;  ///< dp / du.
  RayParts parts;

  double RangeOf(const History& history) const {
    return history.ups * parts.up.range_m + history.betweens * parts.between.range_m +
           history.downs * parts.down.range_m;
  }
  /// d range / d u; not finite where the ray is horizontal at a vertex.
  double SlopeOf(const History& history) const {
    return (history.ups * parts.up.slope + history.betweens * parts.between.slope +
            history.downs * parts.down.slope) *
           slope_factor;
  }
};

class LayeredSearch {
 public:
  LayeredSearch(const RayScene& scene, const SectionPoint& source, const SectionPoint& receiver,
                const RayLimits& limits)
      : scene_(scene),
        limits_(limits),
        range_m_(receiver.range_m - source.range_m),
        receiver_is_deeper_(receiver.depth_m > source.depth_m),
        column_(scene.water.front().profile, scene.surface.front().depth_m,
                scene.bottom.front().depth_m, source.depth_m, receiver.depth_m),
        depth_difference_m_(receiver.depth_m - source.depth_m) {}

  std::vector<RayArrival> Run() {
    if (column_.IsStraightBetween()) AddStraight();
    double low_rad = 0;
    for (double high_rad : column_.CriticalAngles()) {
      high_rad = std::min(high_rad, limits_.max_launch_rad);
      SearchInterval(low_rad, high_rad);
      low_rad = high_rad;
    }
    SearchInterval(low_rad, limits_.max_launch_rad);
    return std::move(arrivals_);
  }

 private:
  Look LookAt(double u) const {
    Look look;
    look.u = u;
    // Ranges near the ends go as the root of the angle, which becomes a line in u.
    look.launch_rad = low_rad_ + (high_rad_ - low_rad_) * (u * u * (3 - 2 * u));
    look.slope_factor = -Sin(look.launch_rad) / column_.speed_mps(column_.source()) *
                        (high_rad_ - low_rad_) * 6 * u * (1 - u);
    look.parts = column_.PartsAt(look.launch_rad, kind_, false);
    return look;
  }

  void SearchInterval(double low_rad, double high_rad) {
    if (!(high_rad > low_rad)) return;
    low_rad_ = low_rad;
    high_rad_ = high_rad;
    kind_ = column_.KindAt((low_rad + high_rad) / 2);
    if (!kind_.reaches) return;
    const int looks = kMinLooks + static_cast<int>((high_rad - low_rad) / kLongestLook_rad);
    Look before = LookAt(kEnd);
    for (int i = 1; i <= looks; ++i) {
      const Look after = LookAt(i == looks ? 1 - kEnd : static_cast<double>(i) / looks);
      for (const History& history : HistoriesBetween(receiver_is_deeper_)) {
        if (history.ups + history.downs == 0 && column_.IsStraightBetween()) {
          SearchCycles(before, after, history, 1);
        } else if (history.ups + history.downs + history.betweens > 0) {
          SearchCycles(before, after, history, 0);
        }
      }
      before = after;
    }
  }

  void SearchCycles(const Look& a, const Look& b, const History& first, int cycles) {
    for (;; ++cycles) {
      const History history = first.WithCycles(cycles);
      if ((history.ups + history.downs) / 2 > limits_.max_bounces) return;
      const double above_a = a.RangeOf(history) - range_m_;
      const double above_b = b.RangeOf(history) - range_m_;
      if ((above_a < 0) != (above_b < 0)) {
        Refine(a, b, history);
        continue;
      }
      const bool both_beyond = above_a >= 0;
      const double toward_a = (both_beyond ? 1 : -1) * a.SlopeOf(history);
      const double toward_b = (both_beyond ? 1 : -1) * b.SlopeOf(history);
      // The range between the two comes nearer to what is looked for, and goes away again.
      const bool has_extremum = toward_a < 0 && toward_b > 0;
      if (has_extremum &&
          MayReach(std::abs(above_a), std::abs(above_b), toward_a, toward_b, b.u - a.u)) {
        const Look extremum = FindExtremum(a, b, history);
        if ((extremum.RangeOf(history) - range_m_ < 0) == both_beyond) {
          Refine(a, extremum, history);
          Refine(extremum, b, history);
        }
        continue;
      }
      if (both_beyond) return;  // And further with more cycles.
    }
  }

  /// Whether a curve with these values > 0 and slopes at two looks may fall to 0 in between: twice
  /// as far down as the tangents meet.
  static bool MayReach(double a, double b, double slope_a, double slope_b, double width) {
    const double meet = (b - a - slope_b * width) / (slope_a - slope_b);
    const double lowest = a + slope_a * std::clamp(meet, 0.0, width);
    return 2 * lowest - std::min(a, b) <= 0;
  }

  Look FindExtremum(Look a, Look b, const History& history) const {
    const bool falls_first = a.SlopeOf(history) < 0;
    for (int i = 0; i < kMaxRefinements; ++i) {
      const double middle = (a.u + b.u) / 2;
      if (!(middle > a.u && middle < b.u)) break;
      const Look look = LookAt(middle);
      ((look.SlopeOf(history) < 0) == falls_first ? a : b) = look;
    }
    return a;
  }

  /// Newton's method on (range - wanted) / (range + wanted), which is bounded, within a bracket.
  void Refine(Look a, Look b, const History& history) {
    const bool a_is_short = a.RangeOf(history) < range_m_;
    Look look = LookAt((a.u + b.u) / 2);
    for (int i = 0; i < kMaxRefinements; ++i) {
      const double range_m = look.RangeOf(history);
      ((range_m < range_m_) == a_is_short ? a : b) = look;
      const double slope = look.SlopeOf(history);
      const double step = -(range_m - range_m_) * (range_m + range_m_) / (2 * range_m_) / slope;
      double next = look.u + step;
      if (!(next > std::min(a.u, b.u) && next < std::max(a.u, b.u))) next = (a.u + b.u) / 2;
      const bool is_done = std::abs(range_m - range_m_) <= 1e-11 * range_m_ || next == look.u ||
                           next == a.u || next == b.u;
      if (is_done) break;
      look = LookAt(next);
    }
    AddArrival(look.launch_rad, history);
  }

  /// The straight path in water of constant speed, which has no turn to count.
  void AddStraight() {
    const double c = column_.speed_mps(column_.source());
    RayArrival arrival;
    arrival.length_m = Hypot(range_m_, depth_difference_m_);
    arrival.delay_s = arrival.length_m / c;
    arrival.amplitude = 1 / arrival.length_m;
    arrival.launch_rad = arrival.arrive_rad = Atan2(depth_difference_m_, range_m_);
    arrival.spread_m = arrival.length_m * arrival.length_m / range_m_;
    if (std::abs(arrival.launch_rad) <= limits_.max_launch_rad) arrivals_.push_back(arrival);
  }

  void AddArrival(double launch_rad, const History& history) {
    RayArrival arrival;
    const RayParts parts = column_.PartsAt(launch_rad, kind_, true);
    const auto sum = [&](double PathSum::*what) {
      return history.ups * (parts.up.*what) + history.betweens * (parts.between.*what) +
             history.downs * (parts.down.*what);
    };
    const double range_m = sum(&PathSum::range_m);
    // d time / d range along the family of rays is p: what the root lacks in range.
    arrival.delay_s = sum(&PathSum::time_s) + parts.p * (range_m_ - range_m);
    arrival.length_m = sum(&PathSum::length_m);
    const double slope = sum(&PathSum::slope);
    const double sine_source = Sin(launch_rad);
    const double sine_receiver = column_.SineAt(column_.receiver(), launch_rad);
    const double c_receiver = column_.speed_mps(column_.receiver());
    arrival.launch_rad = history.starts_down ? launch_rad : -launch_rad;
    arrival.arrive_rad =
        Atan2(history.ends_down ? sine_receiver : -sine_receiver, parts.p * c_receiver);
    AddReflections(launch_rad, history, parts, &arrival);
    if (arrival.reflection < limits_.min_reflection ||
        arrival.num_surface + arrival.num_bottom > limits_.max_bounces) {
      return;
    }
    const double tube = std::abs(slope) * sine_source * sine_receiver;
    arrival.spread_m = tube / (column_.speed_mps(column_.source()) * parts.p * c_receiver);
    arrival.amplitude =
        arrival.reflection * std::sqrt(parts.p * column_.speed_mps(column_.source()) * c_receiver /
                                       (range_m_ * std::max(tube, 1e-300)));
    arrivals_.push_back(arrival);
  }

  /// Reflections, and caustics: the tube of rays around this one closes where d range / d p is 0.
  /// That grows along the way, to infinity at a turn, and comes back from minus infinity.
  void AddReflections(double launch_rad, const History& history, const RayParts& parts,
                      RayArrival* arrival) const {
    const int num_above = history.ups / 2;
    const int num_below = history.downs / 2;
    arrival->num_surface = kind_.turns_above ? 0 : num_above;
    arrival->num_bottom = kind_.turns_below ? 0 : num_below;
    double phase_rad = 0;
    const auto reflect = [&](const Reflector& reflector, size_t vertex, int count) {
      if (count == 0) return;
      const double grazing_rad =
          Atan2(column_.SineAt(vertex, launch_rad), parts.p * column_.speed_mps(vertex));
      const Reflection once = Reflect(reflector, grazing_rad,
                                      {.speed_mps = column_.speed_mps(vertex),
                                       .hz = scene_.hz,
                                       .density = scene_.water_density});
      for (int i = 0; i < count; ++i) arrival->reflection *= once.magnitude;
      phase_rad += count * once.phase_rad;
    };
    reflect(scene_.surface_reflector, column_.surface(), arrival->num_surface);
    reflect(scene_.bottom_reflector, column_.bottom(), arrival->num_bottom);
    arrival->num_caustics = NumCaustics(history, parts);
    phase_rad += arrival->num_caustics * std::numbers::pi / 2;
    arrival->phase_rad = WrappedPhase(phase_rad);
  }

  int NumCaustics(const History& history, const RayParts& parts) const {
    const double whole = parts.up.slope + parts.between.slope + parts.down.slope;
    const int num_turns = (history.ups + history.downs) / 2;
    const bool source_is_upper = receiver_is_deeper_;
    // From the source to its first turn: past the receiver's depth where that lies on the way.
    const bool passes = history.starts_down == source_is_upper;
    double slope = (history.starts_down ? parts.down.slope : parts.up.slope) +
                   (passes ? parts.between.slope : 0);
    bool is_below = history.starts_down;
    bool starts_negative = false;
    int count = 0;
    for (int i = 0; i < num_turns; ++i) {
      const bool turns = is_below ? kind_.turns_below : kind_.turns_above;
      if (starts_negative && (turns || slope > 0)) ++count;
      starts_negative = turns || slope < 0;
      is_below = !is_below;
      if (i + 1 < num_turns) slope += whole;
    }
    if (num_turns == 0) return 0;
    const double last = history.ups * parts.up.slope + history.betweens * parts.between.slope +
                        history.downs * parts.down.slope;
    return count + (starts_negative && last > 0 ? 1 : 0);
  }

  const RayScene& scene_;
  const RayLimits& limits_;
  double range_m_;
  bool receiver_is_deeper_;
  RayColumn column_;
  double depth_difference_m_;
  double low_rad_ = 0;
  double high_rad_ = 0;
  RayColumn::Kind kind_;
  std::vector<RayArrival> arrivals_;
};

}  // namespace

std::vector<RayArrival> FindLayeredRays(const RayScene& scene, const SectionPoint& source,
                                        const SectionPoint& receiver, const RayLimits& limits) {
  return LayeredSearch(scene, source, receiver, limits).Run();
}

}  // namespace shoal
