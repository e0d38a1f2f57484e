// Connects participants inside one process, step by step.
//
//   MemoryBus hub;
//   Bus& helm_bus = hub.Join("helm_alpha");
//   Bus& test_bus = hub.Join("test");
//   HelmApp helm(mission, vehicle, helm_bus);
//   Publish(test_bus, channels::HelmCommand("alpha"), command);
//   hub.NextStep();      // what was published so far belongs to the step that ends here
//   hub.HandleAll();     // runs the handlers of every participant
//   helm.Tick(utime);
//
// A mission may be stepped in parts, each with a hub of its own, on threads, processes or machines.
// Every part knows all participants by name, so that all put messages into the same order:
//
//   const auto bravo = hub.JoinElsewhere("helm_bravo");
//   hub.KeepFor([&](std::string_view channel) { return others_read.contains(channel); });
//   ... the participants here are ticked ...
//   hub.VisitPublished([&](const MemoryBus::Published& each) { Send(each); });
//   hub.Insert(bravo, channel, sequence, data);    // what came from the other parts
//   hub.NextStep();
//
// A participant may itself be shared by several parts: each publishes at places of its own
// (Bus::SetPlace), and all parts order by them.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/bus.h"

namespace shoal {

class MemoryBus {
 public:
  MemoryBus();
  ~MemoryBus();

  /// Adds a participant and returns its bus, which lives as long as this hub.
  /// @pre no participant of this name yet, and no step was taken yet.
  Bus& Join(const std::string& participant);

  /// Adds a participant that other parts step too: what they publish in its name comes by Insert,
  /// and is ordered by Bus::SetPlace. Else as Join.
  Bus& JoinShared(const std::string& participant);

  /// Adds a participant that another part steps: what it publishes comes by Insert. "" stands for
  /// messages from outside. At any time; participants have unique names. Returns its number.
  uint32_t JoinElsewhere(const std::string& participant);

  /// Adds a message that a participant of another part published in the step that goes on.
  /// `sequence` orders its messages of the step, over all channels; each (participant, sequence)
  /// comes once. Where nothing here reads the channel, it is dropped.
  /// @pre `participant` is from JoinElsewhere or JoinShared
  void Insert(uint32_t participant, std::string_view channel, uint32_t sequence,
              std::span<const uint8_t> data) {
    Insert(participant, ChannelNumber(channel), sequence, data);
  }
  /// The same, sooner. @pre `channel` is from ChannelNumber
  void Insert(uint32_t participant, uint32_t channel, uint32_t sequence,
              std::span<const uint8_t> data);
  /// Returns the number of a channel in this hub.
  uint32_t ChannelNumber(std::string_view name);

  /// Keeps what participants here publish on channels that are wanted elsewhere, read here or not.
  /// To be called again when other channels are wanted; empty: none is.
  void KeepFor(std::function<bool(std::string_view channel)> is_wanted_elsewhere);

  /// What a participant here published. The views live until the next call of this hub's.
  struct Published {
    std::string_view channel;
    std::string_view publisher;
    uint32_t sequence = 0;  ///< Orders the publisher's messages of the step, over all channels.
    std::span<const uint8_t> data;
    uint32_t content = 0;  ///< Messages of one step with the same number have the same bytes.
    uint32_t channel_number = 0;  ///< As ChannelNumber has it.
    uint32_t participant = 0;     ///< The publisher: how many joined before it, here or elsewhere.
  };
  /// Visits what participants here have published in the step that goes on and is wanted
  /// elsewhere, in the order in which it was published.
  /// @pre nothing was inserted yet in this step
  void VisitPublished(const std::function<void(const Published&)>& visit) const;

  /// Returns the channels that participants here subscribe to, in order of names.
  std::vector<std::string_view> SubscribedChannels() const;
  /// True where a participant here subscribes to all channels.
  bool has_listener() const { return has_listener_; }

  /// Ends all subscriptions of a participant, whose app is gone. Another one may subscribe again.
  /// @pre its handlers have run for the step that ended last
  void EndSubscriptions(Bus& participant_bus);

  /// Ends a step: puts what was published during it into the fixed order (channel, publisher,
  /// publisher's sequence) and makes it what the handlers see next.
  void NextStep();

  /// Runs the handlers of one participant for the step that ended last.
  void Handle(Bus& participant_bus);

  /// Runs the handlers of all participants, in order of their names.
  void HandleAll();

 private:
  class Port;
  /// A message, 16 bytes: a step of a large fleet has thousands.
  struct Item {
    uint32_t channel = 0;   ///< Its id.
    uint32_t port = 0;      ///< The publisher's place in order of names.
    uint32_t sequence = 0;  ///< Orders the publisher's messages of the step.
    uint32_t content = 0;   ///< Messages of the same number have the same bytes.
  };
  struct Content {
    size_t begin = 0;  ///< Of the bytes, in the arena.
    size_t size = 0;
    MessageViews views = {};  ///< Its storage outlives the step.
  };
  /// What is published in one step.
  struct Traffic {
    std::vector<Item> items;
    Bytes arena;
    std::vector<Content> contents;  ///< The first num_contents are of this step.
    uint32_t num_contents = 0;
  };
  struct Subscriber {
    uint32_t port = 0;     ///< In order of joining.
    uint32_t handler = 0;  ///< Into handlers_.
  };
  struct Delivery {
    uint32_t item = 0;     ///< Into closed_.items.
    uint32_t handler = 0;  ///< Into handlers_.
  };

  MessageViews* Publish(Item item, std::span<const uint8_t> data);
  Port& AddPort(const std::string& participant);
  bool IsRead(uint32_t channel) const;
  void RankPorts();
  void RankChannels();
  void SortItems();
  void Address();

  std::map<std::string, std::unique_ptr<Port>> ports_;
  std::vector<Port*> ports_by_number_;           ///< In order of joining.
  std::vector<std::string_view> names_by_rank_;  ///< Empty: to be ranked.
  /// Participants subscribe in the order in which they are stepped, hence these are met in order.
  std::deque<Bus::Handler> handlers_;
  uint32_t num_subscriptions_ = 0;  ///< Of all participants here; grows when one ends, too.
  bool has_listener_ = false;       ///< A participant subscribes to all channels.

  std::map<std::string, uint32_t, std::less<>> channel_ids_;
  std::vector<std::string_view> channel_names_;           ///< By id.
  std::vector<std::vector<Subscriber>> channel_readers_;  ///< By id.
  std::vector<bool> wanted_elsewhere_;                    ///< By id.
  std::function<bool(std::string_view)> is_wanted_elsewhere_;
  bool ranks_valid_ = false;
  std::vector<uint32_t> rank_of_channel_;    ///< Place in order of names, by id.
  std::vector<uint32_t> subscribers_begin_;  ///< By rank, and the end.
  std::vector<Subscriber> subscribers_;      ///< In order of rank.

  uint32_t step_ = 0;  ///< Counts the calls of NextStep.
  Traffic open_;       ///< Of the step that goes on.
  Traffic closed_;     ///< Of the step that ended, its items in the fixed order.
  std::vector<uint32_t> deliveries_begin_;  ///< By port in order of joining, and the end.
  std::vector<Delivery> deliveries_;        ///< Of the step that ended: port by port.
  std::vector<uint32_t> places_;            ///< Of SortItems and Address, kept for its storage.
  std::vector<Item> sorted_;                ///< Likewise.
};

}  // namespace shoal
