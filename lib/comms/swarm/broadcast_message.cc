#include "lib/comms/swarm/broadcast_message.h"

#include "lib/comms/swarm/wire_vector.h"

namespace shoal {

std::vector<uint8_t> EncodeBroadcast(const BroadcastMessage& message) {
  std::vector<uint8_t> bytes;
  bytes.reserve(BroadcastBytes(message.followers.size()));
  for (const char letter : kBroadcastFlag) AppendLittleEndian(letter, &bytes);
  AppendLittleEndian(message.group_id, &bytes);
  AppendLeaderMotion(message.leader, &bytes);
  AppendLittleEndian(static_cast<uint32_t>(message.followers.size()), &bytes);
  for (const auto& follower : message.followers) AppendWireVector(follower.position_m, &bytes);
  for (const auto& follower : message.followers) AppendWireVector(follower.velocity_mps, &bytes);
  for (const auto& follower : message.followers) AppendLittleEndian(follower.reported_s, &bytes);
  for (const auto& follower : message.followers) AppendLittleEndian(follower.id, &bytes);
  AppendLittleEndian(message.response_start_s, &bytes);
  AppendLittleEndian(message.time_stamp_s, &bytes);
  return bytes;
}

std::optional<BroadcastMessage> DecodeBroadcast(std::span<const uint8_t> bytes) {
  if (bytes.size() < BroadcastBytes(0)) return std::nullopt;
  LittleEndianReader reader(bytes);
  for (const char letter : kBroadcastFlag) {
    if (reader.Take<char>() != letter) return std::nullopt;
  }
  BroadcastMessage message;
  message.group_id = reader.Take<uint8_t>();
  message.leader = TakeLeaderMotion(&reader);
  const auto num_followers = reader.Take<uint32_t>();
  if (bytes.size() < BroadcastBytes(num_followers)) return std::nullopt;
  message.followers.resize(num_followers);
  for (auto& follower : message.followers) follower.position_m = TakeWireVector(&reader);
  for (auto& follower : message.followers) follower.velocity_mps = TakeWireVector(&reader);
  for (auto& follower : message.followers) follower.reported_s = reader.Take<float>();
  for (auto& follower : message.followers) follower.id = reader.Take<uint32_t>();
  message.response_start_s = reader.Take<float>();
  message.time_stamp_s = reader.Take<float>();
  return message;
}

}  // namespace shoal
