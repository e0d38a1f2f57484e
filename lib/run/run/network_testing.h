// A network in memory for tests of the step protocol: it loses what the test wants lost, and hands
// the rest over when the test asks for it.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lib/bus/bus/transport.h"

namespace shoal {

class FakeNetwork {
 public:
  /// Decides, per datagram and receiver, whether it is lost.
  using Loss = std::function<bool(std::string_view channel)>;

  class Node : public Transport {
   public:
    explicit Node(FakeNetwork& network) : network_(network) {}
    void Send(int port, std::string_view channel, std::span<const uint8_t> datagram) override {
      for (const auto& node : network_.nodes_) {
        const bool listens = node->all_ports_.contains(port) ||
                             node->channels_.contains({port, std::string(channel)});
        if (!listens || (network_.loss_ && network_.loss_(channel))) continue;
        node->queue_.push_back({port, std::string(channel), {datagram.begin(), datagram.end()}});
      }
    }
    void Listen(int port, const std::string& channel) override { channels_.emplace(port, channel); }
    void ListenToAll(int port) override { all_ports_.insert(port); }

    /// Hands over what has arrived. Returns false where there was nothing.
    bool Deliver() {
      if (queue_.empty() || stopped_) return false;
      for (Datagram datagram = std::move(queue_.front());; datagram = std::move(queue_.front())) {
        queue_.pop_front();
        receiver(datagram.port, datagram.channel, datagram.bytes);
        if (queue_.empty()) return true;
      }
    }

    /// Plays a stopped process: nothing is handed over; what arrives waits.
    void set_stopped(bool stopped) { stopped_ = stopped; }

    Receiver receiver;

   private:
    struct Datagram {
      int port;
      std::string channel;
      std::vector<uint8_t> bytes;
    };
    FakeNetwork& network_;
    std::set<std::pair<int, std::string>> channels_;
    std::set<int> all_ports_;
    std::deque<Datagram> queue_;
    bool stopped_ = false;
  };

  Node& Add() { return *nodes_.emplace_back(std::make_unique<Node>(*this)); }
  void set_loss(Loss loss) { loss_ = std::move(loss); }

  /// Delivers until nothing is under way.
  void DeliverAll() {
    for (bool any = true; any;) {
      any = false;
      for (const auto& node : nodes_) any = node->Deliver() || any;
    }
  }

 private:
  std::vector<std::unique_ptr<Node>> nodes_;
  Loss loss_;
};

}  // namespace shoal
