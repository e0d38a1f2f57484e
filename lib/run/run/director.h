// What the launcher asks of the participant "shoal", which carries the mission's events out and
// judges its expectations (sim/director_app.h): so that lib/run/launch knows no app.
#pragma once

#include <cstdint>
#include <string>

#include "lib/bus/bus/bus.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/app.h"

namespace shoal {

class Director : public App {
 public:
  /// Node reports so far, each counted once per destination.
  virtual int64_t num_delivered() const = 0;
  virtual int64_t num_blocked() const = 0;

  /// Returns the mission's last page, should it end now; its last line is PASS or FAIL, or
  /// INCOMPLETE where the mission is not `complete`.
  virtual std::string Summary(bool complete) const = 0;
  /// Returns the same for other programs, the mission having ended at `end_s`: TextOf
  /// (lib/run/verdict/mission_verdict.h).
  virtual std::string VerdictText(double end_s, bool complete) const = 0;
  /// Returns true from the step on after which the mission ends before its time: the tasks of all
  /// vehicles with end_of_tasks = "end_mission" are done.
  virtual bool EndsMission() const = 0;
  /// Returns true where the mission would pass, should it end now: every expectation met, and no
  /// collision that [mission] collisions does not allow.
  virtual bool Passed() const = 0;
};

}  // namespace shoal
