// A client's socket for tests, with everything a client can do wrong; written from
// what TCP allows, not from the server.
#pragma once

#include <string>
#include <string_view>

#include "lib/bus/os/file_descriptor.h"

namespace shoal {

/// Never blocks. Errors show as false and in is_open().
class TcpClient {
 public:
  /// Connects to 127.0.0.1; over loopback that is done at once. `source_port` 0: any.
  explicit TcpClient(int port, const std::string& source_address = "127.0.0.1",
                     int source_port = 0);

  bool is_open() const { return socket_.is_open(); }
  int fd() const { return socket_.get(); }
  int source_port() const;

  /// Sends what the kernel takes, and returns how much that was.
  size_t Send(std::string_view bytes);
  /// Takes what has come, into received().
  void Receive();
  const std::string& received() const { return received_; }
  /// The server has closed its side, or reset the connection.
  bool has_ended() const { return has_ended_; }

  void CloseOwnSide();
  void Close() { socket_ = FileDescriptor(); }
  /// Closes with RST, as a process that crashes or a port scanner does.
  void Reset();

 private:
  FileDescriptor socket_;
  std::string received_;
  bool has_ended_ = false;
};

}  // namespace shoal
