#include "lib/mission/netsim/tcp_server.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <utility>

namespace shoal {

namespace {

constexpr ClientId kListener = 0;
constexpr int kBacklog = 256;
/// Limits of one call of Serve: rounds, clients per round, and new connections.
constexpr int kMaxRounds = 4;
constexpr size_t kMaxEvents = 64;
constexpr int kMaxAccepts = 64;
/// Bytes to read from one client before the next one is served.
constexpr size_t kChunk_bytes = size_t{16} * 1024;
/// Memory that a client keeps when all is sent.
constexpr size_t kKept_bytes = 4096;
constexpr int64_t kAcceptPause_us = 100'000;

void SetOption(int socket, int level, int option, int value) {
  setsockopt(socket, level, option, &value, sizeof value);
}

/// Notices hosts that have vanished, within two minutes.
void KeepAlive(int socket) {
  SetOption(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  SetOption(socket, IPPROTO_TCP, TCP_KEEPIDLE, 60);
  SetOption(socket, IPPROTO_TCP, TCP_KEEPINTVL, 20);
  SetOption(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);
}

std::string AddressText(const sockaddr_in& address) {
  std::array<char, INET_ADDRSTRLEN> text = {};
  inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size());
  return text.data();
}

bool IsOutOfDescriptors(int error) {
  return error == EMFILE || error == ENFILE || error == ENOBUFS || error == ENOMEM;
}

Error CannotListen(const TcpServerOptions& options, int error) {
  const char* remedy = "try another address or port";
  if (error == EADDRINUSE) remedy = "another program has this port: end it, or choose another port";
  if (error == EADDRNOTAVAIL) remedy = "this machine has no such address";
  if (error == EACCES) remedy = "ports below 1024 are the superuser's";
  return Error{fmt::format("cannot listen on {}:{}: {}; {}", options.address, options.port,
                           ErrnoText(error), remedy)};
}

void Watch(int epoll, int operation, int fd, ClientId id, uint32_t events) {
  epoll_event event{.events = events, .data = {.u64 = id}};
  epoll_ctl(epoll, operation, fd, &event);
}

}  // namespace

Result<std::unique_ptr<TcpServer>> TcpServer::Listen(const TcpServerOptions& options,
                                                     Handlers handlers) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(options.port));
  if (inet_pton(AF_INET, options.address.c_str(), &address.sin_addr) != 1) {
    return Error{fmt::format("'{}' is not an IPv4 address", options.address)};
  }
  FileDescriptor listener(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!listener.is_open()) return CannotListen(options, errno);
  SetOption(listener.get(), SOL_SOCKET, SO_REUSEADDR, 1);
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  socklen_t size = sizeof address;
  if (bind(listener.get(), generic, size) != 0 || listen(listener.get(), kBacklog) != 0 ||
      getsockname(listener.get(), generic, &size) != 0) {
    return CannotListen(options, errno);
  }
  FileDescriptor epoll(epoll_create1(EPOLL_CLOEXEC));
  if (!epoll.is_open()) return CannotListen(options, errno);
  Watch(epoll.get(), EPOLL_CTL_ADD, listener.get(), kListener, EPOLLIN);
  return std::unique_ptr<TcpServer>(new TcpServer(options, std::move(handlers), std::move(listener),
                                                  std::move(epoll), ntohs(address.sin_port)));
}

TcpServer::TcpServer(const TcpServerOptions& options, Handlers handlers, FileDescriptor listener,
                     FileDescriptor epoll, int port)
    : options_(options),
      handlers_(std::move(handlers)),
      listener_(std::move(listener)),
      epoll_(std::move(epoll)),
      port_(port) {}

TcpServer::Client* TcpServer::Find(ClientId id) {
  const auto client = clients_.find(id);
  return client == clients_.end() || client->second.is_gone ? nullptr : &client->second;
}

std::vector<ClientId> TcpServer::Clients() const {
  std::vector<ClientId> ids;
  for (const auto& [id, client] : clients_) {
    if (!client.is_gone) ids.push_back(id);
  }
  return ids;
}

