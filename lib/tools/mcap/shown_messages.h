// What an MCAP file has beside the log's own messages, so that its reader shows the mission at
// once.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "lib/bus/record/log_format.h"
#include "lib/bus/record/message_types.h"
#include "lib/tools/mcap/foxglove.h"
#include "lib/tools/view/fate_facts.h"
#include "shoal/helm_state_t.hpp"

namespace shoal {

/// Which of the schemas of lib/tools/mcap/foxglove.h a channel has.
enum class ShownKind { kLocation, kPose, kLog };

/// Makes these messages:
///
///   foxglove/location/<V>  LocationFix of each NAV_<V> whose position is finite
///   foxglove/pose/<V>      PoseInFrame of the same
///   foxglove/fates         Log of each fate: level DEBUG where it was delivered, else INFO
///   foxglove/events        Log of changes of helms (WARNING: an all-stop), of commands and
///   controls
class McapShownMessages {
 public:
  /// Takes one message: its channel's topic and kind, and what appends its bytes. Returns false
  /// where no more are wanted.
  using Sink = std::function<bool(ShownKind kind, std::string_view topic,
                                  const std::function<void(std::string*)>& append)>;

  explicit McapShownMessages(const Schema& schema) : schema_(schema) {}

  /// Gives `sink` what follows from a message of the log. Returns false where the sink did.
  /// @pre message.IsDecodable()
  [[nodiscard]] bool Add(const LogEvent& event, const RecognisedMessage& message, const Sink& sink);

 private:
  bool AddNav(std::string_view vehicle, const RecognisedMessage& message, const Sink& sink);
  bool AddFates(const LogEvent& event, const RecognisedMessage& message, const Sink& sink);
  bool AddHelm(const LogEvent& event, std::string_view vehicle, const RecognisedMessage& message,
               const Sink& sink);
  static bool AddEvent(const LogEvent& event, LogLevel level, std::string_view name,
                       const std::string& text, const Sink& sink);

  const Schema& schema_;
  nav_t nav_{};
  FatesView fates_;
  std::string topic_;
  std::map<std::string, helm_state_t, std::less<>> helms_;  ///< As they last were.
};

}  // namespace shoal
