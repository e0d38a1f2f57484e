// `shoal doctor --host`: what the way to a host allows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/shoal/doctor.h"

namespace shoal {

struct HostDoctorOptions {
  std::string address;
  std::string public_key;  ///< Of the host: text or a file.
  std::string key_file;    ///< This computer's; empty: HostKeyPath().
  double tick_s = 0.1;
};

/// What was measured.
struct HostFacts {
  std::vector<int64_t> round_trips_us = {};  ///< Of small messages, one after the other.
  std::vector<int64_t> offsets_us = {};      ///< Of the same: the host's clock less this one's.
  int64_t load_bytes = 0;                    ///< Went there and came back ...
  int64_t load_us = 0;                       ///< ... in this time.
};

/// Returns how much the host's clock is ahead, in microseconds, when a request sent at `sent_us` is
/// answered at `there_us` by the host's clock and the answer arrives at `received_us`: the offset
/// of RFC 5905, chapter 8, with one time stamp at the host. Off by half the round trip at most.
[[nodiscard]] int64_t ClockOffset_us(int64_t sent_us, int64_t there_us, int64_t received_us);

/// Judges the facts: round trip and the warp that it allows at steps of `tick_s`, clock,
/// throughput.
/// @pre round_trips_us and offsets_us have the same size, not 0.
[[nodiscard]] std::vector<Diagnosis> DiagnoseHost(const HostFacts& facts, double tick_s);

/// Measures, prints, returns the exit code: kExitUsage without a key, kExitEnvironment where the
/// host cannot be reached or refuses. Takes some five seconds at most on a working network.
int RunHostDoctor(const HostDoctorOptions& options);

}  // namespace shoal
