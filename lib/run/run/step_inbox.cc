#include "lib/run/run/step_inbox.h"

#include <algorithm>
#include <tuple>

#include "lib/bus/bus/channels.h"
#include "lib/run/run/status_page.h"

namespace shoal {

StepInbox::StepInbox(std::function<bool(std::string_view)> wants, const MissionSecret& secret)
    : wants_(std::move(wants)), secret_(secret) {}

void StepInbox::StartAt(int64_t step) {
  ForgetBefore(step);
  next_step_ = step;
}

void StepInbox::ForgetBefore(int64_t step) {
  while (!steps_.empty() && steps_.begin()->first < step) {
    for (const auto& [publisher, published] : steps_.begin()->second) {
      for (const auto& [sequence, message] : published.by_sequence) {
        --num_sealed_;
        sealed_bytes_ -= message.size;
      }
    }
    steps_.erase(steps_.begin());
  }
}

std::optional<int64_t> StepInbox::Add(std::string_view channel, std::span<const uint8_t> datagram,
                                      int64_t mission_id) {
  const Unsealed unsealed = Unseal(datagram);
  const auto& [message, seal, tagged, tag] = unsealed;
  if (!seal) {
    // Pages for people are not input to a mission.
    if (!IsAnswer(channel)) ++counters_.outside;
    if (outside_.size() >= kMaxOutside || outside_bytes_ + message.size() > kMaxOutsideBytes) {
      ++counters_.dropped;
      return std::nullopt;
    }
    outside_bytes_ += message.size();
    outside_.push_back({.channel = std::string(channel),
                        .publisher = {},
                        .sequence = static_cast<uint32_t>(outside_.size()),
                        .size = message.size(),
                        .data = Bytes(message.begin(), message.end())});
    return std::nullopt;
  }
  if (seal->mission_id != mission_id) {
    ++counters_.foreign;
    return std::nullopt;
  }
  if (!IsGenuine(unsealed, secret_, channel)) {
    ++counters_.forged;
    if (first_forged_.empty()) {
      first_forged_ = std::string(channel) + " in the name of " + Printable(seal->publisher);
    }
    return std::nullopt;
  }
  // Before the first tick the newest steps are kept: one of them is the tick's.
  if (next_step_ < 0 && seal->step >= kMaxSteps) ForgetBefore(seal->step - kMaxSteps + 1);
  const int64_t oldest =
      next_step_ >= 0 || steps_.empty() ? next_step_ : steps_.rbegin()->first - kMaxSteps + 1;
  const bool is_ahead = next_step_ >= 0 && seal->step >= next_step_ + kMaxSteps;
  if (seal->step < 0 || seal->step < oldest || is_ahead) {
    ++counters_.late;
    return std::nullopt;
  }
  if (num_sealed_ >= kMaxSealed || sealed_bytes_ + message.size() > kMaxSealedBytes) {
    ++counters_.no_room;
    return std::nullopt;
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
    return std::nullopt;
  }
  stored->second = {.channel = std::string(channel),
                    .publisher = publisher->first,
                    .sequence = seal->sequence,
                    .size = message.size(),
                    .data = Bytes(message.begin(), message.end())};
  ++published.num_by_channel[stored->second.channel];
  ++num_sealed_;
  sealed_bytes_ += message.size();
  return seal->step;
}

/// Returns how many messages have come of what `total` announces.
int32_t StepInbox::NumReceived(const tick_t& tick, const step_total_t& total) const {
  const auto step = steps_.find(tick.step - 1);
  if (step == steps_.end()) return 0;
  const auto publisher = step->second.find(total.publisher);
  if (publisher == step->second.end()) return 0;
  const auto& counts = publisher->second.num_by_channel;
  const auto count = counts.find(total.channel);
  return count == counts.end() ? 0 : count->second;
}

std::vector<MiscountedMessages> StepInbox::Missing(const tick_t& tick) const {
  std::vector<MiscountedMessages> missing;
  for (const step_total_t& total : tick.totals) {
    if (!wants_(total.channel)) continue;
    const int32_t received = NumReceived(tick, total);
    if (received >= total.count) continue;
    missing.push_back({.publisher = total.publisher,
                       .channel = total.channel,
                       .expected = total.count,
                       .received = received});
  }
  return missing;
}

std::vector<MiscountedMessages> StepInbox::Excess(const tick_t& tick) const {
  std::vector<MiscountedMessages> excess;
  for (const step_total_t& total : tick.totals) {
    const int32_t received = NumReceived(tick, total);
    if (received <= total.count) continue;
    excess.push_back({.publisher = total.publisher,
                      .channel = total.channel,
                      .expected = total.count,
                      .received = received});
  }
  return excess;
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
