#include "lib/mission/netsim/netsim_answer.h"

#include <utility>
#include <variant>

#include "lib/mission/netsim/netsim_wire.h"

namespace shoal {

namespace {

NetsimReply Without(NotARequest reason) {
  NetsimReply reply;
  switch (reason) {
    case NotARequest::kBlank:
      break;
    case NotARequest::kNoMessage:
      reply.outcome = NetsimOutcome::kNoMessage;
      reply.problem = "a line that is not NETSIM|name|data";
      break;
    case NotARequest::kUnknownMessage:
      reply.outcome = NetsimOutcome::kUnknownMessage;
      reply.problem = "a message that is not a netsim.protobuf.NetSimManagerRequest";
      break;
    case NotARequest::kBadBase64:
      reply.outcome = NetsimOutcome::kUndecodable;
      reply.problem = "a request whose data are not base64 (one line, RFC 4648)";
      break;
    case NotARequest::kBadProtobuf:
      reply.outcome = NetsimOutcome::kUndecodable;
      reply.problem = "a request that does not decode: cut, or not protobuf";
      break;
    case NotARequest::kNoId:
      reply.outcome = NetsimOutcome::kUndecodable;
      reply.problem = "a request without id";
      break;
  }
  return reply;
}

NetsimOutcome OutcomeOf(NetsimStatus status) {
  switch (status) {
    case NetsimStatus::kInvalidModemTcpPort:
      return NetsimOutcome::kInvalidModemTcpPort;
    case NetsimStatus::kInvalidSourceAddress:
      return NetsimOutcome::kInvalidSourceAddress;
    case NetsimStatus::kOutOfDefinedRegion:
      return NetsimOutcome::kOutOfDefinedRegion;
    case NetsimStatus::kAccepted:
      break;
  }
  return NetsimOutcome::kAccepted;
}

}  // namespace

std::string_view Word(NetsimOutcome outcome) {
  constexpr EnumTable<NetsimOutcome, std::string_view> kWords = {"blank",
                                                                 "no message",
                                                                 "unknown message",
                                                                 "undecodable",
                                                                 "incomplete",
                                                                 "invalid modem tcp port",
                                                                 "invalid source address",
                                                                 "out of defined region",
                                                                 "accepted"};
  return kWords[outcome];
}

NetsimReply AnswerLine(std::string_view line, std::string_view peer_address,
                       const NetsimOptions& options) {
  const auto parsed = ParseRequestLine(line);
  if (const auto* reason = std::get_if<NotARequest>(&parsed)) return Without(*reason);
  const auto& request = std::get<NetsimRequest>(parsed);
  NetsimVerdict verdict = EvaluateRequest(request, peer_address, options);
  NetsimReply reply;
  reply.outcome = request.is_whole ? OutcomeOf(*verdict.status) : NetsimOutcome::kIncomplete;
  if (verdict.status) reply.answer = ResponseLine(request.id, *verdict.status);
  reply.problem = std::move(verdict.problem);
  reply.positions = std::move(verdict.positions);
  reply.stats = std::move(verdict.stats);
  return reply;
}

}  // namespace shoal
