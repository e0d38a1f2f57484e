// One vehicle of an imported mission: collects what several lines of its MOOS file set.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/tools/moos/import_behaviors.h"
#include "lib/tools/moos/import_settings.h"
#include "lib/tools/moos/mission_draft.h"
#include "lib/tools/moos/moos_file.h"
#include "lib/tools/moos/thrust_import.h"

namespace shoal {

/// A behavior of the kind timer that sets a variable.
struct ScriptTimer {
  std::vector<std::string> conditions;
  double duration_s = 0;  ///< While the conditions hold.
  std::string flag;       ///< "\"GO=true\"", as TOML.
  bool is_repeated = false;
  std::string origin;
  std::string remark;
};

class VehicleImport {
 public:
  /// `remark` is the comment above its name. `is_imported` is false for an invented vehicle. With
  /// `is_underwater` it becomes a Remus 100.
  VehicleImport(size_t number, std::string name, std::string remark, bool is_imported,
                bool is_underwater);

  /// Gives it the behaviors of its file.
  void SetBehaviors(BhvImport behaviors) { behaviors_ = std::move(behaviors); }

  /// Sets variables where the vehicle is deployed, as a button does that posts more than DEPLOY: as
  /// their first values, since a helm does nothing before, and by a behavior each time. `settings`:
  /// names and values.
  void SetWithDeploy(const std::vector<std::pair<std::string, std::string>>& settings,
                     const std::string& origins);

  /// @pre before AddTables().
  void AddTimer(const ScriptTimer& timer);

  /// `deploy` leaves its variable STATION_KEEP alone, as the mission's own button does.
  void KeepStation(std::string origins) { station_origins_ = std::move(origins); }

  /// Adds the tables of the vehicle, with its name.
  /// @pre called once, before what follows; `draft` outlives this.
  void AddTables(MissionDraft* draft);
  /// Adds the table of its events, which stand behind all vehicles.
  void AddEvents();

  /// Takes a line that has a meaning together with others, or a form of its own: where it starts,
  /// its thrust map and fastest speed, its drift, what its helm decides about, its own fields of
  /// node reports. Returns false for any other.
  bool Take(std::string_view app_class, const std::string& origin, const MoosLine& line,
            std::vector<std::string>* warnings);

  /// Its file has a block of uSimMarine, whose defaults are not those of shoal. `turns_by_speed`:
  /// as versions from V22 on do.
  void SetHasSim(bool turns_by_speed) {
    has_sim_ = true;
    turns_by_speed_ = turns_by_speed;
  }

  /// Writes what Take() gathered.
  void Finish();

  const std::string& name() const { return name_; }
  /// What its behaviors make of it; empty where SetBehaviors() was not called.
  const BhvImport& behaviors() const { return behaviors_; }
  bool is_imported() const { return is_imported_; }
  bool is_underwater() const { return is_underwater_; }
  /// The draft's table [[vehicle]] of this one.
  const std::string& table() const { return id_; }
  std::string TableOf(SettingPlace place) const;
  /// Where lines of this app belong that are not settings.
  std::string TableOfApp(std::string_view app_class) const;

 private:
  /// A key of the mission file made of several lines.
  struct Gathered {
    std::map<std::string, std::string> members;
    DraftOrigins lines;
  };

  void SetFirstValue(const std::string& name, const std::string& value, const std::string& origins);
  bool TakeSim(std::string_view key, const std::string& origin, const MoosLine& line,
               std::vector<std::string>* warnings);
  bool TakeStart(const std::string& origin, const MoosLine& line,
                 std::vector<std::string>* warnings);
  bool TakeDrift(std::string_view key, const std::string& origin, const MoosLine& line);
  bool TakeDomain(const std::string& origin, const MoosLine& line,
                  std::vector<std::string>* warnings);
  void SetSimDefaults();
  bool TakeSpeedFactor(std::string_view app_class, const std::string& origin, const MoosLine& line);
  bool TakeNoLimit(std::string_view key, const std::string& origin, const MoosLine& line);
  void SetGathered(const std::string& table, std::string key, const Gathered& gathered);

  std::string id_;
  std::string name_;
  std::string remark_;
  bool is_imported_;
  bool is_underwater_;
  BhvImport behaviors_;
  int num_timers_ = 0;
  MissionDraft* draft_ = nullptr;
  Gathered start_;
  Gathered extra_;
  DraftOrigins drift_;
  Eigen::Vector2d drift_mps_ = Eigen::Vector2d::Zero();
  ThrustImport thrust_;
  bool has_sim_ = false;  ///< Its file has a block of uSimMarine.
  bool turns_by_speed_ = true;
  std::string station_origins_;  ///< Of the button that deploys and leaves STATION_KEEP alone.
};

}  // namespace shoal
