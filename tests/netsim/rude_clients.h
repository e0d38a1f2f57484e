// A crowd that connects, sends halves of requests, resets, comes again from the same source port,
// scans, stalls and floods: the same crowd for the same seed.
#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tests/netsim/tcp_client.h"

namespace shoal {

class RudeClients {
 public:
  /// `request` is a line with its end.
  RudeClients(int port, size_t number, uint32_t seed, std::string request)
      : port_(port), request_(std::move(request)), clients_(number), dice_(seed) {}

  /// One of them does something.
  void Act() {
    std::unique_ptr<TcpClient>& client = clients_[Roll(clients_.size())];
    if (client == nullptr || !client->is_open()) {
      client = std::make_unique<TcpClient>(port_);
      return;
    }
    switch (Roll(10)) {
      case 0:
        client->Send(request_.substr(0, Roll(request_.size())));
        break;
      case 1:
        client->Send(request_.substr(Roll(request_.size())));
        break;
      case 2:
        client->Send(request_);
        client->Receive();
        break;
      case 3:
        client->Reset();
        break;
      case 4:
        ComeAgain(&client);
        break;
      case 5:
        TcpClient(port_).Reset();
        break;
      case 6:
        Flood(client.get());
        break;
      case 7:
        client->Send(std::string(1 + Roll(5'000), static_cast<char>(Roll(256))));
        break;
      case 8:
        client->CloseOwnSide();
        break;
      default:
        client->Close();
        break;
    }
  }

 private:
  size_t Roll(size_t sides) { return dice_() % sides; }

  void ComeAgain(std::unique_ptr<TcpClient>* client) {
    const int source_port = (*client)->source_port();
    (*client)->Reset();
    *client = std::make_unique<TcpClient>(port_, "127.0.0.1", source_port);
  }

  /// Never reads the answers.
  void Flood(TcpClient* client) {
    std::string requests;
    for (int i = 0; i < 100; ++i) requests += request_;
    for (int i = 0; i < 5; ++i) client->Send(requests);
  }

  int port_;
  std::string request_;
  std::vector<std::unique_ptr<TcpClient>> clients_;
  std::mt19937 dice_;
};

}  // namespace shoal
