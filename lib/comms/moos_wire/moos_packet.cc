#include "lib/comms/moos_wire/moos_packet.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/codec/little_endian.h"

namespace shoal {
namespace {

constexpr size_t kMaxText = std::numeric_limits<int32_t>::max();

template <class Number>
void Append(Number number, std::string* bytes) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), &number, sizeof number);
  if constexpr (std::endian::native == std::endian::big) {
    bytes->append(raw.rbegin(), raw.rend());
  } else {
    bytes->append(raw.data(), raw.size());
  }
}

void AppendText(std::string_view text, std::string* bytes) {
  Append(static_cast<int32_t>(text.size()), bytes);
  *bytes += text;
}

void AppendMessage(const MoosMessage& message, std::string* bytes) {
  Append(static_cast<int32_t>(MoosMessageBytes(message)), bytes);
  Append(message.id, bytes);
  *bytes += message.type;
  *bytes += message.data_type;
  AppendText(message.source, bytes);
  AppendText(message.source_aux, bytes);
  AppendText(message.community, bytes);
  AppendText(message.key, bytes);
  Append(message.time_s, bytes);
  Append(message.value, bytes);
  Append(message.value2, bytes);
  AppendText(message.text, bytes);
}

std::span<const uint8_t> AsBytes(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

/// Reads the message that `reader` stands on. Returns false where it is not whole, or does not end
/// where its length states.
bool ReadMessage(LittleEndianReader* reader, MoosMessage* message) {
  const size_t before = reader->num_left();
  uint32_t length = 0;
  uint8_t type = 0;
  uint8_t data_type = 0;
  if (!reader->Take(&length) || length < kMinMoosMessageBytes || length > before) return false;
  if (!reader->Take(&message->id) || !reader->Take(&type) || !reader->Take(&data_type)) {
    return false;
  }
  message->type = static_cast<char>(type);
  message->data_type = static_cast<char>(data_type);
  return reader->TakeSizedText(&message->source) && reader->TakeSizedText(&message->source_aux) &&
         reader->TakeSizedText(&message->community) && reader->TakeSizedText(&message->key) &&
         reader->Take(&message->time_s) && reader->Take(&message->value) &&
         reader->Take(&message->value2) && reader->TakeSizedText(&message->text) &&
         before - reader->num_left() == length;
}

bool IsSameNumber(double a, double b) {
  return std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

}  // namespace

bool MoosMessage::operator==(const MoosMessage& other) const {
  return id == other.id && type == other.type && data_type == other.data_type &&
         source == other.source && source_aux == other.source_aux && community == other.community &&
         key == other.key && text == other.text && IsSameNumber(time_s, other.time_s) &&
         IsSameNumber(value, other.value) && IsSameNumber(value2, other.value2);
}

MoosMessage MoosNotify(std::string_view source, std::string_view key, double value) {
  return {.source = std::string(source), .key = std::string(key), .value = value};
}

MoosMessage MoosNotify(std::string_view source, std::string_view key, std::string_view text) {
  return {.data_type = moos_data::kString,
          .source = std::string(source),
          .key = std::string(key),
          .text = std::string(text)};
}

std::string MoosGreeting() {
  std::string greeting(kMoosProtocolName);
  greeting.resize(kMoosGreetingBytes, '\0');
  return greeting;
}

size_t MoosMessageBytes(const MoosMessage& message) {
  return kMinMoosMessageBytes + message.source.size() + message.source_aux.size() +
         message.community.size() + message.key.size() + message.text.size();
}

void AppendMoosPacket(std::span<const MoosMessage> messages, std::string* bytes) {
  SHOAL_CHECK(!messages.empty(), "a packet has at least one message");
  size_t length = kMinMoosPacketBytes;
  for (const MoosMessage& message : messages) length += MoosMessageBytes(message);
  SHOAL_CHECK(length <= kMaxMoosPacketBytes, "a packet has at most kMaxMoosPacketBytes");
  static_assert(kMaxMoosPacketBytes <= kMaxText);
  bytes->reserve(bytes->size() + length);
  Append(static_cast<int32_t>(length), bytes);
  Append(static_cast<int32_t>(messages.size()), bytes);
  *bytes += '\0';
  for (const MoosMessage& message : messages) AppendMessage(message, bytes);
}

size_t AppendMoosPackets(std::span<const MoosMessage> messages, std::string* bytes) {
  size_t num_left_out = 0;
  size_t begin = 0;
  size_t length = kMinMoosPacketBytes;
  const auto end_packet = [&](size_t end) {
    if (end > begin) AppendMoosPacket(messages.subspan(begin, end - begin), bytes);
    begin = end;
    length = kMinMoosPacketBytes;
  };
  for (size_t i = 0; i < messages.size(); ++i) {
    const size_t more = MoosMessageBytes(messages[i]);
    if (length + more > kMaxMoosPacketBytes) end_packet(i);
    if (length + more > kMaxMoosPacketBytes) {
      ++num_left_out;
      ++begin;
      continue;
    }
    length += more;
  }
  end_packet(messages.size());
  return num_left_out;
}

std::string ReadMoosPacket(std::string_view packet, std::vector<MoosMessage>* messages) {
  messages->clear();
  LittleEndianReader reader(AsBytes(packet));
  uint32_t length = 0;
  uint32_t count = 0;
  uint8_t is_compressed = 0;
  if (!reader.Take(&length) || !reader.Take(&count) || !reader.Take(&is_compressed)) {
    return "a packet is shorter than its head";
  }
  if (length != packet.size()) return "a packet does not have the length that it states";
  if (is_compressed != 0) return "a packet is compressed, which no MOOSDB does";
  // Before the memory for that number is asked for.
  if (count > reader.num_left() / kMinMoosMessageBytes) {
    return "a packet of " + std::to_string(length) + " bytes states " + std::to_string(count) +
           " messages";
  }
  messages->resize(count);
  for (MoosMessage& message : *messages) {
    if (!ReadMessage(&reader, &message)) {
      messages->clear();
      return "a message of a packet does not have the length that it states";
    }
  }
  if (reader.num_left() > 0) {
    messages->clear();
    return "bytes are left behind the messages of a packet";
  }
  return "";
}

size_t MoosPacketReader::LengthOf(std::string_view bytes) {
  LittleEndianReader reader(AsBytes(bytes));
  uint32_t length = 0;
  if (!reader.Take(&length)) return 0;
  if (length < kMinMoosPacketBytes || length > max_packet_bytes_) {
    problem_ = "a packet states a length of " + std::to_string(static_cast<int32_t>(length)) +
               " bytes; allowed: " + std::to_string(kMinMoosPacketBytes) + " to " +
               std::to_string(max_packet_bytes_);
    return 0;
  }
  return length;
}

void MoosPacketReader::Take(std::string_view bytes,
                            const std::function<void(std::span<const MoosMessage>)>& on_packet) {
  while (problem_.empty() && !bytes.empty()) {
    // The length first, so that no more than one packet is kept.
    if (pending_.size() < sizeof(uint32_t)) {
      const size_t missing = std::min(sizeof(uint32_t) - pending_.size(), bytes.size());
      pending_ += bytes.substr(0, missing);
      bytes.remove_prefix(missing);
    }
    const size_t length = LengthOf(pending_);
    if (length == 0) continue;
    const size_t missing = std::min(length - pending_.size(), bytes.size());
    pending_ += bytes.substr(0, missing);
    bytes.remove_prefix(missing);
    if (pending_.size() < length) continue;
    problem_ = ReadMoosPacket(pending_, &messages_);
    pending_.clear();
    if (problem_.empty()) on_packet(messages_);
  }
  if (!problem_.empty()) pending_ = std::string();
}

}  // namespace shoal
