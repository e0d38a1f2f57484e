#include "lib/run/run/sent_messages.h"

#include <algorithm>
#include <span>
#include <utility>

#include "lib/base/check/check.h"

namespace shoal {

void SentMessages::BeginStep(int64_t step) {
  Step next;
  if (steps_.size() == kStepsKept) {
    next = std::move(steps_.front());  // Its storage is used again.
    steps_.pop_front();
  }
  next.step = step;
  next.num = 0;
  steps_.push_back(std::move(next));
}

SentMessages::Sent* SentMessages::Add(std::string_view publisher, std::string_view channel) {
  SHOAL_CHECK(!steps_.empty(), "a step has begun");
  Step& step = steps_.back();
  if (step.num == step.messages.size()) step.messages.emplace_back();
  Sent& sent = step.messages[step.num++];
  sent.publisher = publisher;
  sent.channel = channel;
  sent.datagram.clear();
  return &sent;
}

bool SentMessages::Has(std::string_view publisher, std::string_view channel) const {
  return std::any_of(steps_.begin(), steps_.end(), [&](const Step& step) {
    const auto messages = std::span(step.messages).first(step.num);
    return std::any_of(messages.begin(), messages.end(), [&](const Sent& sent) {
      return sent.channel == channel && sent.publisher == publisher;
    });
  });
}

void SentMessages::Visit(int64_t number, std::string_view publisher, std::string_view channel,
                         const std::function<void(const Sent&)>& visit) const {
  for (const Step& step : steps_) {
    if (step.step != number) continue;
    for (const Sent& sent : std::span(step.messages).first(step.num)) {
      if (sent.channel == channel && sent.publisher == publisher) visit(sent);
    }
  }
}

}  // namespace shoal
