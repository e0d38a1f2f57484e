#include "lib/helm/behaviors/test_failure.h"

namespace shoal {

BehaviorAnswer TestFailureBehavior::Complete(const BehaviorInputs&) {
  BehaviorAnswer answer;
  if (options_.failure_type == "crash") {
    answer.crashes = true;
  } else {
    answer.busy_s = options_.burn_time;
    answer.warning = "test_failure keeps the helm busy";
  }
  return answer;
}

}  // namespace shoal
