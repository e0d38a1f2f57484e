#include "apps/viewer/connection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>

namespace shoal {

namespace {

/// The size of the socket's send buffer: it holds only a few frames, so that a slow client gets
/// recent ones.
constexpr int kSendBuffer = 256 * 1024;
constexpr size_t kReadAtOnce = 4096;

}  // namespace

Connection::Connection(FileDescriptor socket, const Patience& patience)
    : socket_(std::move(socket)), patience_(patience), since_(Clock::now()) {
  const int on = 1;
  setsockopt(socket_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  setsockopt(socket_.get(), SOL_SOCKET, SO_SNDBUF, &kSendBuffer, sizeof kSendBuffer);
}

bool Connection::Await(short events, Clock::time_point deadline) const {
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    pollfd descriptor = {.fd = socket_.get(), .events = events, .revents = 0};
    const int ready = poll(&descriptor, 1, static_cast<int>(std::max<int64_t>(left.count(), 0)));
    if (ready > 0) return true;
    if (ready == 0 || errno != EINTR) return false;
  }
}

bool Connection::Receive(Clock::time_point deadline) {
  while (true) {
    std::array<char, kReadAtOnce> bytes{};
    const ssize_t size = recv(socket_.get(), bytes.data(), bytes.size(), 0);
    if (size > 0) {
      received_.append(bytes.data(), static_cast<size_t>(size));
      return true;
    }
    const bool is_later = size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    if (!is_later || !Await(POLLIN, deadline)) return false;
  }
}

CheckedHead Connection::AwaitHead() {
  is_waiting_ = true;
  since_ = Clock::now();
  const bool was_first = std::exchange(is_first_, false);
  // An idle client that has begun to send has as long as a new one.
  auto deadline = Clock::now() + (was_first ? patience_.head : patience_.idle);
  bool has_begun = was_first || !received_.empty();
  CheckedHead checked = CheckHead(received_);
  while (checked.status == 0) {
    if (!Receive(deadline)) {
      if (Clock::now() < deadline || received_.empty()) return {};
      return {.status = 408, .message = "the request came too slowly"};
    }
    if (!has_begun) deadline = Clock::now() + patience_.head;
    has_begun = true;
    checked = CheckHead(received_);
  }
  is_waiting_ = false;
  since_ = Clock::now();
  if (checked.status == 200) {
    received_.erase(0, checked.size);
    head_ = checked.head;
    read_deadline_ = Clock::now() + patience_.body;
  }
  return checked;
}

ssize_t Connection::Read(char* bytes, size_t size) {
  std::string& source = head_.empty() ? received_ : head_;
  if (source.empty() && !Receive(read_deadline_)) {
    return Clock::now() < read_deadline_ ? 0 : -1;
  }
  const size_t taken = std::min(size, source.size());
  std::copy_n(source.begin(), taken, bytes);
  source.erase(0, taken);
  return static_cast<ssize_t>(taken);
}

bool Connection::Write(std::string_view bytes) {
  constexpr size_t kLeastPerMillisecond = 500;
  const auto deadline = Clock::now() + patience_.write +
                        std::chrono::milliseconds(bytes.size() / kLeastPerMillisecond);
  while (!bytes.empty()) {
    const ssize_t sent = send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent > 0) {
      bytes.remove_prefix(static_cast<size_t>(sent));
      continue;
    }
    const bool is_later = sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    if (!is_later || !Await(POLLOUT, deadline)) return false;
    if (Clock::now() >= deadline) return false;
  }
  return true;
}

bool Connection::HasGone() const {
  char byte = 0;
  const ssize_t size = recv(socket_.get(), &byte, 1, MSG_PEEK);
  return size == 0 || (size < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
}

void Connection::Linger() {
  // A socket that is closed with bytes unread resets the connection, and the client's kernel then
  // discards the answer that it has not yet read.
  constexpr size_t kMaxDiscarded = 16'000'000;
  shutdown(socket_.get(), SHUT_WR);
  const auto deadline = Clock::now() + patience_.linger;
  size_t discarded = received_.size();
  received_.clear();
  while (discarded < kMaxDiscarded && Clock::now() < deadline && Receive(deadline)) {
    discarded += received_.size();
    received_.clear();
  }
}

void Connection::Cut() {
  is_waiting_ = false;
  shutdown(socket_.get(), SHUT_RDWR);
}

}  // namespace shoal
