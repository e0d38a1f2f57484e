#include "lib/behaviors/test_failure.h"

#include <cstdlib>

namespace shoal {

BehaviorAnswer TestFailureBehavior::Complete(const BehaviorInputs&) {
  if (options_.failure_type == "crash") std::abort();
  BehaviorAnswer answer;
  answer.busy_s = options_.burn_time;
  answer.warning = "test_failure keeps the helm busy";
  return answer;
}

}  // namespace shoal
