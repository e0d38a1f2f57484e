// A request to the viewer's web server and the answer to it, as plain data: web_server.h
// makes the one of HTTP and sends the other; the code between knows nothing of sockets.
#pragma once

#include <map>
#include <string>

namespace shoal {

/// Decoded `name=value` pairs of a query, repeated names included.
using QueryWords = std::multimap<std::string, std::string>;

struct WebRequest {
  std::string method = {};
  std::string path = {};  ///< Decoded, without the query.
  QueryWords query = {};
  std::string host = {};            ///< The header Host.
  std::string origin = {};          ///< The header Origin, or empty.
  std::string sec_fetch_site = {};  ///< The header Sec-Fetch-Site, or empty.
  std::string token = {};           ///< The header X-Shoal-Token, or empty.
  std::string content_type = {};
  std::string body = {};
};

struct WebAnswer {
  int status = 200;
  std::string content_type = "application/json";
  std::string cache_control = "no-store";
  std::string allow = {};  ///< Of 405: the methods that the path has.
  std::string body = {};
  bool is_stream = false;  ///< Server-sent events from the hub follow instead of the body.
};

/// Returns `{"error": message}` with `status`.
WebAnswer ErrorAnswer(int status, const std::string& message);

}  // namespace shoal
