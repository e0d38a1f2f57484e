#include "lib/bus/memory_bus.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace shoal {

class MemoryBus::Port : public Bus {
 public:
  Port(MemoryBus& hub, std::string participant) : hub_(hub), name(std::move(participant)) {}

  void PublishBytes(std::string_view channel, std::span<const uint8_t> data) override {
    auto cached = channel_id_cache_.find(channel);
    if (cached == channel_id_cache_.end()) {
      cached = channel_id_cache_.emplace(std::string(channel), hub_.ChannelId(channel)).first;
    }
    hub_.open_items_.push_back({.channel_id = cached->second,
                                .port_rank = rank,
                                .sequence = sequence_++,
                                .begin = hub_.open_arena_.size(),
                                .size = data.size()});
    hub_.open_arena_.insert(hub_.open_arena_.end(), data.begin(), data.end());
    ++counters_.published;
  }

  void SubscribeBytes(const std::string& channel, Handler handler) override {
    handlers.push_back(std::move(handler));
    hub_.channels_[hub_.ChannelId(channel)].subscribers.emplace_back(this, handlers.size() - 1);
  }

  void SubscribeAll(Handler handler) override { all_handlers.push_back(std::move(handler)); }

  void Run(const Handler& handler, const Message& message) {
    ++counters_.handled;
    handler(message);
  }
  void StartStep() {
    sequence_ = 0;
    inbox.clear();
  }

 private:
  MemoryBus& hub_;
  std::map<std::string, uint32_t, std::less<>> channel_id_cache_;
  uint32_t sequence_ = 0;

 public:
  const std::string name;
  uint32_t rank = 0;
  std::vector<Handler> handlers;
  std::vector<Handler> all_handlers;
  std::vector<std::pair<uint32_t, size_t>> inbox;  ///< Index into order_, index into handlers.
};

MemoryBus::MemoryBus() = default;
MemoryBus::~MemoryBus() = default;

Bus& MemoryBus::Join(const std::string& participant) {
  SHOAL_CHECK(open_items_.empty(), "all join before anything is published");
  auto& port = ports_[participant];
  SHOAL_CHECK(port == nullptr, "participants have unique names");
  port = std::make_unique<Port>(*this, participant);
  names_by_rank_.clear();
  for (auto& [name, each] : ports_) {
    each->rank = static_cast<uint32_t>(names_by_rank_.size());
    names_by_rank_.push_back(name);
  }
  return *port;
}

uint32_t MemoryBus::ChannelId(std::string_view name) {
  const auto [found, is_new] =
      channel_ids_.emplace(std::string(name), static_cast<uint32_t>(channels_.size()));
  if (is_new) {
    channels_.push_back({.name = std::string(name), .subscribers = {}, .rank = 0});
    ranks_valid_ = false;
  }
  return found->second;
}

void MemoryBus::RankNames() {
  std::vector<uint32_t> by_name(channels_.size());
  std::iota(by_name.begin(), by_name.end(), 0);
  std::sort(by_name.begin(), by_name.end(),
            [&](uint32_t a, uint32_t b) { return channels_[a].name < channels_[b].name; });
  for (uint32_t rank = 0; rank < by_name.size(); ++rank) channels_[by_name[rank]].rank = rank;
  ranks_valid_ = true;
}

void MemoryBus::NextStep() {
  if (!ranks_valid_) RankNames();
  order_.swap(open_items_);
  arena_.swap(open_arena_);
  open_items_.clear();
  open_arena_.clear();
  std::sort(order_.begin(), order_.end(), [&](const Item& a, const Item& b) {
    return std::tuple(channels_[a.channel_id].rank, a.port_rank, a.sequence) <
           std::tuple(channels_[b.channel_id].rank, b.port_rank, b.sequence);
  });
  for (auto& [name, port] : ports_) port->StartStep();
  for (uint32_t i = 0; i < order_.size(); ++i) {
    for (const auto& [port, handler] : channels_[order_[i].channel_id].subscribers) {
      port->inbox.emplace_back(i, handler);
    }
  }
}

void MemoryBus::Handle(Bus& participant_bus) {
  auto& port = static_cast<Port&>(participant_bus);
  const auto message_of = [&](const Item& item) {
    return Message{.channel = channels_[item.channel_id].name,
                   .publisher = names_by_rank_[item.port_rank],
                   .data = std::span(arena_).subspan(item.begin, item.size)};
  };
  for (const auto& [item, handler] : port.inbox) {
    port.Run(port.handlers[handler], message_of(order_[item]));
  }
  for (const Bus::Handler& handler : port.all_handlers) {
    for (const Item& item : order_) port.Run(handler, message_of(item));
  }
}

void MemoryBus::HandleAll() {
  for (auto& [name, port] : ports_) Handle(*port);
}

}  // namespace shoal
