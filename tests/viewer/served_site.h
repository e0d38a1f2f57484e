// A web server with a made-up mission behind it, and clients that send to it byte by byte.
#pragma once

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "apps/viewer/view_site.h"
#include "apps/viewer/web_server.h"
#include "tests/netsim/tcp_client.h"
#include "tests/patience.h"

namespace shoal {

inline constexpr const char* kTestToken = "0123456789abcdef0123456789abcdef";

/// Waits until `holds`, for a time that a busy machine may need. It looks again and again: what is
/// awaited are counters of a server with threads of its own and sockets that were never asked for
/// news, and none of them wakes a waiting test. No test depends on the time between two looks.
inline bool Await(const std::function<bool()>& holds, double patience_s = 30 * kPatienceFactor) {
  const auto deadline =
      std::chrono::steady_clock::now() + std::chrono::duration<double>(patience_s);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

inline double SecondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Descriptors that this process has open.
inline size_t NumDescriptors() {
  size_t number = 0;
  for ([[maybe_unused]] const auto& each : std::filesystem::directory_iterator("/proc/self/fd")) {
    ++number;
  }
  return number;
}

class MadeUpSource : public ViewSource {
 public:
  std::string SetupJson(bool commands) override {
    return commands ? R"({"commands":true})" : R"({"commands":false})";
  }
  std::string FrameJson(double) override { return R"({"t":1})"; }
  std::string TrailsJson() override { return std::string(3'000'000, 'x'); }
  std::string LinksJson(double) override { return "{}"; }
  Result<std::string> MediumLinksJson(std::string_view, double) override {
    return std::string("{}");
  }
  std::string FatesJson(const FateQuery&, double) override { return "{}"; }
  std::string EventsJson() override { return "{}"; }
  std::string VerdictJson() override { return R"({"verdict":null})"; }
  Result<std::string> LinkJson(std::string_view, std::string_view, double) override {
    return std::string("{}");
  }
  Result<std::string> VehicleJson(std::string_view name, double, double) override {
    return Error{"no vehicle " + std::string(name)};
  }
};

/// The server runs from construction to destruction.
class ServedSite {
 public:
  explicit ServedSite(AccessRules access = {}, WebServerOptions options = Hasty())
      : site_(PartsOf(std::move(access))),
        server_(std::move(*ListenOn({.port = 0, .last_port = 0})), options, hub_, site_),
        thread_([this] { server_.Run(); }) {}
  ~ServedSite() {
    server_.Stop();
    thread_.join();
  }

  /// Patience that a test can await, and long enough for a busy machine's own clients.
  static WebServerOptions Hasty() {
    using std::chrono::milliseconds;
    return {.patience = {.head = milliseconds(3'000),
                         .body = milliseconds(3'000),
                         .idle = milliseconds(6'000),
                         .write = milliseconds(2'000),
                         .linger = milliseconds(100)},
            .heartbeat = milliseconds(300)};
  }

  int port() const { return server_.port(); }
  EventHub& hub() { return hub_; }
  WebServer& server() { return server_; }
  /// Commands that reached the desk.
  int num_commands() const { return num_commands_; }

 private:
  ViewSiteParts PartsOf(AccessRules access) {
    ViewSiteParts parts = {.files = {{"/", {"text/html; charset=utf-8", "<html>page</html>"}},
                                     {"/app.js", {"text/javascript; charset=utf-8", "run()"}}},
                           .access = std::move(access),
                           .is_live = true};
    parts.source = [source = std::make_shared<MadeUpSource>()] { return source; };
    parts.status = [] { return R"({"pages":[]})"; };
    parts.command = [this](const CommandWords&) {
      ++num_commands_;
      return WebAnswer{.body = R"({"id":1})"};
    };
    return parts;
  }

  std::atomic<int> num_commands_ = 0;
  EventHub hub_;
  ViewSite site_;
  WebServer server_;
  std::thread thread_;
};

/// A GET of `path` with what else the head holds ("Name: value\r\n" each).
inline std::string GetText(const std::string& path, const std::string& headers = "") {
  return "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n" + headers + "\r\n";
}

inline std::string PostText(const std::string& body, const std::string& headers) {
  return "POST /api/command HTTP/1.1\r\nHost: localhost\r\nContent-Length: " +
         std::to_string(body.size()) + "\r\n" + headers + "\r\n" + body;
}

/// The status of the first answer among `received`, or 0.
inline int StatusOf(const std::string& received) {
  constexpr std::string_view kBegin = "HTTP/1.1 ";
  return received.starts_with(kBegin) ? std::atoi(received.c_str() + kBegin.size()) : 0;
}

/// Sends all of `text` as the server takes it, and returns what has come when the server closes the
/// connection (or after `patience_s`).
inline std::string Exchange(int port, const std::string& text,
                            double patience_s = 30 * kPatienceFactor) {
  TcpClient client(port);
  size_t sent = 0;
  Await(
      [&] {
        if (sent < text.size()) sent += client.Send(std::string_view(text).substr(sent));
        client.Receive();
        return client.has_ended();
      },
      patience_s);
  return client.received();
}

/// The answer to one request, the connection closed after it.
inline std::string Ask(int port, const std::string& path, const std::string& headers = "") {
  return Exchange(port, GetText(path, headers + "Connection: close\r\n"));
}

}  // namespace shoal
