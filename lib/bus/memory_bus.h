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
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "lib/bus/bus.h"

namespace shoal {

class MemoryBus {
 public:
  MemoryBus();
  ~MemoryBus();

  /// Adds a participant and returns its bus, which lives as long as this hub.
  /// @pre no participant of this name yet, and no step was taken yet.
  Bus& Join(const std::string& participant);

  /// Ends a step: puts what was published during it into the fixed order (channel, publisher,
  /// publisher's sequence) and makes it what the handlers see next.
  void NextStep();

  /// Runs the handlers of one participant for the step that ended last.
  void Handle(Bus& participant_bus);

  /// Runs the handlers of all participants, in order of their names.
  void HandleAll();

 private:
  class Port;
  struct Item {
    uint32_t channel_id;  ///< Into channels_.
    uint32_t port_rank;   ///< The publisher's place in order of names.
    uint32_t sequence;    ///< Counts the publisher's messages of the step.
    uint32_t content;     ///< Messages of the same number have the same bytes.
    size_t begin;         ///< Of the bytes, in the arena.
    size_t size;
    uint32_t channel_rank = 0;  ///< As ChannelInfo has it.
  };
  struct ChannelInfo {
    std::string name;
    std::vector<std::pair<Port*, size_t>> subscribers;  ///< Port and index of its handler.
    uint32_t rank = 0;                                  ///< Place in order of names.
  };
  /// What several messages of a step, or several subscribers of one, have in common.
  struct Content {
    size_t num_readers = 0;
    std::unique_ptr<MessageViews> views = nullptr;  ///< Its storage outlives the step.
  };

  uint32_t ChannelId(std::string_view name);
  void Publish(Item item, std::span<const uint8_t> data);
  void RankPorts();
  void RankNames();

  std::map<std::string, std::unique_ptr<Port>> ports_;
  std::vector<std::string_view> names_by_rank_;
  std::unordered_map<std::string, uint32_t> channel_ids_;
  std::vector<ChannelInfo> channels_;
  bool ranks_valid_ = false;
  std::vector<Item> open_items_;  ///< Of the step that goes on.
  Bytes open_arena_;
  uint32_t num_open_contents_ = 0;
  uint32_t step_ = 0;               ///< Counts the calls of NextStep.
  uint32_t num_subscriptions_ = 0;  ///< Of all participants.
  bool has_listener_ = false;       ///< A participant subscribes to all channels.
  std::vector<Item> order_;         ///< Of the step that ended, in the fixed order.
  Bytes arena_;
  std::vector<Content> contents_;
  std::vector<Port*> receivers_;  ///< Ports with something in their inbox.
};

}  // namespace shoal
