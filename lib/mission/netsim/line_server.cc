#include "lib/mission/netsim/line_server.h"

#include <utility>

namespace shoal {

Result<std::unique_ptr<LineServer>> LineServer::Listen(const TcpServerOptions& options,
                                                       size_t max_line_bytes, Answerer answerer) {
  std::unique_ptr<LineServer> line_server(new LineServer(max_line_bytes, std::move(answerer)));
  auto server = TcpServer::Listen(options, line_server->Handlers());
  if (!server.ok()) return Error{server.error()};
  line_server->server_ = std::move(*server);
  return line_server;
}

TcpServer::Handlers LineServer::Handlers() {
  return {.on_connect =
              [this](ClientId id, const std::string& address) {
                clients_.emplace(id, Client{address, LineFramer(max_line_bytes_)});
              },
          .on_bytes = [this](ClientId id, std::string_view bytes) { OnBytes(id, bytes); },
          .on_close = [this](ClientId id) { clients_.erase(id); }};
}

void LineServer::OnBytes(ClientId id, std::string_view bytes) {
  Client& client = clients_.at(id);
  const int64_t num_before = client.framer.num_too_long();
  client.framer.Push(bytes, [&](std::string_view line) {
    const std::string answer = answerer_(client.address, line);
    if (!answer.empty()) server_->Send(id, answer);
  });
  num_too_long_ += client.framer.num_too_long() - num_before;
}

size_t LineServer::num_waiting_bytes() const {
  size_t sum = server_->num_unsent_bytes();
  for (const auto& [id, client] : clients_) sum += client.framer.capacity();
  return sum;
}

}  // namespace shoal
