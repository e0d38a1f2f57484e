// A server and its clients in one thread: everything happens when a test calls it, and no test
// waits for a while to see that nothing comes.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>

#include <functional>
#include <memory>
#include <vector>

#include "lib/mission/netsim/line_server.h"
#include "tests/netsim/tcp_client.h"

namespace shoal {

/// Turns that something on its way over loopback may take; each waits up to 10 ms, so that a test
/// that fails ends.
inline constexpr int kMaxTurns = 1000;

/// Serves, again and again, until `is_done`; false where that never comes.
inline bool ServeUntil(LineServer* server, int64_t now_us, const std::function<bool()>& is_done) {
  for (int turn = 0; turn < kMaxTurns; ++turn) {
    server->Serve(now_us);
    if (is_done()) return true;
    pollfd waited{.fd = server->fd(), .events = POLLIN, .revents = 0};
    poll(&waited, 1, 10);
  }
  return false;
}

/// Serves until the client has all that it will ever get, and returns it.
inline std::string ReceiveAll(LineServer* server, int64_t now_us, TcpClient* client) {
  client->CloseOwnSide();
  EXPECT_TRUE(ServeUntil(server, now_us, [&] {
    client->Receive();
    return client->has_ended();
  }));
  return client->received();
}

/// Serves until the client has received this many bytes, or the time limit is over.
inline bool ReceiveBytes(LineServer* server, int64_t now_us, TcpClient* client, size_t num_bytes) {
  return ServeUntil(server, now_us, [&] {
    client->Receive();
    return client->received().size() >= num_bytes;
  });
}

inline std::unique_ptr<LineServer> ListenOrFail(const TcpServerOptions& options,
                                                size_t max_line_bytes,
                                                LineServer::Answerer answerer) {
  auto server = LineServer::Listen(options, max_line_bytes, std::move(answerer));
  EXPECT_TRUE(server.ok()) << (server.ok() ? "" : server.error());
  return server.ok() ? std::move(*server) : nullptr;
}

}  // namespace shoal
