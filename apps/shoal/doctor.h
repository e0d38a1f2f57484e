// `shoal doctor`: looks at the machine and reports what keeps missions from running here, with
// the commands that fix it. Facts are gathered in one place and judged in another, so that the
// judgement can be tested without a broken machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/run/run/run_registry.h"

namespace shoal {

/// The result of sending messages to this process over LCM.
struct MulticastTrial {
  int sent = 0;
  bool opened = false;  ///< False: there is no route to the multicast group.
  int received = 0;     ///< Within two seconds.
};

/// Facts about this machine. A path is empty, and an optional absent, where there is none.
struct DoctorFacts {
  MulticastTrial multicast;
  bool in_container = false;
  int64_t receive_buffer_limit_bytes = 0;  ///< net.core.rmem_max
  std::vector<RunningMission> running;
  std::optional<int> port_base;  ///< Where the next mission's ports would begin.
  std::string run_folder_error;  ///< Empty, or why missions cannot use it, with the remedy.
  std::string folder;            ///< The current one, where recordings go.
  std::optional<int64_t> folder_free_bytes;
  std::optional<int64_t> max_open_files;  ///< ulimit -n; absent: no limit.
  std::optional<int64_t> max_threads;     ///< ulimit -u and the container's limit; absent: none.
  std::string source_dir;                 ///< Of the repository, where its scripts lie.
  std::string java;
  bool java_has_windows = false;
  bool has_lcm_jar = false;
  bool has_chart_jar = false;
  std::string types_jar;
  bool has_display = false;
};

enum class Health { kOk, kWarn, kFail };

/// The result of one check.
struct Diagnosis {
  Health health = Health::kOk;
  std::string text;
  /// Commands that fix it.
  std::vector<std::string> remedies = {};
};

/// Judges the facts, in the order in which they matter.
[[nodiscard]] std::vector<Diagnosis> Diagnose(const DoctorFacts& facts);

/// Returns a line for each diagnosis, and its remedies.
[[nodiscard]] std::string DiagnosisLines(const std::vector<Diagnosis>& diagnoses);

/// Returns the diagnoses as `shoal doctor` prints them, with a closing line.
[[nodiscard]] std::string FormatDiagnoses(const std::vector<Diagnosis>& diagnoses);

/// Returns kExitEnvironment where something FAILs, kExitOk otherwise.
[[nodiscard]] int DoctorExitCode(const std::vector<Diagnosis>& diagnoses);

/// Gathers the facts, prints the diagnoses, returns the exit code. Takes at most three seconds.
int RunDoctor();

}  // namespace shoal