size_t TcpServer::num_unsent_bytes() const {
  size_t sum = 0;
  for (const auto& [id, client] : clients_) sum += client.unsent.size();
  return sum;
}

void TcpServer::Serve(int64_t now_us) {
  now_us_ = now_us;
  is_serving_ = true;
  if (!is_accepting_ && now_us_ >= accept_again_us_) SetAccepting(true);
  std::array<epoll_event, kMaxEvents> events;
  for (int round = 0; round < kMaxRounds; ++round) {
    const int num_events =
        epoll_wait(epoll_.get(), events.data(), static_cast<int>(events.size()), 0);
    if (num_events <= 0) break;
    for (size_t i = 0; i < static_cast<size_t>(num_events); ++i) {
      if (events[i].data.u64 == kListener) {
        Accept();
      } else {
        OnEvents(events[i].data.u64, events[i].events);
      }
      Settle();
    }
  }
  CloseTheSilent();
  Settle();
  is_serving_ = false;
}

void TcpServer::SetAccepting(bool accepting) {
  is_accepting_ = accepting;
  accept_again_us_ = now_us_ + kAcceptPause_us;
  Watch(epoll_.get(), EPOLL_CTL_MOD, listener_.get(), kListener, accepting ? uint32_t{EPOLLIN} : 0);
}

void TcpServer::Accept() {
  for (int i = 0; i < kMaxAccepts; ++i) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    const int socket = accept4(listener_.get(), reinterpret_cast<sockaddr*>(&address), &size,
                               SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (socket >= 0) {
      Take(socket, AddressText(address));
      continue;
    }
    if (errno == EAGAIN || errno == EWOULDBLOCK) return;
    ++counts_.failed_accepts;
    if (!IsOutOfDescriptors(errno)) continue;
    // It would be readable all the time, and nothing could be done about it.
    SetAccepting(false);
    return;
  }
}

