#include "lib/run/hosts/curve_link.h"

#include <fmt/format.h>
#include <sys/epoll.h>

#include <array>
#include <atomic>
#include <cstring>
#include <zmq.hpp>

#include "lib/bus/os/file_descriptor.h"
#include "lib/run/hosts/link_message.h"

namespace shoal {

namespace {

/// What is still under way when a socket closes: the last words to a host.
constexpr int kLinger_ms = 500;
constexpr int kReconnect_ms = 200;
/// Four messages; a way of a second would be too slow for any step.
constexpr int kHandshake_ms = 3'000;
/// What ZeroMQ holds of a connection that is read slowly: a link in step has one or two messages
/// under way. Beyond these TCP holds the sender back. Each time that an end has taken half of them,
/// the other side of its pipe wakes up.
constexpr int kWaitingIn = 4;
constexpr int kWaitingOut = 16;
/// Frames of one message that are looked at: of a router's, the peer and the content.
constexpr size_t kMaxFrames = 8;
constexpr char kZapAddress[] = "inproc://zeromq.zap.01";

/// ZeroMQ ends a connection over which more comes at once. What is somewhat larger than a batch may
/// be is left to LinkIntake, which names it.
constexpr int64_t kMaxReceived_bytes = int64_t{kLargestLinkMessage_bytes} + (int64_t{1} << 20);

void SetUp(zmq::socket_t* socket, const HostKey& key) {
  socket->set(zmq::sockopt::linger, kLinger_ms);
  socket->set(zmq::sockopt::sndhwm, kWaitingOut);
  socket->set(zmq::sockopt::rcvhwm, kWaitingIn);
  socket->set(zmq::sockopt::maxmsgsize, kMaxReceived_bytes);
  socket->set(zmq::sockopt::curve_secretkey, key.secret_key);
}

int PollOf(const std::vector<int>& descriptors) {
  const int poll = epoll_create1(EPOLL_CLOEXEC);
  for (const int descriptor : descriptors) {
    epoll_event event{.events = EPOLLIN, .data = {.fd = descriptor}};
    epoll_ctl(poll, EPOLL_CTL_ADD, descriptor, &event);
  }
  return poll;
}

/// Receives the frames of one message, the first few of them; empty where there is none.
std::vector<zmq::message_t> ReceiveFrames(zmq::socket_t* socket) {
  std::vector<zmq::message_t> frames;
  zmq::message_t frame;
  if (!socket->recv(frame, zmq::recv_flags::dontwait)) return frames;
  for (bool more = true; more;) {
    more = frame.more();
    if (frames.size() < kMaxFrames) frames.push_back(std::move(frame));
    frame = zmq::message_t();
    if (more) more = socket->recv(frame, zmq::recv_flags::none).has_value();
  }
  return frames;
}

Bytes BytesOf(const zmq::message_t& frame) {
  const auto* begin = static_cast<const uint8_t*>(frame.data());
  return {begin, begin + frame.size()};
}

std::string EncodeKey(const zmq::message_t& frame) {
  constexpr size_t kRawKeySize = 32;
  std::array<char, 41> text{};
  if (frame.size() != kRawKeySize) return {};
  zmq_z85_encode(text.data(), static_cast<const uint8_t*>(frame.data()), kRawKeySize);
  return text.data();
}

}  // namespace

struct HostDoor::Sockets {
  zmq::context_t context{1};
  zmq::socket_t zap{context, zmq::socket_type::rep};
  zmq::socket_t router{context, zmq::socket_type::router};
  zmq::socket_t events{context, zmq::socket_type::pair};
  FileDescriptor poll;
  int64_t num_unproved = 0;
  std::set<std::string> allowed;
  std::vector<std::string> refused;
  std::map<std::string, LinkOutbox> outboxes;  ///< Of peers for which something waits.

