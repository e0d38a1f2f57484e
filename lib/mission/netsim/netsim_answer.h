// Answers one line of netsim's protocol as netsim_manager does.
//
//   const NetsimReply reply = AnswerLine(line, "127.0.0.1", options);
//   counts.Add(reply.outcome);
//   Send(reply.answer);
//   for (const NetsimPosition& position : reply.positions) { ... }
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/enum_table.h"
#include "lib/mission/netsim/netsim_evaluate.h"
#include "lib/mission/netsim/netsim_options.h"

namespace shoal {

/// What became of a line. For the first five nothing is applied; for the next three, the positions
/// before the failed one.
enum class NetsimOutcome {
  kBlank,
  kNoMessage,
  kUnknownMessage,
  kUndecodable,  ///< Not base64, not protobuf, or without an id: no answer.
  kIncomplete,   ///< A required field is missing; answered where a status fits.
  kInvalidModemTcpPort,
  kInvalidSourceAddress,
  kOutOfDefinedRegion,
  kAccepted,
};
inline constexpr size_t kNumNetsimOutcomes = kNumEnumerators<NetsimOutcome>;

/// Returns "out of defined region" and the like.
[[nodiscard]] std::string_view Word(NetsimOutcome outcome);

struct NetsimReply {
  std::string answer;  ///< A line with its end, or empty.
  NetsimOutcome outcome = NetsimOutcome::kBlank;
  std::string problem;  ///< Why not all was accepted, for the status page.
  std::vector<NetsimPosition> positions;
  std::vector<NetsimReceiveStats> stats;
};

/// Answers a line without its end that came from `peer_address` (IPv4).
[[nodiscard]] NetsimReply AnswerLine(std::string_view line, std::string_view peer_address,
                                     const NetsimOptions& options);

/// How many lines had which outcome.
struct NetsimCounts {
  std::array<int64_t, kNumNetsimOutcomes> by_outcome = {};

  void Add(NetsimOutcome outcome) { ++by_outcome[static_cast<size_t>(outcome)]; }
  int64_t Of(NetsimOutcome outcome) const { return by_outcome[static_cast<size_t>(outcome)]; }
};

}  // namespace shoal
