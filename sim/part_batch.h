// What one part of a mission sends to another at the end of a step: its news, then messages.
//
//   BatchWriter writer;                                   // for one other part
//   writer.Begin(news);
//   writer.Add({.participant = 7, .channel = id, .sequence = 0, .data = bytes}, "NAV_ALPHA");
//   Send(writer.bytes());
//
//   BatchReader reader;                                   // of one other part
//   if (!reader.Open(bytes, &news)) return Fail();
//   while (reader.Next(&message)) Use(message, reader.ChannelName(message.channel));
//   if (!reader.IsWhole()) return Fail();
//
// Numbers are in the machine's own order: all parts run the same version, with the same arithmetic.
// A channel's name is in the first message that a writer writes on it, and bytes that messages
// in a row share stand once.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/bus.h"

namespace shoal {

/// What happened to a participant.
struct PartEvent {
  uint32_t participant = 0;  ///< Its place among all of the mission, as MissionPart counts them.
  std::string text;

  bool operator==(const PartEvent&) const = default;
};

/// What all parts must know before they take the next step.
struct PartNews {
  bool ends_mission = false;                 ///< The director's EndsMission().
  bool is_interrupted = false;               ///< A signal asks for the end.
  std::vector<PartEvent> losses = {};        ///< Of this step; the mission goes on.
  std::optional<PartEvent> end_of_all = {};  ///< A loss that ends the mission.
  std::optional<PartEvent> fault = {};       ///< Why an app cannot go on.

  bool operator==(const PartNews&) const = default;
};

/// Adds the news of another part: losses in order of participants, the last loss that ends the
/// mission, the first fault, as one process would have met them.
void Merge(const PartNews& more, PartNews* news);

struct BatchMessage {
  uint32_t participant = 0;  ///< The publisher.
  uint32_t channel = 0;      ///< Its number among the channels of the writing part.
  uint32_t sequence = 0;     ///< Counts the publisher's messages of the step.
  std::span<const uint8_t> data = {};
};

class BatchWriter {
 public:
  /// Begins the batch of a step, in place of the one before.
  void Begin(const PartNews& news);
  /// Adds a message on the channel `name`. @pre messages of one number have the same name
  void Add(const BatchMessage& message, std::string_view name);

  std::span<const uint8_t> bytes() const { return bytes_; }

 private:
  Bytes bytes_;
  std::vector<bool> is_named_;          ///< By channel.
  std::span<const uint8_t> last_ = {};  ///< The bytes of the message before.
};

class BatchReader {
 public:
  /// Begins to read a batch, which must outlive the reading. Returns false where it is damaged.
  [[nodiscard]] bool Open(std::span<const uint8_t> batch, PartNews* news);
  /// Reads the next message. Returns false after the last, and where the batch is damaged.
  [[nodiscard]] bool Next(BatchMessage* message);
  /// True after the last message of a batch that is not damaged.
  bool IsWhole() const { return is_sound_ && rest_.empty(); }

  /// @pre a message that was read is of this channel
  const std::string& ChannelName(uint32_t channel) const { return names_[channel]; }

 private:
  bool Take(size_t size, std::span<const uint8_t>* bytes);
  bool TakeNumber(uint32_t* number);
  bool TakeText(std::string* text);
  bool TakeEvent(PartEvent* event);

  std::span<const uint8_t> rest_ = {};
  std::span<const uint8_t> last_ = {};
  std::vector<std::string> names_;  ///< By channel; kept from batch to batch.
  bool is_sound_ = false;
};

}  // namespace shoal
