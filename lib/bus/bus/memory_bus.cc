#include "lib/bus/bus/memory_bus.h"

#include <algorithm>
#include <functional>
#include <string>
#include <tuple>
#include <unordered_map>

namespace shoal {

namespace {

/// The numbers that a place has for its messages: of a step of 64 vehicles' reports to thousands.
constexpr uint32_t kSequencesPerPlace = 1 << 20;
static_assert(uint64_t{kSequencesPerPlace} * kNumPlaces <= uint64_t{1} << 32);

}  // namespace

class MemoryBus::Port : public Bus {
 public:
  Port(MemoryBus& hub, uint32_t place, std::string participant)
      : hub_(hub), number(place), name(std::move(participant)) {}

  void PublishBytes(std::string_view channel, std::span<const uint8_t> data) override {
    PublishShared(channel, data);
  }

  MessageViews* PublishShared(std::string_view channel, std::span<const uint8_t> data) override {
    if (hub_.names_by_rank_.empty()) hub_.RankPorts();
    MeetStep();
    const KnownChannel& known = Find(channel);
    const Item item = {.channel = known.id, .port = rank, .sequence = sequence_++, .content = 0};
    ++counters_.published;
    // What is published before the first step may still find subscribers.
    return known.is_kept || hub_.step_ == 0 ? hub_.Publish(item, data) : nullptr;
  }

  void SetPlace(uint32_t place) override {
    if (!is_elsewhere) return;  // What it publishes in this order needs no places.
    MeetStep();
    const uint32_t first = place * kSequencesPerPlace;
    SHOAL_CHECK(place < kNumPlaces && sequence_ <= first, "the places of a step rise");
    sequence_ = first;
  }

