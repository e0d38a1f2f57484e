// A value, or the reason why there is none.
//
//   Result<Mission> mission = LoadMission(path);
//   if (!mission.ok()) return Fail(mission.error());
//   Use(*mission);
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "lib/base/check/check.h"

namespace shoal {

/// What went wrong, for the person who can fix it: what, where, what to try.
struct Error {
  std::string message;
};

/// Holds a T or an Error.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}  // NOLINT: implicit, so that `return value;` works
  Result(Error error) : state_(std::move(error)) {}  // NOLINT: implicit

  bool ok() const { return std::holds_alternative<T>(state_); }
  /// @pre !ok()
  const std::string& error() const {
    SHOAL_CHECK(!ok(), "error() of a Result that holds a value");
    return std::get<Error>(state_).message;
  }
  /// @pre ok()
  T& operator*() {
    SHOAL_CHECK(ok(), "value of a Result that holds an error");
    return std::get<T>(state_);
  }
  const T& operator*() const {
    SHOAL_CHECK(ok(), "value of a Result that holds an error");
    return std::get<T>(state_);
  }
  T* operator->() { return &**this; }
  const T* operator->() const { return &**this; }

 private:
  std::variant<T, Error> state_;
};

/// What the process ends with: docs/inside/design.md, "Exit codes".
enum ExitCode : int {
  kExitOk = 0,
  kExitMissionFailed = 1,  ///< The mission ran, and missed its own success criteria.
  kExitUsage = 2,          ///< The command line or the mission file is wrong.
  kExitEnvironment = 3,    ///< The machine: no multicast, port taken, disk full, messages lost.
};

}  // namespace shoal
