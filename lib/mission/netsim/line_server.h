// Clients that send lines and get answers: one after the other, in order, each once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "lib/base/check/result.h"
#include "lib/mission/netsim/line_framer.h"
#include "lib/mission/netsim/tcp_server.h"

namespace shoal {

class LineServer {
 public:
  /// Gets a line without its end, and the sender's IPv4 address; returns what to send back, with
  /// its ends, or nothing.
  using Answerer = std::function<std::string(const std::string& address, std::string_view line)>;

  /// Fails with what to try.
  static Result<std::unique_ptr<LineServer>> Listen(const TcpServerOptions& options,
                                                    size_t max_line_bytes, Answerer answerer);
  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;

  /// As of TcpServer.
  int fd() const { return server_->fd(); }
  int port() const { return server_->port(); }
  void Serve(int64_t now_us) { server_->Serve(now_us); }
  const TcpServerCounts& counts() const { return server_->counts(); }

  size_t num_clients() const { return clients_.size(); }
  /// Lines that were skipped: longer than allowed.
  int64_t num_too_long() const { return num_too_long_; }
  /// Memory for lines that have not ended and answers that have not left.
  size_t num_waiting_bytes() const;

 private:
  struct Client {
    std::string address;
    LineFramer framer;
  };

  LineServer(size_t max_line_bytes, Answerer answerer)
      : max_line_bytes_(max_line_bytes), answerer_(std::move(answerer)) {}
  TcpServer::Handlers Handlers();
  void OnBytes(ClientId id, std::string_view bytes);

  size_t max_line_bytes_;
  Answerer answerer_;
  std::map<ClientId, Client> clients_;
  int64_t num_too_long_ = 0;
  std::unique_ptr<TcpServer> server_;
};

}  // namespace shoal
