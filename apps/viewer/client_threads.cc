#include "apps/viewer/client_threads.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <system_error>

namespace shoal {

ClientThreads::ClientThreads(int listening_fd, CrowdLimits limits, Serve serve)
    : listening_fd_(listening_fd),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      limits_(std::move(limits)),
      serve_(std::move(serve)) {}

ClientThreads::~ClientThreads() {
  Stop();
  for (Client& client : clients_) client.thread.join();
}

size_t ClientThreads::num_connections() const {
  const std::lock_guard lock(mutex_);
  return static_cast<size_t>(std::count_if(clients_.begin(), clients_.end(),
                                           [](const Client& each) { return !each.has_ended; }));
}

void ClientThreads::Stop() {
  stopped_ = true;
  eventfd_write(wake_.get(), 1);
  const std::lock_guard lock(mutex_);
  for (Client& client : clients_) {
    if (!client.has_ended) client.connection->Cut();
  }
}

void ClientThreads::Run() {
  constexpr int kReapInterval_ms = 200;
  while (!stopped_) {
    std::array<pollfd, 2> descriptors = {
        pollfd{.fd = listening_fd_, .events = POLLIN, .revents = 0},
        pollfd{.fd = wake_.get(), .events = POLLIN, .revents = 0}};
    poll(descriptors.data(), descriptors.size(), kReapInterval_ms);
    Reap();
    if (stopped_ || (descriptors[0].revents & POLLIN) == 0) continue;
    FileDescriptor socket(accept4(listening_fd_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (socket.is_open()) {
      Admit(std::move(socket));
    } else if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
      // The connection stays in the queue, and would wake this loop at once again.
      // The client that was cut to make room needs a moment to close.
      MakeRoom();
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
  while (true) {
    {
      const std::lock_guard lock(mutex_);
      if (clients_.empty()) return;
    }
    // Clients that were admitted during Stop() are cut here.
    Stop();
    Reap();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void ClientThreads::Admit(FileDescriptor socket) {
  if (num_connections() >= limits_.most_connections && !MakeRoom()) {
    Refuse(std::move(socket));
    return;
  }
  const std::lock_guard lock(mutex_);
  Client& client = clients_.emplace_back();
  client.connection = std::make_unique<Connection>(std::move(socket), limits_.patience);
  try {
    client.thread = std::thread([this, &client] {
      serve_(*client.connection);
      const std::lock_guard ending(mutex_);
      client.connection.reset();
      client.has_ended = true;
    });
  } catch (const std::system_error&) {  // No more threads.
    clients_.pop_back();
  }
}

bool ClientThreads::MakeRoom() {
  const std::lock_guard lock(mutex_);
  Client* oldest = nullptr;
  for (Client& client : clients_) {
    if (client.has_ended || !client.connection->is_waiting()) continue;
    if (oldest == nullptr || client.connection->since() < oldest->connection->since()) {
      oldest = &client;
    }
  }
  if (oldest == nullptr) return false;
  oldest->connection->Cut();
  return true;
}

void ClientThreads::Reap() {
  std::list<Client> ended;
  {
    const std::lock_guard lock(mutex_);
    for (auto each = clients_.begin(); each != clients_.end();) {
      const auto next = std::next(each);
      if (each->has_ended) ended.splice(ended.end(), clients_, each);
      each = next;
    }
  }
  for (Client& client : ended) client.thread.join();
}

void ClientThreads::Refuse(FileDescriptor socket) const {
  // What does not fit into the empty buffer of a new socket is lost; this never waits.
  send(socket.get(), limits_.busy_answer.data(), limits_.busy_answer.size(), MSG_NOSIGNAL);
  shutdown(socket.get(), SHUT_WR);
}

}  // namespace shoal
