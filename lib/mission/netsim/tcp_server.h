// Serves TCP clients without waiting, beside other work in one thread.
//
//   auto server = TcpServer::Listen(options, {.on_bytes = [&](ClientId client, auto bytes) {
//     (*server)->Send(client, bytes);
//   }});
//   while (...) {
//     transport.Poll(timeout_us, (*server)->fd());  // Or ppoll() on it.
//     (*server)->Serve(now_us);
//   }
//
// Clients cannot harm the server: each has bounded memory; from one that sends and does not read
// nothing is read any more, and it is closed if that lasts; one that resets its connection, before
// it was accepted or after, is removed. What a client sent before it closed its side is handled,
// and answered before ours is closed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

/// A connection; never used again for another.
using ClientId = uint64_t;

struct TcpServerOptions {
  std::string address = "127.0.0.1";  ///< IPv4.
  int port = 0;                       ///< 0: one that is free.
  int max_connections = 128;          ///< Further ones are closed at once, but see silence_us.
  size_t max_unsent_bytes =
      size_t{256} * 1024;       ///< Per client, beyond what the kernel takes. Over half of
                                ///< it nothing is read; over all of it, it is closed.
  int64_t idle_timeout_us = 0;  ///< Without a byte from the client; 0: for ever.
  int64_t stall_timeout_us = 30'000'000;  ///< With something to send, none of it taken.
  /// With max_connections clients, a further one takes the place of the longest silent, if that has
  /// sent nothing since it connected, or nothing for so long; 0: it is closed itself.
  int64_t silence_us = 0;
};

struct TcpServerCounts {
  int64_t accepted = 0;
  int64_t refused = 0;         ///< More than max_connections.
  int64_t failed_accepts = 0;  ///< Reset before they were accepted, or no descriptors left.
  int64_t broken = 0;          ///< Reset, or lost.
  int64_t idle = 0;            ///< Closed for it.
  int64_t stalled = 0;         ///< Closed for it.
  int64_t displaced = 0;       ///< Silent ones that were closed for another client.
};

class TcpServer {
 public:
  /// Called in Serve; they may call Send and Close. Empty ones are not called.
  struct Handlers {
    std::function<void(ClientId, const std::string& address)> on_connect = {};
    std::function<void(ClientId, std::string_view bytes)> on_bytes = {};
    std::function<void(ClientId)> on_close = {};  ///< For whatever reason; not by the destructor.
    /// A client that was closed at once, since there are max_connections.
    std::function<void(const std::string& address)> on_refuse = {};
  };

  /// Fails with what to try.
  static Result<std::unique_ptr<TcpServer>> Listen(const TcpServerOptions& options,
                                                   Handlers handlers);
  TcpServer(const TcpServer&) = delete;
  TcpServer& operator=(const TcpServer&) = delete;

  /// Readable when Serve has something to do, but for timeouts: call that once a second anyway.
  int fd() const { return epoll_.get(); }
  int port() const { return port_; }

  /// Serves all clients in turn without waiting, within a bounded time. `now_us` never goes back.
  void Serve(int64_t now_us);

  /// Sends at once what the kernel takes, and the rest when it can. Nothing where the client has
  /// gone.
  void Send(ClientId client, std::string_view bytes);

  /// Closes when all that was sent before has left.
  void Close(ClientId client);

  /// Returns all connected clients, in the order in which they came.
  std::vector<ClientId> Clients() const;
  const TcpServerCounts& counts() const { return counts_; }
  /// Bytes that wait for their clients.
  size_t num_unsent_bytes() const;

 private:
  struct Client {
    FileDescriptor socket;
    std::string unsent = {};
    int64_t received_us = 0;    ///< When it last sent something; at first, when it connected.
    bool has_sent = false;      ///< Anything.
    int64_t progressed_us = 0;  ///< When it last took something, or had nothing to take.
    uint32_t awaited = 0;       ///< Events, as epoll knows them.
    bool is_closing = false;    ///< Nothing is read from it any more.
    bool is_gone = false;       ///< To be removed by the next Serve.
  };

  TcpServer(const TcpServerOptions& options, Handlers handlers, FileDescriptor listener,
            FileDescriptor epoll, int port);
  void Accept();
  void Take(int socket, const std::string& address);
  void SetAccepting(bool accepting);
  void OnEvents(ClientId id, uint32_t events);
  void Read(ClientId id, Client* client);
  void Flush(Client* client);
  void Await(ClientId id, Client* client);
  bool MakeRoom();
  void CloseTheSilent();
  void Touch(ClientId id);
  void Settle();
  Client* Find(ClientId id);

  TcpServerOptions options_;
  Handlers handlers_;
  FileDescriptor listener_;
  FileDescriptor epoll_;
  int port_;
  std::map<ClientId, Client> clients_;
  std::vector<ClientId> touched_;  ///< Sent to, or to be forgotten, since the last look.
  ClientId last_id_ = 0;           ///< 0 stands for the listener.
  int64_t now_us_ = 0;
  int64_t accept_again_us_ = 0;  ///< When there were no descriptors left.
  bool is_accepting_ = true;
  bool is_serving_ = false;
  TcpServerCounts counts_;
};

}  // namespace shoal
