// Bytes from a client, in pieces: lines, base64 and protobuf. No line may crash the answer, be
// answered twice, or let in a position that is not a number within the vehicle's environment.
//
// An input is one byte, the size of the pieces (0: as many as there are), then the client's bytes.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lib/base/check/check.h"
#include "lib/mission/netsim/line_framer.h"
#include "lib/mission/netsim/netsim_answer.h"
#include "lib/mission/netsim/netsim_testing.h"

namespace shoal {
namespace {

void CheckPosition(const NetsimPosition& position) {
  const NetsimNav& nav = position.nav;
  for (const double value :
       {nav.time_s, nav.lat_deg, nav.lon_deg, nav.depth_m, nav.speed_mps, nav.heading_deg}) {
    SHOAL_CHECK(std::isfinite(value), "what is let in is finite");
  }
  const bool is_alice = position.vehicle == "alice" && nav.modem_tcp_port == 62000;
  SHOAL_CHECK(is_alice || (position.vehicle == "bruce" && nav.modem_tcp_port == 62001),
              "what is let in is a vehicle's");
  SHOAL_CHECK(nav.lat_deg >= (is_alice ? 41 : -10) && nav.lat_deg <= (is_alice ? 42 : 10),
              "what is let in is in its region");
}

void CheckReply(std::string_view line) {
  static const NetsimOptions options = TwoNetsimVehicles();
  const NetsimReply reply = AnswerLine(line, "127.0.0.1", options);
  for (const NetsimPosition& position : reply.positions) CheckPosition(position);
  SHOAL_CHECK(reply.answer.empty() || reply.answer.find('\n') == reply.answer.size() - 1,
              "an answer is one line");
  const bool is_whole = reply.outcome > NetsimOutcome::kIncomplete;
  SHOAL_CHECK(is_whole || (reply.positions.empty() && reply.stats.empty()),
              "nothing of a broken request is applied");
  SHOAL_CHECK(!is_whole || !reply.answer.empty(), "a whole request is answered");
  const bool is_silent =
      reply.outcome == NetsimOutcome::kBlank || reply.outcome == NetsimOutcome::kAccepted;
  SHOAL_CHECK(is_silent == reply.problem.empty(), "every refusal has a problem text");
}

}  // namespace
}  // namespace shoal

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const size_t piece_size = data[0] == 0 ? bytes.size() : data[0];
  shoal::LineFramer framer(1 << 12);
  while (!bytes.empty()) {
    const size_t piece = std::min(piece_size, bytes.size());
    framer.Push(bytes.substr(0, piece), shoal::CheckReply);
    bytes.remove_prefix(piece);
  }
  return 0;
}
