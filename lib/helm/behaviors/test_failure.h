// Fails when it completes, so that a user can test what becomes of the others.
#pragma once

#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "test_failure". Fails when it completes, so that a user can test what becomes of the
/// others.
struct TestFailureOptions {
  static constexpr std::string_view kKind = "test_failure";

  std::string failure_type = "crash";  ///< crash or burn (a busy helm).
  double burn_time = 3;                ///< s of mission time.

  bool operator==(const TestFailureOptions&) const = default;
};

/// Fails where its duration ends. Never in a mission that is to succeed.
class TestFailureBehavior final : public BehaviorWith<TestFailureOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs&) override { return {}; }
  /// Answers `crashes` or `busy_s`: what becomes of the process is the helm's business.
  BehaviorAnswer Complete(const BehaviorInputs& inputs) override;
};

}  // namespace shoal
