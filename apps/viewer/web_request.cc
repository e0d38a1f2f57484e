#include "apps/viewer/web_request.h"

#include <nlohmann/json.hpp>

namespace shoal {

WebAnswer ErrorAnswer(int status, const std::string& message) {
  // A stranger's bytes in the message may be no UTF-8.
  const nlohmann::json json = {{"error", message}};
  return {.status = status,
          .body = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

}  // namespace shoal
