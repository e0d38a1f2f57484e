// One client's connection: reads and writes with time limits.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include "apps/viewer/http_head.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

/// How long a client may take.
struct Patience {
  std::chrono::milliseconds head{5'000};   ///< For the first head, from the connection on.
  std::chrono::milliseconds body{5'000};   ///< From the head on.
  std::chrono::milliseconds idle{15'000};  ///< For the next head, from the last answer on.
  /// To take what is written at once: a frame, or an answer. A long one gets a second more for
  /// each 500,000 bytes.
  std::chrono::milliseconds write{4'000};
  std::chrono::milliseconds linger{500};  ///< To take the last answer before the socket is closed.
};

class Connection {
 public:
  /// Takes over an accepted, non-blocking socket.
  Connection(FileDescriptor socket, const Patience& patience);

  /// Waits for the head of the next request. Status 0: the client has disconnected, or has been
  /// idle for too long; 408: it began, and was too slow. A sound head is what Read gives first.
  CheckedHead AwaitHead();

  /// Reads what is left of the head, then of the body that follows it. Returns 0 at the end of what
  /// the client sends, -1 where it was too slow.
  ssize_t Read(char* bytes, size_t size);

  /// Writes all of it, or returns false: the client has disconnected or is too slow.
  bool Write(std::string_view bytes);

  /// True where the client has closed its side or reset the connection, and no bytes
  /// wait to be read.
  bool HasGone() const;

  /// Shuts down the sending side and discards what still comes, so that a client that goes on
  /// sending gets the last answer.
  void Linger();

  /// Makes every wait of this connection end now. From any thread.
  void Cut();

  /// True between two requests, and during a head that has not ended: closing it then loses
  /// nothing.
  bool is_waiting() const { return is_waiting_; }
  /// The time of the last change of is_waiting().
  std::chrono::steady_clock::time_point since() const { return since_.load(); }
  int fd() const { return socket_.get(); }

 private:
  using Clock = std::chrono::steady_clock;
  /// Waits for `events` of poll(). False: too late.
  bool Await(short events, Clock::time_point deadline) const;
  /// Appends what has come to received_. False: too late, or the client has disconnected.
  bool Receive(Clock::time_point deadline);

  FileDescriptor socket_;
  const Patience patience_;
  std::string received_;  ///< And not handed out yet.
  std::string head_;      ///< To be read first.
  Clock::time_point read_deadline_;
  bool is_first_ = true;
  std::atomic<bool> is_waiting_ = true;
  std::atomic<Clock::time_point> since_;
};

}  // namespace shoal
