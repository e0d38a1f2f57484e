// Publishes on COMMS_FATES what became of every transmission.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/fate.h"

namespace shoal {

class FateWriter {
 public:
  /// Fits one datagram (64 KB) where names are of common length: LCM loses a message that it had to
  /// cut with any of its datagrams.
  static constexpr int32_t kMaxFatesPerMessage = 400;
  /// The same for acoustic transmissions, which are larger.
  static constexpr int32_t kMaxPathsPerMessage = 150;

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
  Bus& bus_;
  const OnFates on_fates_;
  const Channel<comms_fates_t> channel_ = channels::CommsFates();
  int32_t num_paths_ = 0;
  comms_fates_t message_;  ///< Keeps its strings' memory: only the first num_fates are meant.
};

}  // namespace shoal
