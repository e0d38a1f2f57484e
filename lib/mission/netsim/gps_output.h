// Where a simulated vehicle's GPS sentences go: to all clients that connect to a TCP port, and into
// a file, a serial line or a pseudo-terminal.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/mission/netsim/netsim_options.h"
#include "lib/mission/netsim/tcp_server.h"

namespace shoal {

/// Never waits: a client that does not read in time loses sentences, or the connection.
class GpsOutput {
 public:
  static constexpr int kMaxClients = 16;

  /// Opens what `gps` names; ports listen on `address`. Files are appended to. Terminals are made
  /// raw, so that lines arrive as they are written. `on_refuse`: called in Serve with the address
  /// of a client beyond kMaxClients. Fails with what to try.
  static Result<std::unique_ptr<GpsOutput>> Open(
      const NetsimGps& gps, const std::string& address,
      std::function<void(const std::string& address)> on_refuse = {});

  void Write(std::string_view sentence);

  /// As of TcpServer; negative without a port.
  int fd() const { return server_ == nullptr ? -1 : server_->fd(); }
  int port() const { return server_ == nullptr ? 0 : server_->port(); }
  void Serve(int64_t now_us);
  /// Of the port's clients. @pre port() > 0
  const TcpServerCounts& counts() const { return server_->counts(); }

  /// Sentences that the file did not take, or not wholly.
  int64_t num_lost() const { return num_lost_; }

 private:
  GpsOutput() = default;

  std::unique_ptr<TcpServer> server_;
  FileDescriptor file_;
  int64_t num_lost_ = 0;
};

}  // namespace shoal
