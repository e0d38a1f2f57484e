#include "tests/netsim/tcp_client.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>

namespace shoal {

namespace {

sockaddr_in AddressOf(const std::string& address, int port) {
  sockaddr_in result{};
  result.sin_family = AF_INET;
  result.sin_port = htons(static_cast<uint16_t>(port));
  inet_pton(AF_INET, address.c_str(), &result.sin_addr);
  return result;
}

void SetOn(int socket, int level, int option) {
  const int on = 1;
  setsockopt(socket, level, option, &on, sizeof on);
}

}  // namespace

TcpClient::TcpClient(int port, const std::string& source_address, int source_port)
    : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  SetOn(socket_.get(), SOL_SOCKET, SO_REUSEADDR);
  SetOn(socket_.get(), IPPROTO_TCP, TCP_NODELAY);
  const sockaddr_in own = AddressOf(source_address, source_port);
  const sockaddr_in server = AddressOf("127.0.0.1", port);
  if (bind(socket_.get(), reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0 ||
      connect(socket_.get(), reinterpret_cast<const sockaddr*>(&server), sizeof server) != 0) {
    Close();
    return;
  }
  fcntl(socket_.get(), F_SETFL, O_NONBLOCK);
}

int TcpClient::source_port() const {
  sockaddr_in own{};
  socklen_t size = sizeof own;
  getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&own), &size);
  return ntohs(own.sin_port);
}

size_t TcpClient::Send(std::string_view bytes) {
  const ssize_t size = send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  return size < 0 ? 0 : static_cast<size_t>(size);
}

void TcpClient::Receive() {
  std::array<char, 65536> chunk;
  for (;;) {
    const ssize_t size = recv(socket_.get(), chunk.data(), chunk.size(), 0);
    if (size > 0) {
      received_.append(chunk.data(), static_cast<size_t>(size));
      continue;
    }
    has_ended_ = has_ended_ || size == 0 || (errno != EAGAIN && errno != EINTR);
    return;
  }
}

void TcpClient::CloseOwnSide() { shutdown(socket_.get(), SHUT_WR); }

void TcpClient::Reset() {
  const linger at_once{.l_onoff = 1, .l_linger = 0};
  setsockopt(socket_.get(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  Close();
}

}  // namespace shoal
