// Publishes on COMMS_FATES what became of every transmission, as columns
// (lcmtypes/shoal_comms_fate_columns_t.lcm).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/fate.h"

namespace shoal {

class FateWriter {
 public:
  /// A message is published before it is larger, so that it fits one datagram (64 KB): LCM loses a
  /// message that it had to cut with any of its datagrams.
  static constexpr size_t kMaxMessage_bytes = 60'000;

  using OnFates = std::function<void(std::span<const fate_t>)>;

  /// `on_fates`, where given, is called with what is published.
  explicit FateWriter(Bus& bus, OnFates on_fates = {});

  /// Adds one fate; publishes when the message is full. `destination` is not asked for where the
  /// decision counts several together. `path`, where it was sent acoustically.
  void Add(int64_t utime, const Decision& decision, std::string_view source,
           std::string_view destination, const acoustic_path_t* path = nullptr);

  /// Publishes what was added since the last message, if anything.
  void Flush(int64_t utime);

 private:
  /// What fates of one case have in common. Numbers count by their bits.
  struct Case {
    Cause cause;
    OverrideRule override_rule;
    bool has_range;
    bool has_wait;
    bool has_count;
    bool has_path;
    int32_t length_bytes;
    int32_t length_limit_bytes;
    uint64_t limit_m;
    uint64_t age_s;
    uint64_t age_limit_s;
    uint64_t loss_pct;

    bool operator==(const Case&) const = default;
  };
  struct HashOfCase {
    size_t operator()(const Case& of) const;
  };

  void AddSender(const Decision& decision, std::string_view source);
  int16_t CaseOf(const Decision& decision, bool has_path);
  int16_t NameOf(int32_t contact, std::string_view name);

  Bus& bus_;
  const OnFates on_fates_;
  const Channel<comms_fate_columns_t> channel_ = channels::CommsFateColumns();
  comms_fate_columns_t message_;
  comms_fates_t list_;  ///< Of message_, for on_fates_.
  size_t num_bytes_ = 0;

  // Of message_.
  Case last_case_ = {};
  int16_t last_case_index_ = -1;
  std::unordered_map<Case, int16_t, HashOfCase> cases_;
  std::vector<int16_t> name_of_contact_;  ///< -1: not yet.
  std::map<std::string, int16_t, std::less<>> names_;
};

}  // namespace shoal
