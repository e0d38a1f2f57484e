// Packets of the wire protocol of MOOS: what a client and its MOOSDB send each other over TCP.
//
//   std::string bytes;
//   AppendMoosPacket({message}, &bytes);
//
//   MoosPacketReader reader;
//   reader.Take(received, [&](std::span<const MoosMessage> messages) { ... });
//   if (!reader.problem().empty()) Close(reader.problem());
//
// A packet is its length in bytes, the number of its messages (both int32), a byte that states
// whether it is compressed (it never is), and the messages. A message is its length, id, type, type
// of data, five strings with an int32 length each, and three doubles; all little-endian. Nothing
// that a peer sends costs more memory than one packet of the greatest length.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/moos_wire/moos_message.h"

namespace shoal {

/// What a client sends first, filled up with zeros.
inline constexpr size_t kMoosGreetingBytes = 32;
inline constexpr std::string_view kMoosProtocolName = "ELKS CAN'T DANCE 2/8/10";
/// The key of the message with a client's name, and the text of the welcome.
inline constexpr std::string_view kMoosAsynchronous = "asynchronous";

/// The least length of a packet and of a message.
inline constexpr size_t kMinMoosPacketBytes = 9;
inline constexpr size_t kMinMoosMessageBytes = 54;
/// Longer packets are refused. Those of real programs have 30 KB at most; a picture may have more.
inline constexpr size_t kMaxMoosPacketBytes = size_t{4} << 20;

/// Returns the 32 bytes that a client begins with.
[[nodiscard]] std::string MoosGreeting();

/// Returns the length of the message on the wire, in bytes.
[[nodiscard]] size_t MoosMessageBytes(const MoosMessage& message);

/// Appends one packet. @pre `messages` is not empty (a real client reads beyond the end of an empty
/// list), and the packet has at most kMaxMoosPacketBytes
void AppendMoosPacket(std::span<const MoosMessage> messages, std::string* bytes);

/// Appends as many packets as the messages need, each with at most kMaxMoosPacketBytes; none for no
/// messages. Returns how many messages were left out because a packet cannot hold them.
size_t AppendMoosPackets(std::span<const MoosMessage> messages, std::string* bytes);

/// Reads packets from bytes that come in pieces of any size.
class MoosPacketReader {
 public:
  explicit MoosPacketReader(size_t max_packet_bytes = kMaxMoosPacketBytes)
      : max_packet_bytes_(max_packet_bytes) {}

  /// Takes the next bytes, and calls `on_packet` for each packet that is whole with them. Nothing
  /// is read any more after a problem; `on_packet` may not be called for the packet that has it.
  /// @pre `on_packet` does not call Take
  void Take(std::string_view bytes,
            const std::function<void(std::span<const MoosMessage>)>& on_packet);

  /// Returns why the bytes cannot be MOOS's; empty: they can.
  const std::string& problem() const { return problem_; }
  /// Bytes of a packet that is not whole yet.
  size_t num_pending_bytes() const { return pending_.size(); }

 private:
  /// Returns the length of the packet that begins with `bytes`, 0 where it is not known yet.
  size_t LengthOf(std::string_view bytes);

  size_t max_packet_bytes_;
  std::string pending_;
  std::vector<MoosMessage> messages_;
  std::string problem_;
};

/// Returns the messages of one whole packet through `messages`, or what is wrong with it.
[[nodiscard]] std::string ReadMoosPacket(std::string_view packet,
                                         std::vector<MoosMessage>* messages);

}  // namespace shoal
