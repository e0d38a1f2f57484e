#include "lib/bus/memory_bus.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace shoal {

class MemoryBus::Port : public Bus {
 public:
  Port(MemoryBus& hub, std::string participant) : hub_(hub), name(std::move(participant)) {}

  void PublishBytes(std::string_view channel, std::span<const uint8_t> data) override {
    if (hub_.names_by_rank_.empty()) hub_.RankPorts();
    if (step_ != hub_.step_) sequence_ = 0;
    step_ = hub_.step_;
    const KnownChannel& known = Find(channel);
    // What is published before the first step may still find subscribers.
    if (known.is_read || hub_.step_ == 0) {
      hub_.Publish({.channel_id = known.id,
                    .port_rank = rank,
                    .sequence = sequence_,
                    .content = 0,
                    .begin = 0,
                    .size = data.size()},
                   data);
    }
    ++sequence_;
    ++counters_.published;
  }

  void SubscribeBytes(const std::string& channel, Handler handler) override {
    handlers.push_back(std::move(handler));
    ++hub_.num_subscriptions_;
    hub_.channels_[hub_.ChannelId(channel)].subscribers.emplace_back(this, handlers.size() - 1);
  }

  void SubscribeAll(Handler handler) override {
    all_handlers.push_back(std::move(handler));
    ++hub_.num_subscriptions_;
    hub_.has_listener_ = true;
  }

  void Run(const Handler& handler, const Message& message) {
    ++counters_.handled;
    handler(message);
  }

 private:
  struct KnownChannel {
    std::string name;
    uint32_t id = 0;
    bool is_read = false;            ///< Some participant subscribes to it ...
    uint32_t num_subscriptions = 0;  ///< ... when the bus had this number of them.
  };

  /// Participants publish on the same channels in the same order, step after step.
  const KnownChannel& Find(std::string_view channel) {
    for (size_t i = 0; i < known_channels_.size(); ++i) {
      next_channel_ = next_channel_ + 1 < known_channels_.size() ? next_channel_ + 1 : 0;
      KnownChannel& known = known_channels_[next_channel_];
      if (known.name != channel) continue;
      if (known.num_subscriptions != hub_.num_subscriptions_) LookForReaders(&known);
      return known;
    }
    next_channel_ = known_channels_.size();
    known_channels_.push_back({.name = std::string(channel), .id = hub_.ChannelId(channel)});
    LookForReaders(&known_channels_.back());
    return known_channels_.back();
  }

  void LookForReaders(KnownChannel* known) const {
    known->is_read = hub_.has_listener_ || !hub_.channels_[known->id].subscribers.empty();
    known->num_subscriptions = hub_.num_subscriptions_;
  }

  MemoryBus& hub_;
  std::vector<KnownChannel> known_channels_;  ///< In order of their first use.
  size_t next_channel_ = 0;                   ///< The last that was used.
  uint32_t sequence_ = 0;
  uint32_t step_ = 0;  ///< Of sequence_.

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
  names_by_rank_.clear();  // Before the first step, ranked when the first of them publishes.
  if (step_ > 0) RankPorts();
  return *port;
}

void MemoryBus::RankPorts() {
  names_by_rank_.clear();
  for (auto& [name, each] : ports_) {
    each->rank = static_cast<uint32_t>(names_by_rank_.size());
    names_by_rank_.push_back(name);
  }
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

/// A broker publishes the same bytes on the channels of many receivers: they are kept once.
void MemoryBus::Publish(Item item, std::span<const uint8_t> data) {
  const Item* last = open_items_.empty() ? nullptr : &open_items_.back();
  if (last != nullptr && last->size == data.size() &&
      std::equal(data.begin(), data.end(), open_arena_.data() + last->begin)) {
    item.begin = last->begin;
    item.content = last->content;
  } else {
    item.begin = open_arena_.size();
    item.content = num_open_contents_++;
    open_arena_.insert(open_arena_.end(), data.begin(), data.end());
  }
  open_items_.push_back(item);
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
  ++step_;
  order_.swap(open_items_);
  arena_.swap(open_arena_);
  open_items_.clear();
  open_arena_.clear();
  if (contents_.size() < num_open_contents_) contents_.resize(num_open_contents_);
  for (uint32_t i = 0; i < num_open_contents_; ++i) {
    contents_[i].num_readers = 0;
    if (contents_[i].views) contents_[i].views->Clear();
  }
  num_open_contents_ = 0;
  for (Item& item : order_) item.channel_rank = channels_[item.channel_id].rank;
  std::sort(order_.begin(), order_.end(), [](const Item& a, const Item& b) {
    return std::tuple(a.channel_rank, a.port_rank, a.sequence) <
           std::tuple(b.channel_rank, b.port_rank, b.sequence);
  });
  for (Port* port : receivers_) port->inbox.clear();
  receivers_.clear();
  for (uint32_t i = 0; i < order_.size(); ++i) {
    const auto& subscribers = channels_[order_[i].channel_id].subscribers;
    contents_[order_[i].content].num_readers += subscribers.size();
    for (const auto& [port, handler] : subscribers) {
      if (port->inbox.empty()) receivers_.push_back(port);
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
  for (const auto& [place, handler] : port.inbox) {
    const Item& item = order_[place];
    Content& content = contents_[item.content];
    Message message = message_of(item);
    if (content.num_readers > 1) {
      if (!content.views) content.views = std::make_unique<MessageViews>();
      message.views = content.views.get();
    }
    port.Run(port.handlers[handler], message);
  }
  for (const Bus::Handler& handler : port.all_handlers) {
    for (const Item& item : order_) port.Run(handler, message_of(item));
  }
}

void MemoryBus::HandleAll() {
  for (auto& [name, port] : ports_) Handle(*port);
}

}  // namespace shoal
