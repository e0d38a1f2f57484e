// Accepts connections and serves each in a thread of its own, so that no client waits for another:
// streams last for hours, and cpp-httplib's pool of eight threads would starve with the eighth.
//
//   ClientThreads clients(listening_fd, {}, [](Connection& connection) { ... });
//   clients.Run();      // until Stop(), from another thread
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "apps/viewer/connection.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

struct CrowdLimits {
  size_t most_connections = 300;
  Patience patience;
  std::string busy_answer = {};  ///< What a client gets where there is no room.
};

class ClientThreads {
 public:
  using Serve = std::function<void(Connection&)>;

  /// `listening_fd` must outlive this.
  ClientThreads(int listening_fd, CrowdLimits limits, Serve serve);
  ~ClientThreads();
  ClientThreads(const ClientThreads&) = delete;
  ClientThreads& operator=(const ClientThreads&) = delete;

  /// Accepts until Stop(); returns when the last thread has ended. Where there is no room, the
  /// client that has waited longest without a request is cut; if all are being served, the new one.
  void Run();

  /// Ends all connections. From any thread, any number of times.
  void Stop();

  bool stopped() const { return stopped_; }
  size_t num_connections() const;

 private:
  struct Client {
    std::unique_ptr<Connection> connection;
    std::thread thread;
    std::atomic<bool> has_ended = false;
  };

  void Admit(FileDescriptor socket);
  bool MakeRoom();
  void Reap();
  void Refuse(FileDescriptor socket) const;

  int listening_fd_;
  FileDescriptor wake_;
  const CrowdLimits limits_;
  const Serve serve_;
  std::atomic<bool> stopped_ = false;
  mutable std::mutex mutex_;
  std::list<Client> clients_;
};

}  // namespace shoal