  void SubscribeBytes(const std::string& channel, Handler handler) override {
    const Subscriber subscriber = {.port = number,
                                   .handler = static_cast<uint32_t>(hub_.handlers_.size())};
    hub_.handlers_.push_back(std::move(handler));
    hub_.channel_readers_[hub_.ChannelNumber(channel)].push_back(subscriber);
    hub_.ranks_valid_ = false;
    ++hub_.num_subscriptions_;
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
  struct TextHash {
    using is_transparent = void;
    size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };
  struct KnownChannel {
    std::string name;
    uint32_t id = 0;
    bool is_kept = false;            ///< It is read, or wanted elsewhere ...
    uint32_t num_subscriptions = 0;  ///< ... when the bus had this number of them.
  };

  void MeetStep() {
    if (step_ != hub_.step_) sequence_ = 0;
    step_ = hub_.step_;
  }

  /// Participants publish on the same channels in the same order, step after step: the next one is
  /// tried first.
  const KnownChannel& Find(std::string_view channel) {
    next_channel_ = next_channel_ + 1 < known_channels_.size() ? next_channel_ + 1 : 0;
    if (next_channel_ >= known_channels_.size() || known_channels_[next_channel_].name != channel) {
      next_channel_ = PlaceOf(channel);
    }
    KnownChannel& known = known_channels_[next_channel_];
    if (known.num_subscriptions != hub_.num_subscriptions_) LookForReaders(&known);
    return known;
  }

  /// Returns the channel's place among known_channels_; adds it where it is not there.
  size_t PlaceOf(std::string_view channel) {
    const auto found = places_.find(channel);
    if (found != places_.end()) return found->second;
    const size_t place = known_channels_.size();
    known_channels_.push_back({.name = std::string(channel), .id = hub_.ChannelNumber(channel)});
    LookForReaders(&known_channels_.back());
    places_.emplace(channel, place);
    return place;
  }

  void LookForReaders(KnownChannel* known) const {
    known->is_kept = hub_.IsRead(known->id) || hub_.wanted_elsewhere_[known->id];
    known->num_subscriptions = hub_.num_subscriptions_;
  }

  MemoryBus& hub_;

 public:
  const uint32_t number;  ///< In order of joining.
  uint32_t rank = 0;      ///< In order of names.
  bool is_ranked = false;
  bool is_here = true;        ///< Stepped by this part.
  bool is_elsewhere = false;  ///< Stepped by another part.

 private:
  std::vector<KnownChannel> known_channels_;  ///< In order of their first use.
  std::unordered_map<std::string, size_t, TextHash, std::equal_to<>> places_;  ///< By name.
  size_t next_channel_ = 0;  ///< The last that was used.
  uint32_t sequence_ = 0;
  uint32_t step_ = 0;  ///< Of sequence_.

 public:
  std::vector<Handler> all_handlers;
  const std::string name;
};

MemoryBus::MemoryBus() = default;
MemoryBus::~MemoryBus() = default;

Bus& MemoryBus::Join(const std::string& participant) {
  SHOAL_CHECK(open_.items.empty(), "all join before anything is published");
  return AddPort(participant);
}

Bus& MemoryBus::JoinShared(const std::string& participant) {
  SHOAL_CHECK(open_.items.empty(), "all join before anything is published");
  Port& port = AddPort(participant);
  port.is_elsewhere = true;
  return port;
}

uint32_t MemoryBus::JoinElsewhere(const std::string& participant) {
  Port& port = AddPort(participant);
  port.is_here = false;
  port.is_elsewhere = true;
  return port.number;
}

MemoryBus::Port& MemoryBus::AddPort(const std::string& participant) {
  const auto number = static_cast<uint32_t>(ports_.size());
  auto& port = ports_[participant];
  SHOAL_CHECK(port == nullptr, "participants have unique names");
  port = std::make_unique<Port>(*this, number, participant);
  ports_by_number_.push_back(port.get());
  if (step_ == 0 && open_.items.empty()) {
    names_by_rank_.clear();  // Ranked when the first of them publishes.
  } else {
    RankPorts();
  }
  deliveries_begin_.push_back(deliveries_begin_.empty() ? 0 : deliveries_begin_.back());
  if (number == 0) deliveries_begin_.push_back(0);
  return *port;
}

void MemoryBus::Insert(uint32_t participant, uint32_t channel, uint32_t sequence,
                       std::span<const uint8_t> data) {
  const Port& port = *ports_by_number_.at(participant);
  SHOAL_CHECK(port.is_elsewhere, "participants here publish by their own bus");
  if (names_by_rank_.empty()) RankPorts();
  if (!IsRead(channel) && step_ > 0) return;
  Publish({.channel = channel, .port = port.rank, .sequence = sequence, .content = 0}, data);
}

void MemoryBus::KeepFor(std::function<bool(std::string_view)> is_wanted_elsewhere) {
  is_wanted_elsewhere_ = std::move(is_wanted_elsewhere);
  for (size_t id = 0; id < channel_names_.size(); ++id) {
    wanted_elsewhere_[id] = is_wanted_elsewhere_ && is_wanted_elsewhere_(channel_names_[id]);
  }
  ++num_subscriptions_;  // So that all look again whether their channels are kept.
}

void MemoryBus::VisitPublished(const std::function<void(const Published&)>& visit) const {
  std::vector<const Port*> by_rank(ports_by_number_.size());
  for (const Port* port : ports_by_number_) by_rank[port->rank] = port;
  for (const Item& item : open_.items) {
    if (!wanted_elsewhere_[item.channel] || !by_rank[item.port]->is_here) continue;
    const Content& content = open_.contents[item.content];
    visit({.channel = channel_names_[item.channel],
           .publisher = names_by_rank_[item.port],
           .sequence = item.sequence,
           .data = std::span(open_.arena).subspan(content.begin, content.size),
           .content = item.content,
           .channel_number = item.channel,
           .participant = by_rank[item.port]->number});
  }
}

std::vector<std::string_view> MemoryBus::SubscribedChannels() const {
  std::vector<std::string_view> channels;
  for (const auto& [name, id] : channel_ids_) {
    if (!channel_readers_[id].empty()) channels.push_back(name);
  }
  return channels;
}

bool MemoryBus::IsRead(uint32_t channel) const {
  return has_listener_ || !channel_readers_[channel].empty();
}

void MemoryBus::EndSubscriptions(Bus& participant_bus) {
  auto& port = static_cast<Port&>(participant_bus);
  for (std::vector<Subscriber>& readers : channel_readers_) {
    std::erase_if(readers, [&](const Subscriber& each) {
      if (each.port != port.number) return false;
      handlers_[each.handler] = nullptr;
      return true;
    });
  }
  port.all_handlers.clear();
  ++num_subscriptions_;  // So that all look for readers again.
  ranks_valid_ = false;
}

/// Numbers the participants in order of their names, and what they published with them.
void MemoryBus::RankPorts() {
  std::vector<uint32_t> new_ranks(names_by_rank_.size());
  uint32_t rank = 0;
  for (auto& [name, each] : ports_) {
    if (each->is_ranked) new_ranks[each->rank] = rank;
    each->rank = rank++;
    each->is_ranked = true;
  }
  for (Traffic* traffic : {&open_, &closed_}) {
    for (Item& item : traffic->items) item.port = new_ranks[item.port];
  }
  names_by_rank_.clear();
  for (auto& [name, each] : ports_) names_by_rank_.push_back(name);
}

uint32_t MemoryBus::ChannelNumber(std::string_view name) {
  const auto found = channel_ids_.find(name);
  if (found != channel_ids_.end()) return found->second;
  const auto id = static_cast<uint32_t>(channel_names_.size());
  const auto added = channel_ids_.emplace(std::string(name), id).first;
  channel_names_.push_back(added->first);
  channel_readers_.emplace_back();
  wanted_elsewhere_.push_back(is_wanted_elsewhere_ && is_wanted_elsewhere_(name));
  ranks_valid_ = false;
  return id;
}

/// A broker publishes the same bytes on the channels of many receivers: they are kept once.
MessageViews* MemoryBus::Publish(Item item, std::span<const uint8_t> data) {
  const Content* last = open_.num_contents == 0 ? nullptr : &open_.contents[open_.num_contents - 1];
  if (last == nullptr || last->size != data.size() ||
      !std::equal(data.begin(), data.end(), open_.arena.data() + last->begin)) {
    if (open_.num_contents == open_.contents.size()) open_.contents.emplace_back();
    Content& content = open_.contents[open_.num_contents++];
    content.begin = open_.arena.size();
    content.size = data.size();
    content.views.Clear();
    open_.arena.insert(open_.arena.end(), data.begin(), data.end());
  }
  item.content = open_.num_contents - 1;
  open_.items.push_back(item);
  return &open_.contents[item.content].views;
}

void MemoryBus::RankChannels() {
  rank_of_channel_.resize(channel_names_.size());
  subscribers_begin_.assign(1, 0);
  subscribers_.clear();
  uint32_t rank = 0;
  for (const auto& [name, id] : channel_ids_) {
    rank_of_channel_[id] = rank++;
    const std::vector<Subscriber>& readers = channel_readers_[id];
    subscribers_.insert(subscribers_.end(), readers.begin(), readers.end());
    subscribers_begin_.push_back(static_cast<uint32_t>(subscribers_.size()));
  }
  ranks_valid_ = true;
}

/// Puts the items of the step that ended into the fixed order: by counting how many a channel has,
/// since most have one.
void MemoryBus::SortItems() {
  std::vector<Item>& items = closed_.items;
  places_.assign(rank_of_channel_.size() + 1, 0);
  for (Item& item : items) ++places_[rank_of_channel_[item.channel] + 1];
  for (size_t rank = 1; rank < places_.size(); ++rank) places_[rank] += places_[rank - 1];
  sorted_.resize(items.size());
  for (const Item& item : items) sorted_[places_[rank_of_channel_[item.channel]]++] = item;
  items.swap(sorted_);
  const auto comes_before = [](const Item& a, const Item& b) {
    return std::tie(a.port, a.sequence) < std::tie(b.port, b.sequence);
  };
  for (auto begin = items.begin(); begin != items.end();) {
    auto end = begin + 1;
    while (end != items.end() && end->channel == begin->channel) ++end;
    if (!std::is_sorted(begin, end, comes_before)) std::sort(begin, end, comes_before);
    begin = end;
  }
}

/// Lists for every participant what it receives, in order.
void MemoryBus::Address() {
  places_.assign(ports_.size() + 1, 0);
  const auto readers_of = [this](const Item& item) {
    const uint32_t rank = rank_of_channel_[item.channel];
    return std::span(subscribers_)
        .subspan(subscribers_begin_[rank], subscribers_begin_[rank + 1] - subscribers_begin_[rank]);
  };
  for (const Item& item : closed_.items) {
    for (const Subscriber& reader : readers_of(item)) ++places_[reader.port + 1];
  }
  for (size_t port = 1; port < places_.size(); ++port) places_[port] += places_[port - 1];
  deliveries_begin_.assign(places_.begin(), places_.end());
  deliveries_.resize(places_.back());
  for (uint32_t i = 0; i < closed_.items.size(); ++i) {
    for (const Subscriber& reader : readers_of(closed_.items[i])) {
      deliveries_[places_[reader.port]++] = {.item = i, .handler = reader.handler};
    }
  }
}

void MemoryBus::NextStep() {
  if (!ranks_valid_) RankChannels();
  if (names_by_rank_.empty()) RankPorts();
  ++step_;
  std::swap(closed_, open_);
  open_.items.clear();
  open_.arena.clear();
  open_.num_contents = 0;
  SortItems();
  Address();
}

void MemoryBus::Handle(Bus& participant_bus) {
  auto& port = static_cast<Port&>(participant_bus);
  const auto message_of = [&](const Item& item) {
    Content& content = closed_.contents[item.content];
    return Message{.channel = channel_names_[item.channel],
                   .publisher = names_by_rank_[item.port],
                   .data = std::span(closed_.arena).subspan(content.begin, content.size),
                   .views = &content.views};
  };
  const uint32_t end = deliveries_begin_[port.number + 1];
  for (uint32_t i = deliveries_begin_[port.number]; i < end; ++i) {
    const Delivery& delivery = deliveries_[i];
    port.Run(handlers_[delivery.handler], message_of(closed_.items[delivery.item]));
  }
  for (const Bus::Handler& handler : port.all_handlers) {
    for (const Item& item : closed_.items) port.Run(handler, message_of(item));
  }
}

void MemoryBus::HandleAll() {
  for (auto& [name, port] : ports_) Handle(*port);
}

}  // namespace shoal
