#include "apps/viewer/event_hub.h"

#include <algorithm>

namespace shoal {

EventHub::Reader::Reader(EventHub& hub) : hub_(hub) {
  const std::lock_guard lock(hub_.mutex_);
  // Without readers there are no new frames; the last one may be hours old.
  if (hub_.num_readers_++ == 0) hub_.newest_.reset();
  stream_ = hub_.stream_;
}

EventHub::Reader::~Reader() {
  const std::lock_guard lock(hub_.mutex_);
  --hub_.num_readers_;
}

std::optional<EventHub::Event> EventHub::Reader::Next(std::chrono::milliseconds patience) {
  std::unique_lock lock(hub_.mutex_);
  const auto has_ended = [&] { return hub_.stopped_ || hub_.stream_ != stream_; };
  const auto has_news = [&] { return hub_.newest_ != nullptr && hub_.sequence_ != seen_; };
  hub_.changed_.wait_for(lock, patience, [&] { return has_ended() || has_news(); });
  if (has_ended()) return std::nullopt;
  if (!has_news()) return Event();
  seen_ = hub_.sequence_;
  return hub_.newest_;
}

void EventHub::Publish(std::string_view json) {
  std::string text = "data: ";
  text += json;
  // A line break would end the data.
  std::replace_if(
      text.begin(), text.end(), [](char each) { return each == '\n' || each == '\r'; }, ' ');
  text += "\n\n";
  auto event = std::make_shared<const std::string>(std::move(text));
  {
    const std::lock_guard lock(mutex_);
    newest_.swap(event);
    ++sequence_;
  }
  changed_.notify_all();
}

void EventHub::EndStreams() {
  {
    const std::lock_guard lock(mutex_);
    ++stream_;
    newest_.reset();
  }
  changed_.notify_all();
}

void EventHub::Stop() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
}

int EventHub::num_readers() const {
  const std::lock_guard lock(mutex_);
  return num_readers_;
}

}  // namespace shoal
