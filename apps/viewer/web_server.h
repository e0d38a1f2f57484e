// Serves requests over HTTP, for as many clients as come, with cpp-httplib.
//
//   EventHub hub;
//   WebServer server(std::move(*listening), {}, hub, site);
//   std::thread thread([&] { server.Run(); });
//   ...
//   server.Stop(), thread.join();
//
// A client that is slow, silent or sends too much is cut after a while (Patience) and never delays
// the answers of others; nothing that it sends ends the server.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "apps/viewer/client_threads.h"
#include "apps/viewer/event_hub.h"
#include "apps/viewer/listening_socket.h"
#include "apps/viewer/web_request.h"

namespace shoal {

/// Answers requests. Called from any thread.
class WebSite {
 public:
  virtual ~WebSite() = default;
  /// Returns why the request is refused, before its body is read; nothing: Reply is asked.
  virtual std::optional<WebAnswer> Deny(const WebRequest& request) = 0;
  virtual WebAnswer Reply(const WebRequest& request) = 0;
};

struct WebServerOptions {
  size_t most_connections = 300;
  int most_streams = 200;  ///< So that room is left for requests.
  Patience patience;
  std::chrono::milliseconds heartbeat{1'000};  ///< Of streams without news.
  std::string outside_origin = {};  ///< Another server that pages may ask: "https://HOST".
};

class WebServer {
 public:
  /// `hub` and `site` must outlive this.
  WebServer(ListeningSocket socket, const WebServerOptions& options, EventHub& hub, WebSite& site);
  ~WebServer();

  /// Serves until Stop().
  void Run();
  /// Ends streams and connections at once. From any thread.
  void Stop();

  int port() const { return socket_.port; }
  size_t num_connections() const { return clients_->num_connections(); }

 private:
  class Http;

  ListeningSocket socket_;
  EventHub& hub_;
  std::unique_ptr<Http> http_;
  std::unique_ptr<ClientThreads> clients_;
};

}  // namespace shoal
