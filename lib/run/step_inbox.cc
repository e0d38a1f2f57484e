#include "lib/run/step_inbox.h"

#include <algorithm>
#include <tuple>

#include "lib/bus/channels.h"

namespace shoal {

namespace {
/// A participant is never more than one step behind another; more comes from a faulty program.
constexpr int64_t kMaxStepsAhead = 2;
}  // namespace

StepInbox::StepInbox(std::function<bool(std::string_view)> wants) : wants_(std::move(wants)) {}

void StepInbox::StartAt(int64_t step) {
  steps_.erase(steps_.begin(), steps_.lower_bound(step));
  next_step_ = step;
}

void StepInbox::Add(std::string_view channel, std::span<const uint8_t> datagram,
                    int64_t mission_id) {
  const auto [message, seal] = Unseal(datagram);
  if (!seal) {
    // Pages for people are no input to a mission.
    if (!IsAnswer(channel)) ++counters_.outside;
    if (outside_.size() >= kMaxOutside || outside_bytes_ + message.size() > kMaxOutsideBytes) {
      ++counters_.dropped;
      return;
    }
    outside_bytes_ += message.size();
    outside_.push_back({.channel = std::string(channel),
                        .publisher = {},
                        .sequence = static_cast<uint32_t>(outside_.size()),
                        .data = Bytes(message.begin(), message.end())});
    return;
  }
  if (seal->mission_id != mission_id) {
    ++counters_.foreign;
    return;
  }
  const bool is_late = seal->step < next_step_;
  const bool is_ahead = next_step_ >= 0 && seal->step > next_step_ + kMaxStepsAhead;
  if (is_late || is_ahead) {
    ++counters_.late;
    return;
  }
  auto& publishers = steps_[seal->step];
  auto publisher = publishers.find(seal->publisher);
  if (publisher == publishers.end()) {
    publisher = publishers.emplace(std::string(seal->publisher), Published()).first;
  }
  Published& published = publisher->second;
  const auto [stored, is_new] = published.by_sequence.try_emplace(seal->sequence);
  if (!is_new) {
    ++counters_.late;
    return;
  }
  stored->second = {.channel = std::string(channel),
                    .publisher = publisher->first,
                    .sequence = seal->sequence,
                    .data = Bytes(message.begin(), message.end())};
  ++published.num_by_channel[stored->second.channel];
}

std::vector<MissingMessages> StepInbox::Missing(const tick_t& tick) const {
  std::vector<MissingMessages> missing;
  const auto step = steps_.find(tick.step - 1);
  for (const step_total_t& total : tick.totals) {
    if (!wants_(total.channel)) continue;
    int32_t received = 0;
    if (step != steps_.end()) {
      const auto publisher = step->second.find(total.publisher);
      if (publisher != step->second.end()) {
        const auto& counts = publisher->second.num_by_channel;
        const auto count = counts.find(total.channel);
        if (count != counts.end()) received = count->second;
      }
    }
    if (received < total.count) {
      missing.push_back({.publisher = total.publisher,
                         .channel = total.channel,
                         .expected = total.count,
                         .received = received});
    }
  }
  return missing;
}

std::vector<StepInbox::Stored> StepInbox::Take(const tick_t& tick) {
  std::vector<Stored> taken = std::move(outside_);
  outside_.clear();
  outside_bytes_ = 0;
  const auto step = steps_.find(tick.step - 1);
  if (step != steps_.end()) {
    std::set<std::pair<std::string_view, std::string_view>> announced;
    for (const step_total_t& total : tick.totals) {
      announced.emplace(total.publisher, total.channel);
    }
    for (auto& [publisher, published] : step->second) {
      for (auto& [sequence, message] : published.by_sequence) {
        if (announced.contains({message.publisher, message.channel})) {
          taken.push_back(std::move(message));
        }
      }
    }
  }
  StartAt(tick.step);
  std::sort(taken.begin(), taken.end(), [](const Stored& a, const Stored& b) {
    return std::tie(a.channel, a.publisher, a.sequence) <
           std::tie(b.channel, b.publisher, b.sequence);
  });
  return taken;
}

}  // namespace shoal
