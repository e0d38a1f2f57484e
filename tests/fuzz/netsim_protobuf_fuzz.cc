// Any bytes in place of a request's protobuf, in whole lines: a search that need not find base64
// first.
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "lib/base/check/check.h"
#include "lib/mission/netsim/netsim_answer.h"
#include "lib/mission/netsim/netsim_testing.h"
#include "lib/mission/netsim/netsim_wire.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using shoal::NetsimRequest;
  static const shoal::NetsimOptions options = shoal::TwoNetsimVehicles();
  const std::string line = shoal::LineOf(std::vector<uint8_t>(data, data + size));
  const auto parsed = shoal::ParseRequestLine(line);
  const shoal::NetsimReply reply = shoal::AnswerLine(line, "127.0.0.1", options);
  const auto* request = std::get_if<NetsimRequest>(&parsed);
  if (request == nullptr) {
    SHOAL_CHECK(reply.outcome == shoal::NetsimOutcome::kUndecodable && reply.answer.empty(),
                "what does not decode has no answer");
    return 0;
  }
  SHOAL_CHECK(request->is_whole == (reply.outcome != shoal::NetsimOutcome::kIncomplete),
              "a request that lacks a field is reported as incomplete");
  SHOAL_CHECK(reply.positions.size() <= request->navs.size(), "no position of nowhere");
  SHOAL_CHECK(!request->is_whole || reply.stats.size() == request->stats.size(),
              "all stats are accepted");
  return 0;
}
