// The modem of one outside vehicle: a TCP port with one client, and the water on the other side.
//
//   auto port = ModemPort::Open(vehicle, options);
//   (*port)->Serve(wall_us, mission_us);             // clients
//   (*port)->Receive(packet, mission_us);            // what the network delivered
//   for (auto& sent : (*port)->TakeTransmissions()) Transmit(sent.bytes, sent.data_rate_bps);
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/mission/netsim/netsim_options.h"
#include "lib/mission/netsim/tcp_server.h"
#include "lib/sea/modem/micromodem.h"
#include "lib/sea/modem/raw_modem.h"

namespace shoal {

struct ModemPortOptions {
  std::string address = "127.0.0.1";  ///< To listen on.
  int port = 0;
  NetsimModem kind = NetsimModem::kRaw;
  int modem_address = 0;      ///< Of a Micro-Modem at first, 1 to 127; others ignore it.
  double water_bps = 0;       ///< The acoustic network's data rate; 0: not known.
  size_t more_bytes = 0;      ///< On the air, with each packet: a checksum.
  size_t max_bytes = 65'535;  ///< That an acoustic packet holds.
  /// Called in Serve with the address of a second client, which is closed at once.
  std::function<void(const std::string& address)> on_refuse = {};
};

/// A packet to transmit.
struct ModemTransmission {
  std::vector<uint8_t> bytes;
  double data_rate_bps = 0;  ///< 0: the network's.
};

/// A packet that the acoustic network delivered.
struct ModemPacket {
  std::vector<uint8_t> bytes;
  int64_t start_us = 0;   ///< Mission time at which its first byte arrived.
  int64_t travel_us = 0;  ///< From the sender to here.
  std::optional<double> snr_db;
};

class ModemPort {
 public:
  /// Packets given to the water between two calls of TakeTransmissions; further ones are dropped.
  static constexpr size_t kMaxWaiting = 256;

  /// Fails with what to try.
  static Result<std::unique_ptr<ModemPort>> Open(const ModemPortOptions& options);
  virtual ~ModemPort() = default;

  int fd() const { return server_->fd(); }
  int port() const { return server_->port(); }

  /// Serves the client, and does what is due at `mission_us`, which never goes back.
  void Serve(int64_t wall_us, int64_t mission_us);
  /// Takes a packet, client or not: a modem receives also while its host is away.
  virtual void Receive(const ModemPacket& packet, int64_t mission_us) = 0;
  /// Sets the modem's clock, where it has one.
  virtual void SetClock(int64_t, int64_t) {}

  /// Returns what is to be transmitted in the step at `mission_us`, and forgets it.
  std::vector<ModemTransmission> TakeTransmissions(int64_t mission_us);
  /// Returns a line or two for a status page, four blanks before each.
  virtual std::string Text() const = 0;

 protected:
  ModemPort() = default;
  virtual void OnConnect() {}
  virtual void OnClose() {}
  virtual void OnBytes(std::string_view bytes, int64_t mission_us) = 0;
  virtual void Advance(int64_t) {}
  /// Called at each step, before what is to be sent is taken.
  virtual void BeforeStep(int64_t) {}
  /// Nothing where no client is connected.
  void SendToClient(std::string_view bytes);
  void Transmit(ModemTransmission transmission);
  std::string ClientText() const;

 private:
  Result<bool> Listen(const ModemPortOptions& options);

  std::unique_ptr<TcpServer> server_;
  std::optional<ClientId> client_;
  std::string client_address_;
  int64_t mission_us_ = 0;
  std::vector<ModemTransmission> transmissions_;
  int64_t num_transmissions_ = 0;
  int64_t num_dropped_ = 0;
};

}  // namespace shoal
