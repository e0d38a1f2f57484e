#include "lib/run/hosts/kept_messages.h"

#include "lib/bus/bus/seal.h"
#include "lib/run/run/step_inbox.h"

namespace shoal {

KeptMessages::KeptMessages(int64_t mission_id, const MissionSecret& secret)
    : mission_id_(mission_id), secret_(secret) {}

std::optional<int64_t> KeptMessages::Add(std::string_view channel,
                                         std::span<const uint8_t> datagram) {
  const Unsealed unsealed = Unseal(datagram);
  if (!unsealed.seal) return std::nullopt;
  const auto& seal = *unsealed.seal;
  const bool has_room = num_kept_ < StepInbox::kMaxSealed &&
                        kept_bytes_ + datagram.size() <= StepInbox::kMaxSealedBytes;
  const bool is_near =
      seal.step >= first_step_ && seal.step < first_step_ + 2 * StepInbox::kMaxSteps;
  if (seal.mission_id != mission_id_ || !IsGenuine(unsealed, secret_, channel) || !has_room) {
    ++num_refused_;
    return std::nullopt;
  }
  if (!is_near) return std::nullopt;
  auto& publishers = steps_[seal.step];
  auto publisher = publishers.find(seal.publisher);
  if (publisher == publishers.end()) {
    publisher = publishers.emplace(std::string(seal.publisher), Published()).first;
  }
  const auto [kept, is_new] = publisher->second.by_sequence.try_emplace(seal.sequence);
  if (!is_new) return std::nullopt;
  kept->second = {.channel = std::string(channel),
                  .datagram = Bytes(datagram.begin(), datagram.end())};
  ++publisher->second.num_by_channel[kept->second.channel];
  ++num_kept_;
  kept_bytes_ += datagram.size();
  return seal.step;
}

int32_t KeptMessages::Count(int64_t step, std::string_view publisher,
                            std::string_view channel) const {
  const auto of_step = steps_.find(step);
  if (of_step == steps_.end()) return 0;
  const auto of_publisher = of_step->second.find(publisher);
  if (of_publisher == of_step->second.end()) return 0;
  const auto& counts = of_publisher->second.num_by_channel;
  const auto count = counts.find(channel);
  return count == counts.end() ? 0 : count->second;
}

void KeptMessages::ForgetBefore(int64_t step) {
  while (!steps_.empty() && steps_.begin()->first < step) {
    for (const auto& [publisher, published] : steps_.begin()->second) {
      for (const auto& [sequence, kept] : published.by_sequence) {
        --num_kept_;
        kept_bytes_ -= kept.datagram.size();
      }
    }
    steps_.erase(steps_.begin());
  }
  first_step_ = std::max(first_step_, step);
}

}  // namespace shoal
