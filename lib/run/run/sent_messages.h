// What the participants of one process published in the last steps, sealed, for those that missed
// some of it.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/bus.h"

namespace shoal {

class SentMessages {
 public:
  struct Sent {
    std::string publisher;
    std::string channel;
    Bytes datagram;
  };

  /// Begins a step: what is added from now on belongs to it. Forgets all but the step before.
  void BeginStep(int64_t step);

  /// Returns where the next datagram of the step is to be written: `datagram` is empty. Valid until
  /// the next call.
  /// @pre a step has begun
  Sent* Add(std::string_view publisher, std::string_view channel);

  /// True where `publisher` published on `channel` in a step that is kept.
  bool Has(std::string_view publisher, std::string_view channel) const;

  /// Visits what `publisher` published on `channel` in `step`, in order.
  void Visit(int64_t step, std::string_view publisher, std::string_view channel,
             const std::function<void(const Sent&)>& visit) const;

 private:
  struct Step {
    int64_t step = -1;
    size_t num = 0;  ///< The first of `messages` that are of this step; the others are storage.
    std::vector<Sent> messages;
  };
  static constexpr size_t kStepsKept = 2;

  std::deque<Step> steps_;
};

}  // namespace shoal
