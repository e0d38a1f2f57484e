#include "lib/mission/netsim/gps_output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <termios.h>

#include <cerrno>
#include <utility>

namespace shoal {

namespace {

/// For reading too, so that a pipe without a reader causes no SIGPIPE.
FileDescriptor OpenForLines(const std::string& path) {
  FileDescriptor file(
      open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0644));
  termios terminal{};
  if (file.is_open() && tcgetattr(file.get(), &terminal) == 0) {
    cfmakeraw(&terminal);
    tcsetattr(file.get(), TCSANOW, &terminal);
  }
  return file;
}

}  // namespace

Result<std::unique_ptr<GpsOutput>> GpsOutput::Open(
    const NetsimGps& gps, const std::string& address,
    std::function<void(const std::string& address)> on_refuse) {
  std::unique_ptr<GpsOutput> output(new GpsOutput());
  if (gps.tcp_port != 0) {
    auto server = TcpServer::Listen(
        {.address = address, .port = gps.tcp_port, .max_connections = kMaxClients},
        {.on_refuse = std::move(on_refuse)});
    if (!server.ok()) return Error{server.error()};
    output->server_ = std::move(*server);
  }
  if (!gps.path.empty()) {
    output->file_ = OpenForLines(gps.path);
    if (!output->file_.is_open()) {
      return Error{
          fmt::format("{}: cannot be written: {}; a folder that is missing is not made, "
                      "and serial lines belong to the group dialout",
                      gps.path, ErrnoText(errno))};
    }
  }
  return output;
}

void GpsOutput::Write(std::string_view sentence) {
  if (server_ != nullptr) {
    for (const ClientId client : server_->Clients()) server_->Send(client, sentence);
  }
  if (!file_.is_open()) return;
  const ssize_t size = write(file_.get(), sentence.data(), sentence.size());
  if (size != static_cast<ssize_t>(sentence.size())) ++num_lost_;
}

void GpsOutput::Serve(int64_t now_us) {
  if (server_ != nullptr) server_->Serve(now_us);
}

}  // namespace shoal
