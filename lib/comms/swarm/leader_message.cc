#include "lib/comms/swarm/leader_message.h"

#include "lib/comms/swarm/wire_vector.h"

namespace shoal {

void AppendLeaderMotion(const LeaderMotion& leader, std::vector<uint8_t>* bytes) {
  AppendWireVector(leader.position_m, bytes);
  AppendWireVector(leader.velocity_mps, bytes);
  AppendWireVector(leader.next_position_m, bytes);
  AppendWireVector(leader.next_velocity_mps, bytes);
}

LeaderMotion TakeLeaderMotion(LittleEndianReader* reader) {
  LeaderMotion leader;
  leader.position_m = TakeWireVector(reader);
  leader.velocity_mps = TakeWireVector(reader);
  leader.next_position_m = TakeWireVector(reader);
  leader.next_velocity_mps = TakeWireVector(reader);
  return leader;
}

std::vector<uint8_t> EncodeLeaderReport(const LeaderMessage& message) {
  std::vector<uint8_t> bytes;
  bytes.reserve(kLeaderReportBytes);
  for (const char letter : kLeaderReportFlag) AppendLittleEndian(letter, &bytes);
  AppendLittleEndian(message.group_id, &bytes);
  AppendLeaderMotion(message.leader, &bytes);
  AppendLittleEndian(message.time_stamp_s, &bytes);
  return bytes;
}

std::optional<LeaderMessage> DecodeLeaderReport(std::span<const uint8_t> bytes) {
  if (bytes.size() < kLeaderReportBytes) return std::nullopt;
  LittleEndianReader reader(bytes);
  for (const char letter : kLeaderReportFlag) {
    if (reader.Take<char>() != letter) return std::nullopt;
  }
  LeaderMessage message;
  message.group_id = reader.Take<uint8_t>();
  message.leader = TakeLeaderMotion(&reader);
  message.time_stamp_s = reader.Take<float>();
  return message;
}

}  // namespace shoal
