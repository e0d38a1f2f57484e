// Lines of netsim's protocol: NETSIM|<name of a protobuf message>|<the message in base64>.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "lib/mission/netsim/netsim_request.h"

namespace shoal {

/// Why a line holds no request. None of these has an answer.
enum class NotARequest {
  kBlank,
  kNoMessage,       ///< Not NETSIM|name|data.
  kUnknownMessage,  ///< The name of another message.
  kBadBase64,
  kBadProtobuf,
  kNoId,
};

/// Reads a line without its end.
[[nodiscard]] std::variant<NetsimRequest, NotARequest> ParseRequestLine(std::string_view line);

/// Returns the line that answers request `id`, with its end.
[[nodiscard]] std::string ResponseLine(int32_t id, NetsimStatus status);

}  // namespace shoal
