// Campaigns and folders for tests.
#pragma once

#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "lib/tools/metrics/trial.h"

namespace shoal {

/// A folder that is removed with this.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string path = (std::filesystem::temp_directory_path() / "campaign_test_XXXXXX").string();
    path_ = mkdtemp(path.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

/// A mission of a vessel that stays where it is, for the fewest steps.
inline constexpr char kShortMission[] =
    "[mission]\nduration_s = 1\n[[vehicle]]\nname = \"alpha\"\ntype = \"kayak\"\n"
    "[[expect]]\nkind = \"arrival\"\nvehicle = \"alpha\"\npoint = [0, 0]\n";

/// Two cases, `repetitions` of each.
inline std::string CampaignText(int64_t repetitions, const std::string& more = "") {
  return "[campaign]\nmission = \"m.toml\"\nrepetitions = " + std::to_string(repetitions) +
         "\n[sweep]\n\"comms.comms_range\" = [100, 200]\n" + more;
}

inline TrialResult PassWith(double value) {
  return {.outcome = TrialOutcome::kPass, .why = "", .metrics = {value}};
}

}  // namespace shoal
