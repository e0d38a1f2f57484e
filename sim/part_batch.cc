#include "sim/part_batch.h"

#include <algorithm>
#include <cstring>

namespace shoal {

namespace {

/// Of PartNews, in one number.
enum NewsBits : uint32_t { kEndsMission = 1, kIsInterrupted = 2, kHasEndOfAll = 4, kHasFault = 8 };

/// In the place of a channel's number: the name follows.
constexpr uint32_t kNamed = uint32_t{1} << 31;
/// In the place of a message's size: the bytes are those of the message before.
constexpr uint32_t kSameBytes = 0xffffffff;
/// No mission has more names and channels than these: a batch with more is damaged.
constexpr uint32_t kMaxBatchChannels = 10'000'000;

void AppendNumber(uint32_t number, Bytes* bytes) {
  const size_t begin = bytes->size();
  bytes->resize(begin + sizeof number);
  std::memcpy(bytes->data() + begin, &number, sizeof number);
}

void AppendText(std::string_view text, Bytes* bytes) {
  AppendNumber(static_cast<uint32_t>(text.size()), bytes);
  bytes->insert(bytes->end(), text.begin(), text.end());
}

void AppendEvent(const PartEvent& event, Bytes* bytes) {
  AppendNumber(event.participant, bytes);
  AppendText(event.text, bytes);
}

}  // namespace

void Merge(const PartNews& more, PartNews* news) {
  news->ends_mission |= more.ends_mission;
  news->is_interrupted |= more.is_interrupted;
  news->losses.insert(news->losses.end(), more.losses.begin(), more.losses.end());
  std::ranges::stable_sort(news->losses, {}, &PartEvent::participant);
  if (more.end_of_all &&
      (!news->end_of_all || news->end_of_all->participant < more.end_of_all->participant)) {
    news->end_of_all = more.end_of_all;
  }
  if (more.fault && (!news->fault || more.fault->participant < news->fault->participant)) {
    news->fault = more.fault;
  }
}

void BatchWriter::Begin(const PartNews& news) {
  bytes_.clear();
  last_ = {};
  AppendNumber((news.ends_mission ? kEndsMission : 0U) |
                   (news.is_interrupted ? kIsInterrupted : 0U) |
                   (news.end_of_all ? kHasEndOfAll : 0U) | (news.fault ? kHasFault : 0U),
               &bytes_);
  AppendNumber(static_cast<uint32_t>(news.losses.size()), &bytes_);
  for (const PartEvent& loss : news.losses) AppendEvent(loss, &bytes_);
  if (news.end_of_all) AppendEvent(*news.end_of_all, &bytes_);
  if (news.fault) AppendEvent(*news.fault, &bytes_);
}

void BatchWriter::Add(const BatchMessage& message, std::string_view name) {
  if (message.channel >= is_named_.size()) is_named_.resize(message.channel + 1);
  const bool is_new = !is_named_[message.channel];
  const bool is_same = !message.data.empty() && message.data.data() == last_.data() &&
                       message.data.size() == last_.size();
  const uint32_t head[] = {message.participant, message.channel | (is_new ? kNamed : 0),
                           message.sequence,
                           is_same ? kSameBytes : static_cast<uint32_t>(message.data.size())};
  const size_t begin = bytes_.size();
  bytes_.resize(begin + sizeof head);
  std::memcpy(bytes_.data() + begin, head, sizeof head);
  if (is_new) {
    AppendText(name, &bytes_);
    is_named_[message.channel] = true;
  }
  if (!is_same) bytes_.insert(bytes_.end(), message.data.begin(), message.data.end());
  last_ = message.data;
}

bool BatchReader::Take(size_t size, std::span<const uint8_t>* bytes) {
  is_sound_ = is_sound_ && size <= rest_.size();
  if (!is_sound_) return false;
  *bytes = rest_.first(size);
  rest_ = rest_.subspan(size);
  return true;
}

bool BatchReader::TakeNumber(uint32_t* number) {
  std::span<const uint8_t> bytes;
  if (!Take(sizeof *number, &bytes)) return false;
  std::memcpy(number, bytes.data(), sizeof *number);
  return true;
}

bool BatchReader::TakeText(std::string* text) {
  uint32_t size = 0;
  std::span<const uint8_t> bytes;
  if (!TakeNumber(&size) || !Take(size, &bytes)) return false;
  text->assign(bytes.begin(), bytes.end());
  return true;
}

bool BatchReader::TakeEvent(PartEvent* event) {
  return TakeNumber(&event->participant) && TakeText(&event->text);
}

bool BatchReader::Open(std::span<const uint8_t> batch, PartNews* news) {
  rest_ = batch;
  last_ = {};
  is_sound_ = true;
  *news = {};
  uint32_t bits = 0;
  uint32_t num_losses = 0;
  if (!TakeNumber(&bits) || !TakeNumber(&num_losses)) return false;
  news->ends_mission = (bits & kEndsMission) != 0;
  news->is_interrupted = (bits & kIsInterrupted) != 0;
  for (uint32_t i = 0; i < num_losses; ++i) {
    if (!TakeEvent(&news->losses.emplace_back())) return false;
  }
  if ((bits & kHasEndOfAll) != 0 && !TakeEvent(&news->end_of_all.emplace())) return false;
  if ((bits & kHasFault) != 0 && !TakeEvent(&news->fault.emplace())) return false;
  return true;
}

bool BatchReader::Next(BatchMessage* message) {
  uint32_t head[4] = {};
  std::span<const uint8_t> bytes;
  if (rest_.empty() || !Take(sizeof head, &bytes)) return false;
  std::memcpy(head, bytes.data(), sizeof head);
  *message = {.participant = head[0], .channel = head[1] & ~kNamed, .sequence = head[2]};
  if ((head[1] & kNamed) != 0) {
    is_sound_ = message->channel < kMaxBatchChannels;
    if (!is_sound_) return false;
    if (message->channel >= names_.size()) names_.resize(message->channel + 1);
    if (!TakeText(&names_[message->channel])) return false;
  }
  is_sound_ = message->channel < names_.size() && !names_[message->channel].empty();
  if (!is_sound_ || (head[3] != kSameBytes && !Take(head[3], &last_))) return false;
  message->data = last_;
  return true;
}

}  // namespace shoal