void TcpServer::Take(int socket, const std::string& address) {
  FileDescriptor owned(socket);
  if (clients_.size() >= static_cast<size_t>(options_.max_connections) && !MakeRoom()) {
    ++counts_.refused;
    if (handlers_.on_refuse) handlers_.on_refuse(address);
    return;
  }
  ++counts_.accepted;
  SetOption(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  KeepAlive(socket);
  const ClientId id = ++last_id_;
  Client client{.socket = std::move(owned)};
  client.received_us = now_us_;
  client.progressed_us = now_us_;
  client.awaited = EPOLLIN;
  Watch(epoll_.get(), EPOLL_CTL_ADD, socket, id, client.awaited);
  clients_.emplace(id, std::move(client));
  if (handlers_.on_connect) handlers_.on_connect(id, address);
}

/// Closes the longest silent client. Returns false where none is silent enough.
bool TcpServer::MakeRoom() {
  if (options_.silence_us <= 0) return false;
  auto longest = clients_.end();
  for (auto entry = clients_.begin(); entry != clients_.end(); ++entry) {
    const Client& client = entry->second;
    if (client.has_sent && now_us_ - client.received_us < options_.silence_us) continue;
    if (longest == clients_.end() || client.received_us < longest->second.received_us) {
      longest = entry;
    }
  }
  if (longest == clients_.end()) return false;
  ++counts_.displaced;
  const ClientId id = longest->first;
  clients_.erase(longest);
  if (handlers_.on_close) handlers_.on_close(id);
  return true;
}

void TcpServer::OnEvents(ClientId id, uint32_t events) {
  Client* client = Find(id);
  if (client == nullptr) return;
  if ((events & EPOLLOUT) != 0) Touch(id);
  if ((events & EPOLLIN) != 0 && (client->awaited & EPOLLIN) != 0) {
    Read(id, client);
  } else if ((events & (EPOLLERR | EPOLLHUP)) != 0) {
    ++counts_.broken;
    client->is_gone = true;
    Touch(id);
  }
}

void TcpServer::Read(ClientId id, Client* client) {
  std::array<char, kChunk_bytes> chunk;
  const ssize_t size = recv(client->socket.get(), chunk.data(), chunk.size(), 0);
  if (size > 0) {
    client->received_us = now_us_;
    client->has_sent = true;
    if (handlers_.on_bytes) {
      handlers_.on_bytes(id, std::string_view(chunk.data(), static_cast<size_t>(size)));
    }
    return;
  }
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (size < 0) {
    ++counts_.broken;
    client->is_gone = true;
  }
  client->is_closing = true;
  Touch(id);
}

void TcpServer::Send(ClientId id, std::string_view bytes) {
  Client* client = Find(id);
  if (client == nullptr) return;
  if (client->unsent.empty()) client->progressed_us = now_us_;
  client->unsent += bytes;
  Touch(id);
  if (client->unsent.size() > options_.max_unsent_bytes) Flush(client);
  if (client->unsent.size() > options_.max_unsent_bytes) {
    ++counts_.stalled;
    client->is_gone = true;
  }
  if (!is_serving_) Settle();
}

void TcpServer::Close(ClientId id) {
  Client* client = Find(id);
  if (client == nullptr) return;
  client->is_closing = true;
  Touch(id);
  if (!is_serving_) Settle();
}

void TcpServer::Flush(Client* client) {
  size_t num_sent = 0;
  while (num_sent < client->unsent.size()) {
    const ssize_t size = send(client->socket.get(), client->unsent.data() + num_sent,
                              client->unsent.size() - num_sent, MSG_NOSIGNAL);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && errno != EAGAIN && errno != EWOULDBLOCK) {
      ++counts_.broken;
      client->is_gone = true;
    }
    if (size <= 0) break;
    num_sent += static_cast<size_t>(size);
  }
  if (num_sent == 0) return;
  client->progressed_us = now_us_;
  client->unsent.erase(0, num_sent);
  if (client->unsent.empty() && client->unsent.capacity() > kKept_bytes) {
    std::string().swap(client->unsent);
  }
}

void TcpServer::Await(ClientId id, Client* client) {
  const bool may_read =
      !client->is_closing && client->unsent.size() <= options_.max_unsent_bytes / 2;
  const uint32_t awaited =
      (may_read ? uint32_t{EPOLLIN} : 0) | (client->unsent.empty() ? 0 : uint32_t{EPOLLOUT});
  if (awaited == client->awaited) return;
  client->awaited = awaited;
  Watch(epoll_.get(), EPOLL_CTL_MOD, client->socket.get(), id, awaited);
}

void TcpServer::CloseTheSilent() {
  for (auto& [id, client] : clients_) {
    const bool is_stalled =
        !client.unsent.empty() && now_us_ - client.progressed_us > options_.stall_timeout_us;
    const bool is_idle =
        options_.idle_timeout_us > 0 && now_us_ - client.received_us > options_.idle_timeout_us;
    if (!is_stalled && !is_idle) continue;
    ++(is_stalled ? counts_.stalled : counts_.idle);
    client.is_gone = true;
    Touch(id);
  }
}

void TcpServer::Touch(ClientId id) {
  if (touched_.empty() || touched_.back() != id) touched_.push_back(id);
}

/// Sends what waits, and forgets clients that have gone.
void TcpServer::Settle() {
  const bool was_serving = std::exchange(is_serving_, true);
  while (!touched_.empty()) {  // on_close may touch others.
    const ClientId id = touched_.back();
    touched_.pop_back();
    const auto entry = clients_.find(id);
    if (entry == clients_.end()) continue;
    Client* client = &entry->second;
    if (!client->is_gone) Flush(client);
    if (client->is_closing && client->unsent.empty()) client->is_gone = true;
    if (!client->is_gone) {
      Await(id, client);
      continue;
    }
    clients_.erase(entry);
    if (handlers_.on_close) handlers_.on_close(id);
  }
  is_serving_ = was_serving;
}

}  // namespace shoal