  void AnswerZap();
  LinkOutbox::Sent SendNow(const std::string& peer, std::span<const uint8_t> bytes);
  void SendWaiting();
};

HostDoor::HostDoor() : sockets_(std::make_unique<Sockets>()) {}
HostDoor::~HostDoor() { zmq_socket_monitor(sockets_->router.handle(), nullptr, 0); }

Result<bool> HostDoor::Open(const std::string& address, const HostKey& key,
                            const std::set<std::string>& allowed_keys) {
  sockets_->allowed = allowed_keys;
  try {
    // Before the door opens: without this socket ZeroMQ would let everyone in.
    sockets_->zap.bind(kZapAddress);
    SetUp(&sockets_->router, key);
    sockets_->router.set(zmq::sockopt::curve_server, true);
    sockets_->router.set(zmq::sockopt::zap_domain, "shoal");
    sockets_->router.set(zmq::sockopt::router_mandatory, true);
    sockets_->router.set(zmq::sockopt::handshake_ivl, kHandshake_ms);
    constexpr char kEventsAddress[] = "inproc://door-events";
    constexpr int kEvents =
        ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL | ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL;
    zmq_socket_monitor(sockets_->router.handle(), kEventsAddress, kEvents);
    sockets_->events.connect(kEventsAddress);
    sockets_->router.bind(address);
  } catch (const zmq::error_t& error) {
    return Error{fmt::format(
        "cannot listen at {}: {}. An address has the form tcp://ADDRESS:PORT, with an address of "
        "this computer (`ip address`), 127.0.0.1, or * for all of them",
        address, error.what())};
  }
  sockets_->poll = FileDescriptor(
      PollOf({sockets_->router.get(zmq::sockopt::fd), sockets_->zap.get(zmq::sockopt::fd)}));
  return true;
}

/// RFC 27: version, request id, domain, address, identity, mechanism, then for CURVE the key.
void HostDoor::Sockets::AnswerZap() {
  constexpr size_t kCurveFrames = 7;
  for (auto request = ReceiveFrames(&zap); !request.empty(); request = ReceiveFrames(&zap)) {
    const bool is_curve = request.size() == kCurveFrames && request[5].to_string_view() == "CURVE";
    const std::string key = is_curve ? EncodeKey(request[6]) : std::string();
    const bool is_allowed = !key.empty() && allowed.contains(key);
    if (!is_allowed) refused.push_back(key.empty() ? "no key" : key);
    const std::string id = request.size() > 1 ? request[1].to_string() : std::string();
    const std::array<std::string, 6> answer = {"1.0",
                                               id,
                                               is_allowed ? "200" : "400",
                                               is_allowed ? "OK" : "unknown key",
                                               is_allowed ? key : std::string(),
                                               std::string()};
    for (size_t i = 0; i < answer.size(); ++i) {
      const bool is_last = i + 1 == answer.size();
      zap.send(zmq::buffer(answer[i]), is_last ? zmq::send_flags::none : zmq::send_flags::sndmore);
    }
  }
}

std::optional<HostDoor::Arrival> HostDoor::Receive() {
  constexpr size_t kPeerAndBytes = 2;
  sockets_->AnswerZap();
  sockets_->SendWaiting();
  auto frames = ReceiveFrames(&sockets_->router);
  if (frames.empty()) return std::nullopt;
  Arrival arrival{.peer = frames[0].to_string(), .key = {}, .bytes = {}};
  if (frames.size() < kPeerAndBytes) return arrival;
  // NOLINTNEXTLINE: a property of a zmq::message_t, not gets() of C.
  arrival.key = frames[1].gets("User-Id");
  if (frames.size() == kPeerAndBytes) arrival.bytes = BytesOf(frames[1]);
  return arrival;
}

LinkOutbox::Sent HostDoor::Sockets::SendNow(const std::string& peer,
                                            std::span<const uint8_t> bytes) {
  try {
    const auto flags = zmq::send_flags::sndmore | zmq::send_flags::dontwait;
    if (!router.send(zmq::buffer(peer), flags)) return LinkOutbox::Sent::kLater;
    const auto sent =
        router.send(zmq::buffer(bytes.data(), bytes.size()), zmq::send_flags::dontwait);
    return sent ? LinkOutbox::Sent::kYes : LinkOutbox::Sent::kGone;
  } catch (const zmq::error_t&) {
    return LinkOutbox::Sent::kGone;  // EHOSTUNREACH
  }
}

void HostDoor::Sockets::SendWaiting() {
  for (auto& each_peer : outboxes) {  // clang 14 captures no structured binding.
    const auto& peer = each_peer.first;
    each_peer.second.SendWaiting(
        [&](std::span<const uint8_t> each) { return SendNow(peer, each); });
  }
  std::erase_if(outboxes, [](const auto& item) { return item.second.IsIdle(); });
}

bool HostDoor::Send(const std::string& peer, std::span<const uint8_t> bytes) {
  const auto send_now = [&](std::span<const uint8_t> each) {
    return sockets_->SendNow(peer, each);
  };
  LinkOutbox& outbox = sockets_->outboxes[peer];
  const bool is_sent = outbox.Send(bytes, send_now);
  if (outbox.IsIdle()) sockets_->outboxes.erase(peer);
  return is_sent;
}

bool HostDoor::IsStuck(const std::string& peer) const {
  const auto found = sockets_->outboxes.find(peer);
  return found != sockets_->outboxes.end() && found->second.is_stuck();
}

size_t HostDoor::WaitingBytes(const std::string& peer) const {
  const auto found = sockets_->outboxes.find(peer);
  return found == sockets_->outboxes.end() ? 0 : found->second.waiting_bytes();
}

void HostDoor::Forget(const std::string& peer) { sockets_->outboxes.erase(peer); }

std::vector<std::string> HostDoor::TakeRefusedKeys() {
  return std::exchange(sockets_->refused, {});
}

int64_t HostDoor::NumUnproved() {
  while (!ReceiveFrames(&sockets_->events).empty()) ++sockets_->num_unproved;
  return sockets_->num_unproved;
}

int HostDoor::fd() const { return sockets_->poll.get(); }

struct HomeLink::Sockets {
  /// One thread of ZeroMQ serves all links of the process: it wakes up once for what goes to
  /// several hosts at a time, and closing one link waits for no other.
  static zmq::context_t& Context() {
    static zmq::context_t context{1};
    return context;
  }
  /// Returns an address for the events of one link.
  static std::string NewMonitorAddress() {
    static std::atomic<int> number = 0;
    return fmt::format("inproc://events-{}", ++number);
  }

