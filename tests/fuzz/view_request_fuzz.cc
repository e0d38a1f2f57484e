// Any bytes as what comes to the viewer: the head of a request and its body. First a letter for its
// kind: h a head, b a command's body, q a query ("name=value&..."), o a Host.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "apps/viewer/access.h"
#include "apps/viewer/http_head.h"
#include "apps/viewer/view_request.h"
#include "lib/base/check/check.h"

namespace shoal {
namespace {

QueryWords WordsOf(std::string_view text) {
  QueryWords words;
  while (!text.empty()) {
    const std::string_view pair = text.substr(0, text.find('&'));
    text.remove_prefix(std::min(pair.size() + 1, text.size()));
    const size_t equals = pair.find('=');
    words.emplace(pair.substr(0, equals),
                  equals == std::string_view::npos ? "" : pair.substr(equals + 1));
  }
  return words;
}

void TryHead(std::string_view bytes) {
  const CheckedHead checked = CheckHead(bytes);
  if (checked.status != 200) {
    SHOAL_CHECK(checked.head.empty() && checked.message.empty() == (checked.status == 0),
                "a refusal has a message");
    return;
  }
  SHOAL_CHECK(checked.size <= bytes.size() && checked.size <= kMaxHeadBytes, "it has an end");
  SHOAL_CHECK(checked.head.ends_with("\r\n\r\n"), "what is left is a head");
  const CheckedHead again = CheckHead(checked.head);
  SHOAL_CHECK(again.status == 200 && again.size == checked.head.size(), "and a sound one");
  SHOAL_CHECK(again.keeps_alive == checked.keeps_alive, "that means the same");
}

void TryQuery(const QueryWords& query) {
  if (const auto time = ParseTimeQuery(query); time.ok()) {
    SHOAL_CHECK(std::isfinite(*time), "a time is a number");
  }
  if (const auto link = ParseLinkQuery(query); link.ok()) {
    SHOAL_CHECK(!link->from.empty() && link->to.size() <= 64, "a name is a name");
  }
  if (const auto vehicle = ParseVehicleQuery(query); vehicle.ok()) {
    SHOAL_CHECK(vehicle->window_s >= 1 && vehicle->window_s <= 3600, "a window has its bounds");
  }
  if (const auto fates = ParseFateQuery(query); fates.ok()) {
    SHOAL_CHECK(fates->fates.limit >= 1 && fates->fates.limit <= 500, "a limit has its bounds");
    SHOAL_CHECK(fates->fates.after >= -1 && std::isfinite(fates->t_s), "so have the others");
  }
}

}  // namespace
}  // namespace shoal

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0]) {
    case 'h':
      shoal::TryHead(bytes);
      break;
    case 'b':
      if (const auto command = shoal::ParseCommandBody(bytes); command.ok()) {
        SHOAL_CHECK(!command->target.empty() && command->words.size() <= 64, "it has its bounds");
      }
      break;
    case 'q':
      shoal::TryQuery(shoal::WordsOf(bytes));
      break;
    case 'o':
      // A name of the world wide web is never taken for this machine.
      SHOAL_CHECK(!shoal::IsOwnHost(std::string(bytes) + "x.example", {}), "a foreign name");
      (void)shoal::IsOwnHost(bytes, {"shore"});
      break;
    default:
      break;
  }
  return 0;
}
