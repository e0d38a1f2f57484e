#include "apps/viewer/access.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "lib/base/check/check.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

namespace {

bool IsPort(std::string_view text) {
  if (text.starts_with('+')) return false;  // ReadNumber takes it; no browser writes it.
  const int port = ReadNumber<int>(text).value_or(-1);
  return port > 0 && port < 65536;
}

bool IsAddress(int family, std::string_view text) {
  std::array<char, sizeof(in6_addr)> address{};
  return inet_pton(family, std::string(text).c_str(), address.data()) == 1;
}

/// The token of a request: of its header, or of a stream's query.
std::string TokenOf(const WebRequest& request) {
  if (request.path != kStreamPath || !request.token.empty()) return request.token;
  const auto found = request.query.find("token");
  return found == request.query.end() ? "" : found->second;
}

bool IsFromOwnPage(const WebRequest& request) {
  if (!request.sec_fetch_site.empty() && request.sec_fetch_site != "same-origin" &&
      request.sec_fetch_site != "none") {
    return false;
  }
  return request.origin.empty() || request.origin == "http://" + request.host ||
         request.origin == "https://" + request.host;  // Behind a TLS proxy.
}

bool IsJson(std::string_view content_type) {
  const std::string_view type = content_type.substr(0, content_type.find(';'));
  const size_t end = type.find_last_not_of(" \t");
  return end != std::string_view::npos && LowerCase(type.substr(0, end + 1)) == "application/json";
}

WebAnswer WrongMethod(std::string_view allow) {
  WebAnswer answer = ErrorAnswer(405, fmt::format("this path has only {}", allow));
  answer.allow = allow;
  return answer;
}

std::optional<WebAnswer> FindCommandDenial(const AccessRules& rules, const WebRequest& request) {
  if (!rules.allow_commands) {
    return ErrorAnswer(403,
                       "this viewer is read-only; to send commands, start it with --allow-commands "
                       "and open the address that it prints");
  }
  if (!TokensMatch(rules.token, TokenOf(request))) {
    return ErrorAnswer(403,
                       "commands need the token of the address that the viewer has printed, as the "
                       "header X-Shoal-Token");
  }
  if (!IsJson(request.content_type)) {
    return ErrorAnswer(400, "a command is JSON: send it with Content-Type: application/json");
  }
  return std::nullopt;
}

}  // namespace

bool IsOwnHost(std::string_view host, const std::vector<std::string>& names) {
  constexpr size_t kLongestName = 255;
  if (host.empty() || host.size() > kLongestName) return false;
  if (host.find('\0') != std::string_view::npos) return false;
  const bool in_brackets = host.front() == '[';
  const size_t colon = in_brackets ? host.find(':', host.find(']')) : host.find(':');
  if (colon != std::string_view::npos) {
    if (!IsPort(host.substr(colon + 1))) return false;
    host = host.substr(0, colon);
  }
  if (in_brackets) {
    return host.size() > 2 && host.back() == ']' &&
           IsAddress(AF_INET6, host.substr(1, host.size() - 2));
  }
  const std::string name = LowerCase(host);
  return name == "localhost" || IsAddress(AF_INET, name) ||
         std::any_of(names.begin(), names.end(),
                     [&](const std::string& own) { return LowerCase(own) == name; });
}

bool TokensMatch(std::string_view token, std::string_view candidate) {
  if (token.empty() || token.size() != candidate.size()) return false;
  unsigned difference = 0;
  for (size_t i = 0; i < token.size(); ++i) {
    difference |= static_cast<unsigned char>(token[i] ^ candidate[i]);
  }
  return difference == 0;
}

bool MaySendCommands(const AccessRules& rules, const WebRequest& request) {
  return rules.allow_commands && TokensMatch(rules.token, TokenOf(request));
}

std::optional<WebAnswer> FindDenial(const AccessRules& rules, const WebRequest& request) {
  if (!IsOwnHost(request.host, rules.names)) {
    return ErrorAnswer(403,
                       "the Host of this request is not a name of this server; use its address in "
                       "numbers, or name it with --listen");
  }
  if (!IsFromOwnPage(request)) {
    return ErrorAnswer(403,
                       "this request comes from a page of another site; open the viewer's own "
                       "address in a new tab");
  }
  const bool is_command = request.path == kCommandPath || request.path == kPlanWritePath ||
                          request.path == kPlanRunPath;
  const bool is_question = request.path == kPlanPath;
  const bool is_read = request.method == "GET" || request.method == "HEAD";
  const bool has_body = is_command || is_question;
  if (has_body && request.method != "POST") return WrongMethod("POST");
  if (!has_body && !is_read) return WrongMethod("GET, HEAD");
  if (is_command) return FindCommandDenial(rules, request);
  if (is_question && !IsJson(request.content_type)) {
    return ErrorAnswer(400, "a question is JSON: send it with Content-Type: application/json");
  }
  // The page's own files are not secret, and a browser asks for them without headers of ours.
  if (rules.reading_needs_token && request.path.starts_with("/api/") &&
      !TokensMatch(rules.token, TokenOf(request))) {
    return ErrorAnswer(403,
                       "this needs the token of the address that the viewer has printed: as the "
                       "header X-Shoal-Token, or for /api/stream as ?token=");
  }
  return std::nullopt;
}

std::string NewToken() {
  std::array<uint8_t, 16> bits{};
  SHOAL_CHECK(getrandom(bits.data(), bits.size(), 0) == static_cast<ssize_t>(bits.size()),
              "the kernel gives no random bits");
  std::string token;
  for (const uint8_t each : bits) token += fmt::format("{:02x}", each);
  return token;
}

}  // namespace shoal