  zmq::socket_t dealer{Context(), zmq::socket_type::dealer};
  zmq::socket_t events{Context(), zmq::socket_type::pair};
  FileDescriptor poll;
  LinkOutbox outbox;

  LinkOutbox::Sent SendNow(std::span<const uint8_t> bytes);
};

HomeLink::HomeLink(const std::string& address, const std::string& host_public_key,
                   const HostKey& key)
    : sockets_(std::make_unique<Sockets>()) {
  try {
    SetUp(&sockets_->dealer, key);
    sockets_->dealer.set(zmq::sockopt::curve_publickey, key.public_key);
    sockets_->dealer.set(zmq::sockopt::curve_serverkey, host_public_key);
    sockets_->dealer.set(zmq::sockopt::immediate, true);
    sockets_->dealer.set(zmq::sockopt::reconnect_ivl, kReconnect_ms);
    constexpr int kEvents = ZMQ_EVENT_DISCONNECTED | ZMQ_EVENT_HANDSHAKE_SUCCEEDED |
                            ZMQ_EVENT_HANDSHAKE_FAILED_AUTH | ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL |
                            ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL;
    const std::string events = Sockets::NewMonitorAddress();
    zmq_socket_monitor(sockets_->dealer.handle(), events.c_str(), kEvents);
    sockets_->events.connect(events);
    sockets_->dealer.connect(address);
  } catch (const zmq::error_t& error) {
    error_ = fmt::format("{}; an address has the form tcp://ADDRESS:PORT", error.what());
  }
  sockets_->poll = FileDescriptor(
      PollOf({sockets_->dealer.get(zmq::sockopt::fd), sockets_->events.get(zmq::sockopt::fd)}));
}

HomeLink::~HomeLink() { zmq_socket_monitor(sockets_->dealer.handle(), nullptr, 0); }

void HomeLink::ReadEvents() {
  for (auto frames = ReceiveFrames(&sockets_->events); !frames.empty();
       frames = ReceiveFrames(&sockets_->events)) {
    uint16_t event = 0;
    if (frames[0].size() < sizeof event) continue;
    std::memcpy(&event, frames[0].data(), sizeof event);
    if (event == ZMQ_EVENT_HANDSHAKE_SUCCEEDED) {
      state_ = State::kOpen;
    } else if (event == ZMQ_EVENT_HANDSHAKE_FAILED_AUTH) {
      state_ = State::kKeyRefused;
    } else if (state_ == State::kOpen || state_ == State::kLost) {
      state_ = State::kLost;
      sockets_->outbox = LinkOutbox();  // It was for that connection.
    } else if (state_ == State::kConnecting) {
      state_ = State::kHandshakeFailed;
    }
  }
}

std::optional<Bytes> HomeLink::Receive() {
  sockets_->outbox.SendWaiting(
      [this](std::span<const uint8_t> each) { return sockets_->SendNow(each); });
  const auto frames = ReceiveFrames(&sockets_->dealer);
  if (!frames.empty()) return BytesOf(frames[0]);
  ReadEvents();  // After what came before the end.
  return std::nullopt;
}

LinkOutbox::Sent HomeLink::Sockets::SendNow(std::span<const uint8_t> bytes) {
  try {
    const auto sent =
        dealer.send(zmq::buffer(bytes.data(), bytes.size()), zmq::send_flags::dontwait);
    return sent ? LinkOutbox::Sent::kYes : LinkOutbox::Sent::kLater;
  } catch (const zmq::error_t&) {
    return LinkOutbox::Sent::kGone;
  }
}

bool HomeLink::Send(std::span<const uint8_t> bytes) {
  // Before it is open a message has nowhere to go, and the sender tries again.
  if (state_ != State::kOpen) return sockets_->SendNow(bytes) == LinkOutbox::Sent::kYes;
  return sockets_->outbox.Send(
      bytes, [this](std::span<const uint8_t> each) { return sockets_->SendNow(each); });
}

const LinkOutbox& HomeLink::outbox() const { return sockets_->outbox; }

int HomeLink::fd() const { return sockets_->poll.get(); }

}  // namespace shoal
