// Finds the encounters of any number of vessels from where they are, step by step.
//
//   EncounterWatch watch(options);
//   watch.Look(12.5, samples);            // in order of time
//   for (const Encounter& each : watch.Encounters()) Use(ScoreOf(each, 0, options));
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "lib/helm/encounters/encounter.h"

namespace shoal {

/// One vessel at one time. Numbers are finite.
struct VesselSample {
  bool is_seen = false;
  VesselMotion motion = {};  ///< Heading and speed relative to the water.
  double depth_m = 0;
  double length_m = 3;
};

class EncounterWatch {
 public:
  /// More encounters at one time, or ended ones, are left out.
  static constexpr size_t kMax = 100'000;

  explicit EncounterWatch(const EncounterOptions& options = {}) : options_(options) {}

  /// Takes all vessels at `time_s`. A vessel has the same index in each look; new ones are
  /// appended. A look that is not later than the last is ignored. Sorts the vessels along the
  /// longer side of the area, and compares only those that are near each other along it.
  void Look(double time_s, std::span<const VesselSample> vessels);

  /// Returns all encounters in order of their begin; those that are not over as they stand now.
  [[nodiscard]] std::vector<Encounter> Encounters() const;

  const EncounterOptions& options() const { return options_; }
  /// False where encounters were left out.
  bool is_complete() const { return is_complete_; }

 private:
  using Pair = std::pair<uint32_t, uint32_t>;

  /// One vessel's part while the encounter goes on.
  struct OpenSide {
    Conduct conduct = {};          ///< Up to now.
    double course_change_deg = 0;  ///< Since entry, not wrapped.
    double speed_change_share = 0;
    double last_heading_deg = 0;
    /// The turn that goes on is none for the other: the encounter began in it, or there was no risk
    /// of collision (IsRisk) when it began.
    bool turns_freely = true;
    double turned_from_deg = 0;  ///< Course change from which a turn for the other counts.
    double last_turning_s = 0;
    double last_alpha_deg = 0;  ///< (-180, 180].
    double last_range_m = 0;
    bool is_in_extremis = false;            ///< At the last look.
    double extremis_course_change_deg = 0;  ///< When in extremis began.
    double extremis_speed_change_share = 0;
  };
  struct Open {
    Encounter encounter;
    OpenSide sides[2];
    Eigen::Vector2d offset_m = Eigen::Vector2d::Zero();  ///< From first to second, last look.
    double opening_since_s = -1;                         ///< < 0: they close.
  };

  void FindDuties(size_t num_vessels);
  bool Update(double time_s, std::span<const VesselSample> vessels, Open* open) const;
  void UpdateSide(double time_s, const VesselSample& own, const RelativeGeometry& geometry,
                  bool must_keep_clear, bool other_keeps_clear, EncounterSide* side,
                  OpenSide* now) const;
  void Begin(double time_s, std::span<const VesselSample> vessels, uint32_t first, uint32_t second);
  void FindBegins(double time_s, std::span<const VesselSample> vessels);
  void Keep(Encounter encounter);

  struct Place {
    double along_m;
    uint32_t vessel;
  };

  EncounterOptions options_;
  double last_s_ = 0;
  bool has_looked_ = false;
  std::map<Pair, Open> open_;
  std::vector<Encounter> ended_;
  bool is_complete_ = true;
  std::vector<Place> places_;
  /// What a vessel has to do now, in all its encounters.
  struct Duties {
    bool keeps_clear = false;  ///< Of some other, by its role.
    int num_in_extremis = 0;   ///< Encounters in which it stands on, and must act by rule 17 (b).
  };
  std::vector<Duties> duties_;
};

}  // namespace shoal
