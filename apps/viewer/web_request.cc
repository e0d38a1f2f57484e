#include "apps/viewer/web_request.h"

#include <nlohmann/json.hpp>

namespace shoal {

WebAnswer ErrorAnswer(int status, const std::string& message) {
  // The message may hold bytes of the request that are not valid UTF-8.
  const nlohmann::json json = {{"error", message}};
  return {.status = status,
          .body = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

}  // namespace shoal
