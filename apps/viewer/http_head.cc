#include "apps/viewer/http_head.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "apps/viewer/access.h"
#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

namespace {

constexpr std::array<std::string_view, 6> kKnownHeaders = {
    "host", "origin", "sec-fetch-site", "x-shoal-token", "content-type", "content-length"};

CheckedHead Refused(int status, std::string message) {
  return {.status = status, .message = std::move(message)};
}

bool IsNameCharacter(char each) {
  const auto code = static_cast<unsigned char>(each);
  return (code >= '0' && code <= '9') || (code >= 'A' && code <= 'Z') ||
         (code >= 'a' && code <= 'z') || each == '-' || each == '_' || each == '.';
}

/// Visible ASCII, blanks and what lies beyond ASCII.
bool IsText(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char each) {
    const auto code = static_cast<unsigned char>(each);
    return (code >= 0x20 && code != 0x7f) || each == '\t';
  });
}

std::string_view Trimmed(std::string_view text) {
  const size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

struct RequestLine {
  std::string_view method;
  std::string_view target;
  std::string_view version;
};

CheckedHead CheckRequestLine(std::string_view line, RequestLine* parts) {
  if (line.size() > kMaxTargetBytes) return Refused(414, "the address is too long");
  const size_t first = line.find(' ');
  const size_t last = line.rfind(' ');
  if (first == std::string_view::npos || first == last || !IsText(line)) {
    return Refused(400, "this is not an HTTP request");
  }
  *parts = {line.substr(0, first), line.substr(first + 1, last - first - 1), line.substr(last + 1)};
  if (parts->version != "HTTP/1.1" && parts->version != "HTTP/1.0") {
    return Refused(400, "this server supports HTTP/1.1");
  }
  if (!parts->target.starts_with('/') || parts->target.find(' ') != std::string_view::npos) {
    return Refused(400, "a path begins with / and holds no blank");
  }
  if (parts->method.empty() ||
      !std::all_of(parts->method.begin(), parts->method.end(), IsNameCharacter)) {
    return Refused(400, "this is not an HTTP request");
  }
  if (parts->method != "GET" && parts->method != "HEAD" && parts->method != "POST") {
    return Refused(405, "this server has GET, HEAD and POST");
  }
  return {.status = 200};
}

/// Takes the header lines one by one, and keeps those that the viewer uses.
class HeaderLines {
 public:
  int64_t content_length = -1;  ///< Negative: not given.
  bool asks_to_close = false;
  bool asks_to_stay = false;
  std::string kept;

  CheckedHead Take(std::string_view line) {
    if (++num_lines_ > kMaxHeaders) return Refused(431, "too many headers");
    const size_t colon = line.find(':');
    if (colon == std::string_view::npos || colon == 0 || !IsText(line) ||
        !std::all_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(colon),
                     [](char each) { return each > ' '; })) {
      return Refused(400, "a header is not of the form Name: value");
    }
    const std::string name = LowerCase(line.substr(0, colon));
    const std::string_view value = Trimmed(line.substr(colon + 1));
    if (name == "transfer-encoding") {
      return Refused(400, "send the body with Content-Length instead of Transfer-Encoding");
    }
    if (name == "connection") {
      const std::string words = LowerCase(value);
      asks_to_close = asks_to_close || words.find("close") != std::string::npos;
      asks_to_stay = asks_to_stay || words.find("keep-alive") != std::string::npos;
    }
    if (std::find(kKnownHeaders.begin(), kKnownHeaders.end(), name) == kKnownHeaders.end()) {
      return {.status = 200};
    }
    if (std::find(seen_.begin(), seen_.end(), name) != seen_.end()) {
      return Refused(400, "the header " + name + " comes twice");
    }
    seen_.push_back(name);
    if (name == "content-length") {
      const auto [end, error] =
          std::from_chars(value.data(), value.data() + value.size(), content_length);
      if (error == std::errc::result_out_of_range) return TooLarge();
      if (error != std::errc() || end != value.data() + value.size() || content_length < 0) {
        return Refused(400, "Content-Length is not a number");
      }
      if (content_length > static_cast<int64_t>(kMaxBodyBytes)) return TooLarge();
    }
    // The limit keeps cpp-httplib from reading a name and a value out of something longer.
    constexpr size_t kLongestValue = 1024;
    if (value.size() > kLongestValue) return Refused(431, "the header " + name + " is too long");
    kept.append(name).append(": ").append(value).append("\r\n");
    return {.status = 200};
  }

 private:
  static CheckedHead TooLarge() { return Refused(413, "a body has at most 65536 bytes"); }

  size_t num_lines_ = 0;
  std::vector<std::string> seen_;
};

}  // namespace

CheckedHead CheckHead(std::string_view bytes) {
  const size_t end = bytes.find("\r\n\r\n");
  if (end == std::string_view::npos || end + 4 > kMaxHeadBytes) {
    if (bytes.size() >= kMaxHeadBytes) {
      return bytes.substr(0, kMaxHeadBytes).find("\r\n") == std::string_view::npos
                 ? Refused(414, "the address is too long")
                 : Refused(431, "the headers are longer than 16384 bytes");
    }
    return {};
  }
  const std::string_view head = bytes.substr(0, end + 2);
  const size_t line_end = head.find("\r\n");
  RequestLine request;
  if (CheckedHead checked = CheckRequestLine(head.substr(0, line_end), &request);
      checked.status != 200) {
    return checked;
  }
  HeaderLines headers;
  for (size_t begin = line_end + 2; begin < head.size();) {
    const size_t next = head.find("\r\n", begin);
    if (CheckedHead checked = headers.Take(head.substr(begin, next - begin));
        checked.status != 200) {
      return checked;
    }
    begin = next + 2;
  }
  if (request.method == "POST" && headers.content_length < 0) {
    return Refused(400, "a POST needs Content-Length");
  }
  CheckedHead sound = {.status = 200, .size = end + 4};
  // The connection closes after a request whose body may stay unread, or whose answer ends with it.
  sound.keeps_alive = request.method != "POST" && headers.content_length <= 0 &&
                      !headers.asks_to_close &&
                      (request.version == "HTTP/1.1" || headers.asks_to_stay) &&
                      request.target.substr(0, request.target.find('?')) != kStreamPath;
  sound.head.append(request.method).append(" ").append(request.target).append(" ");
  sound.head.append(request.version).append("\r\n").append(headers.kept);
  sound.head.append(sound.keeps_alive ? "connection: Keep-Alive\r\n\r\n"
                                      : "connection: close\r\n\r\n");
  return sound;
}

}  // namespace shoal
