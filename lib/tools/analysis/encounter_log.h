// The encounters of a log, each vessel's part in them scored, as text and as CSV.
//
//   EncounterLog encounters(options);
//   encounters.Add("ALPHA", nav);         // NAV_<V> of each vehicle, in the order of the log
//   encounters.Finish();
//   print(encounters.Text(SIZE_MAX));
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/encounters/encounter_watch.h"
#include "shoal/helm_decision_t.hpp"
#include "shoal/nav_t.hpp"
#include "shoal/node_report_t.hpp"

namespace shoal {

class EncounterLog {
 public:
  /// Vehicles beyond these are counted and left out.
  static constexpr size_t kMaxVehicles = 2000;

  explicit EncounterLog(const EncounterOptions& options) : watch_(options) {}

  /// Takes where a vehicle truly is; `vehicle` as in the name of its channel. Messages with
  /// impossible numbers, or older than the last of all, are counted and left out. Positions are
  /// compared every 0.1 s at most; closest approaches between are found all the same.
  void Add(std::string_view vehicle, const nav_t& nav);
  /// Takes a vehicle's name, as it is written, and its length; 3 m before the first report.
  void Add(const node_report_t& report);
  /// Takes what a helm judged of its contacts, for comparison.
  void Add(std::string_view vehicle, const helm_decision_t& decision);
  /// After the last message.
  void Finish();

  size_t num_encounters() const { return encounters_.size(); }
  /// Returns one line per encounter and vessel, the lowest scores first where there are more than
  /// `most` encounters.
  [[nodiscard]] std::string Text(size_t most) const;
  /// Returns all numbers of each line of Text().
  [[nodiscard]] std::string Explanation(size_t most) const;
  [[nodiscard]] std::string Csv() const;

  int64_t num_impossible() const { return num_impossible_; }
  int64_t num_late() const { return num_late_; }
  int64_t num_vehicles_left_out() const { return num_vehicles_left_out_; }
  bool is_complete() const { return watch_.is_complete(); }

 private:
  struct Vessel {
    std::string name;
    double seen_s = -1;
  };
  /// What a helm judged a contact to be, from a time on.
  struct Judgement {
    double time_s = 0;
    std::string role;
  };

  size_t FindVessel(std::string_view vehicle);
  void Look();
  std::string NameOf(size_t vessel) const { return vessels_[vessel].name; }
  std::string HelmRole(const Encounter& encounter, size_t side) const;
  std::vector<const Encounter*> Chosen(size_t most) const;
  double LowestScore(const Encounter& encounter) const;

  EncounterWatch watch_;
  std::vector<Vessel> vessels_;
  std::vector<VesselSample> samples_;
  std::map<std::string, size_t, std::less<>> places_;  ///< By key.
  /// By vehicle's and contact's keys; only changes.
  std::map<std::pair<std::string, std::string>, std::vector<Judgement>> judgements_;
  size_t num_judgements_ = 0;
  std::vector<Encounter> encounters_;
  double now_s_ = 0;
  double last_look_s_ = 0;
  bool has_nav_ = false;
  int64_t num_impossible_ = 0;
  int64_t num_late_ = 0;
  int64_t num_vehicles_left_out_ = 0;
};

}  // namespace shoal
