#include "apps/viewer/web_server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <string>

#include "apps/viewer/access.h"
#include "apps/viewer/http_head.h"

namespace shoal {

namespace {

constexpr size_t kMaxRequestsPerConnection = 1'000;

/// `outside_origin`: WebServerOptions has the meaning.
httplib::Headers SafetyHeaders(const std::string& outside_origin) {
  // The page has everything it needs from this server; scripts of other sources do not
  // run, and no other site can frame it.
  std::string policy =
      "default-src 'self'; img-src 'self' blob: data:; style-src 'self'; "
      "object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
  if (!outside_origin.empty()) policy += "; connect-src 'self' " + outside_origin;
  return {
      {"Content-Security-Policy", std::move(policy)},
      {"X-Content-Type-Options", "nosniff"},
      {"X-Frame-Options", "DENY"},
      {"Referrer-Policy", "no-referrer"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
  };
}

/// The whole answer to bytes that are not a request.
std::string RefusalText(int status, const std::string& message) {
  const std::string body = ErrorAnswer(status, message).body;
  std::string text =
      fmt::format("HTTP/1.1 {} Refused\r\nContent-Type: application/json\r\nContent-Length: {}\r\n",
                  status, body.size());
  if (status == 405) text += "Allow: GET, HEAD, POST\r\n";
  if (status == 503) text += "Retry-After: 2\r\n";
  text += "Cache-Control: no-store\r\nConnection: close\r\n";
  for (const auto& [name, value] : SafetyHeaders(""))
    text += fmt::format("{}: {}\r\n", name, value);
  return text + "\r\n" + body;
}

WebRequest RequestOf(const httplib::Request& request) {
  return {.method = request.method,
          .path = request.path,
          .query = request.params,
          .host = request.get_header_value("Host"),
          .origin = request.get_header_value("Origin"),
          .sec_fetch_site = request.get_header_value("Sec-Fetch-Site"),
          .token = request.get_header_value("X-Shoal-Token"),
          .content_type = request.get_header_value("Content-Type"),
          .body = request.body};
}

/// A connection with the interface that cpp-httplib needs.
class ConnectionStream : public httplib::Stream {
 public:
  explicit ConnectionStream(Connection& connection) : connection_(connection) {}

  bool is_readable() const override { return true; }  // Read() waits no longer than it should.
  bool is_writable() const override { return !connection_.HasGone(); }
  ssize_t read(char* bytes, size_t size) override { return connection_.Read(bytes, size); }
  ssize_t write(const char* bytes, size_t size) override {
    return connection_.Write({bytes, size}) ? static_cast<ssize_t>(size) : -1;
  }
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return 0; }  // It is not to be used.

 private:
  Connection& connection_;
};

}  // namespace

class WebServer::Http : public httplib::Server {
 public:
  Http(int listening_fd, const WebServerOptions& options, EventHub& hub, WebSite& site)
      : options_(options), hub_(hub), site_(site) {
    svr_sock_ = listening_fd;  // Else cpp-httplib ends streams.
    set_default_headers(SafetyHeaders(options.outside_origin));
    set_payload_max_length(kMaxBodyBytes);
    set_keep_alive_max_count(kMaxRequestsPerConnection);
    set_keep_alive_timeout(
        std::chrono::duration_cast<std::chrono::seconds>(options.patience.idle).count());
    // One function answers all: cpp-httplib would match the path against regular expressions, whose
    // recursion goes as deep as the path is long.
    set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      const WebRequest asked = RequestOf(request);
      if (auto denial = site_.Deny(asked)) {
        Fill(std::move(*denial), response);
        return HandlerResponse::Handled;
      }
      if (request.method == "POST") return HandlerResponse::Unhandled;  // Its body comes first.
      Fill(site_.Reply(asked), response);
      return HandlerResponse::Handled;
    });
    for (const std::string_view path : {kCommandPath, kPlanPath, kPlanWritePath, kPlanRunPath}) {
      Post(std::string(path), [this](const httplib::Request& request, httplib::Response& response) {
        Fill(site_.Reply(RequestOf(request)), response);
      });
    }
    set_error_handler([](const httplib::Request&, httplib::Response& response) {
      if (!response.body.empty()) return;
      const WebAnswer answer = ErrorAnswer(response.status, "this request cannot be understood");
      response.set_content(answer.body, answer.content_type);
    });
    set_exception_handler(
        [](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
          response.status = 503;
          const WebAnswer answer = ErrorAnswer(503, "no memory left for this answer");
          response.set_content(answer.body, answer.content_type);
        });
  }

  /// Answers the requests of one client until the connection ends.
  void Converse(Connection& connection) {
    ConnectionStream stream(connection);
    for (size_t i = 0; i < kMaxRequestsPerConnection; ++i) {
      const CheckedHead head = connection.AwaitHead();
      if (head.status == 0) return;
      if (head.status != 200) {
        if (!connection.Write(RefusalText(head.status, head.message))) return;
        break;
      }
      const bool is_last = !head.keeps_alive || i + 1 == kMaxRequestsPerConnection;
      bool is_closed = false;
      if (!process_request(stream, is_last, is_closed, nullptr)) return;
      if (is_last || is_closed) break;
    }
    connection.Linger();
  }

 private:
  void Fill(WebAnswer answer, httplib::Response& response) {
    if (answer.is_stream && hub_.num_readers() >= options_.most_streams) {
      answer = ErrorAnswer(503, "too many streams; close some pages");
    }
    response.status = answer.status;
    response.set_header("Cache-Control", answer.cache_control);
    if (!answer.allow.empty()) response.set_header("Allow", answer.allow);
    if (!answer.is_stream) {
      response.set_content(answer.body, answer.content_type);
      return;
    }
    response.set_content_provider(
        "text/event-stream", [this, reader = std::make_shared<EventHub::Reader>(hub_)](
                                 size_t offset, httplib::DataSink& sink) {
          if (offset == 0) return Send("retry: 1000\n\n", sink);
          const auto event = reader->Next(options_.heartbeat);
          if (!event || !sink.is_writable()) {
            sink.done();
            return true;
          }
          return Send(*event != nullptr ? std::string_view(**event) : ":\n\n", sink);
        });
  }

  static bool Send(std::string_view text, httplib::DataSink& sink) {
    return sink.write(text.data(), text.size());
  }

  const WebServerOptions options_;
  EventHub& hub_;
  WebSite& site_;
};

WebServer::WebServer(ListeningSocket socket, const WebServerOptions& options, EventHub& hub,
                     WebSite& site)
    : socket_(std::move(socket)),
      hub_(hub),
      http_(std::make_unique<Http>(socket_.fd.get(), options, hub, site)),
      clients_(std::make_unique<ClientThreads>(
          socket_.fd.get(),
          CrowdLimits{.most_connections = options.most_connections,
                      .patience = options.patience,
                      .busy_answer = RefusalText(503, "too many connections; try again")},
          [this](Connection& connection) { http_->Converse(connection); })) {}

WebServer::~WebServer() { Stop(); }

void WebServer::Run() { clients_->Run(); }

void WebServer::Stop() {
  hub_.Stop();
  clients_->Stop();
}

}  // namespace shoal
