// Which requests the viewer allows: docs/extending/viewer_protocol.md, "Access".
//
// The server listens on this machine, where any page of the world wide web can reach it through the
// user's own browser. Three headers distinguish such requests from those of the viewer's page: Host
// (a name that its owner lets point at 127.0.0.1: DNS rebinding), Origin and Sec-Fetch-Site.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/viewer/web_request.h"

namespace shoal {

struct AccessRules {
  bool allow_commands = false;
  bool reading_needs_token = false;  ///< The server listens beyond loopback.
  std::string token = {};            ///< Empty: there is none, and nothing that needs one is done.
  std::vector<std::string> names = {};  ///< Host names of the server besides localhost.
};

inline constexpr std::string_view kCommandPath = "/api/command";
inline constexpr std::string_view kPlanPath = "/api/plan";  ///< A question, with a body.
inline constexpr std::string_view kPlanWritePath = "/api/plan/write";
inline constexpr std::string_view kPlanRunPath = "/api/plan/run";
inline constexpr std::string_view kStreamPath = "/api/stream";

/// Returns why `request` is refused, with 400, 403 or 405; nothing: it is allowed. The body is not
/// looked at, and need not have been read.
[[nodiscard]] std::optional<WebAnswer> FindDenial(const AccessRules& rules,
                                                  const WebRequest& request);

/// True where the request's token lets it send commands.
[[nodiscard]] bool MaySendCommands(const AccessRules& rules, const WebRequest& request);

/// Returns true for localhost, any IP address (rebinding needs a name) and `names`, each with or
/// without a port.
[[nodiscard]] bool IsOwnHost(std::string_view host, const std::vector<std::string>& names);

/// Compares in a time that depends on the lengths only. An empty token matches nothing.
[[nodiscard]] bool TokensMatch(std::string_view token, std::string_view candidate);

/// Returns 128 bits from the kernel as 32 hexadecimal digits.
[[nodiscard]] std::string NewToken();

}  // namespace shoal
