#include "lib/run/launch/host_agent.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <signal.h>
#include <sys/epoll.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>

#include "lib/base/time/time_units.h"
#include "lib/bus/bus/multicast_fault.h"
#include "lib/run/command_line/build_facts.h"
#include "lib/run/launch/launch_signals.h"
#include "lib/run/run/run_app.h"
#include "lib/run/run/run_registry.h"

namespace shoal {

namespace {

constexpr int64_t kAgentPoll_us = 50'000;
constexpr int64_t kAgentAlive_us = 150'000;
/// A computer that is not home of the mission and has sent nothing for longer is forgotten.
constexpr int64_t kPeerSilence_us = 10 * kSecond_us;
/// The agent itself stood still; no silence counts.
constexpr int64_t kAgentPause_us = 500'000;
constexpr size_t kMaxNamedKeys = 100;
/// Of one connection: lines about what it sends.
constexpr int64_t kMaxNamed = 20;
/// Of one connection: `shoal doctor --host` sends 32 MiB.
constexpr size_t kMaxPongs_bytes = size_t{64} << 20;

/// Raises the soft limit of open files: connections that have proved no key yet count too. The
/// processes of missions inherit it, as from a shell after `ulimit -n`.
void RaiseFileLimit() {
  constexpr rlim_t kMostFiles = 65'536;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= kMostFiles) return;
  limit.rlim_cur = std::min(limit.rlim_max, kMostFiles);
  setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace

int RunHostAgent(const HostAgentOptions& options) {
  const auto fail = [](const std::string& why) {
    fmt::print(stderr, "shoal host: {}\n", why);
    return static_cast<int>(kExitEnvironment);
  };
  if (const std::string fault = MulticastFault(); !fault.empty()) return fail(fault);
  const int signal_fd = BlockSignals();
  HostAgent agent(options);
  if (const std::string why = agent.Open(); !why.empty()) return fail(why);
  const int code = agent.Run(signal_fd);
  close(signal_fd);
  return code;
}

HostAgent::HostAgent(const HostAgentOptions& options) : options_(options) {}

std::string HostAgent::Open() {
  const Result<HostKey> key = ReadHostKey(HostKeyPath(options_.key_file));
  if (!key.ok()) return key.error();
  std::set<std::string> allowed;
  for (const std::string& each : options_.allow) {
    const Result<std::string> public_key = FindPublicKey(each, "");
    if (!public_key.ok()) return "--allow: " + public_key.error();
    allowed.insert(*public_key);
  }
  // Before the door opens: connections take descriptors.
  RaiseFileLimit();
  const Result<int> port_base = ClaimPorts(
      options_.port_base, PortPlan::NumPorts(Layout::kCommunities, PortPlan::kMaxCommunities));
  if (!port_base.ok()) return port_base.error();
  port_base_ = *port_base;
  if (const auto opened = door_.Open(options_.listen, *key, allowed); !opened.ok()) {
    return opened.error();
  }
  terminal_.Show(
      fmt::format("shoal host listens at {}; its public key: {}; {} computers may run "
                  "missions{}",
                  options_.listen, key->public_key, allowed.size(),
                  options_.allow_programs ? ", programs of these too" : ""));
  return {};
}

int HostAgent::Run(int signal_fd) {
  const FileDescriptor poll(epoll_create1(EPOLL_CLOEXEC));
  for (const int descriptor : {signal_fd, door_.fd()}) {
    epoll_event event{.events = EPOLLIN, .data = {.fd = descriptor}};
    epoll_ctl(poll.get(), EPOLL_CTL_ADD, descriptor, &event);
  }
  last_time_us_ = MonotonicMicroseconds();
  while (true) {
    const int64_t now = MonotonicMicroseconds();
    if (has_news_) ReadSignals(signal_fd);
    if (session_ != nullptr) session_->OnTime(now);
    ReadDoor(now);
    CheckHome(now);
    ReadDoor(now);
    CheckSession();
    if (session_ == nullptr && (is_stopping_ || (options_.once && num_missions_ > 0))) break;
    if (session_ == nullptr) {
      pollfd waited{.fd = poll.get(), .events = POLLIN, .revents = 0};
      const int wait_ms = has_news_ ? 0 : static_cast<int>(kAgentPoll_us / 1000);
      has_news_ = ::poll(&waited, 1, wait_ms) > 0 || has_news_;
    } else {
      // With news left over by the last turn, only a look at what else there is.
      const int64_t wait = has_news_ ? 0 : session_->NextDeadline() - MonotonicMicroseconds();
      const bool is_readable =
          session_->Poll(std::clamp<int64_t>(wait, 0, kAgentPoll_us), poll.get());
      has_news_ = has_news_ || is_readable;  // It has sent.
    }
  }
  return was_lost_ && options_.once ? static_cast<int>(kExitEnvironment) : kExitOk;
}

void HostAgent::ReadSignals(int signal_fd) {
  signalfd_siginfo info{};
  while (read(signal_fd, &info, sizeof info) == sizeof info) {
    if (info.ssi_signo != SIGCHLD) {
      is_stopping_ = true;
    } else if (session_ != nullptr) {
      session_->OnExits(MonotonicMicroseconds());
    }
  }
}

void HostAgent::ReadDoor(int64_t wall_us) {
  LinkTurn turn(MonotonicMicroseconds());
  while (has_news_ && !turn.IsOver(MonotonicMicroseconds())) {
    has_news_ = false;
    const std::optional<HostDoor::Arrival> arrival = door_.Receive();
    if (!arrival) continue;
    has_news_ = true;
    turn.Count(arrival->bytes.size());
    Peer& peer = peers_[arrival->peer];
    peer.key = arrival->key;
    peer.heard_us = wall_us;
    const Result<LinkMessage> message = peer.intake.Take(arrival->bytes);
    if (message.ok()) {
      OnMessage(arrival->peer, *message, wall_us);
      continue;
    }
    if (peer.num_refused++ == 0) {
      terminal_.Warn(fmt::format("{} sent {}; refused", peer.key, message.error()));
    }
    if (peer.intake.has_gap() && arrival->peer == home_)
      LoseHome("sent " + message.error(), wall_us);
  }
  for (const std::string& key : door_.TakeRefusedKeys()) {
    if (refused_keys_.size() >= kMaxNamedKeys || !refused_keys_.insert(key).second) continue;
    terminal_.Warn(fmt::format(
        "refused: a computer with the public key {}; --allow '{}' would let it in", key, key));
  }
  NameUnproved();
  ForgetPeers(wall_us);
}

/// Names connections that ended without a key: the first, and then each time that their number has
/// doubled.
void HostAgent::NameUnproved() {
  const int64_t count = door_.NumUnproved();
  if (count < std::max<int64_t>(1, 2 * num_unproved_named_)) return;
  num_unproved_named_ = count;
  terminal_.Warn(
      fmt::format("refused: {} connections so far that proved no key within 3 s, as those of "
                  "port scanners and of other programs; `ss -tn` shows where they come from",
                  count));
}

void HostAgent::ForgetPeers(int64_t wall_us) {
  std::erase_if(peers_, [&](const auto& item) {
    const bool is_over = item.first != home_ && wall_us - item.second.heard_us > kPeerSilence_us;
    if (is_over) door_.Forget(item.first);
    return is_over;
  });
}

void HostAgent::Send(const std::string& peer_id, const LinkMessage& message) {
  Peer& peer = peers_[peer_id];
  peer.sent_us = MonotonicMicroseconds();
  const Bytes bytes = EncodeLinkMessage(message, peer.next_sequence);
  // A page that no link takes: home shows none, and the mission goes on.
  if (message.kind == LinkKind::kAside && bytes.size() > LimitsOf(message.kind).bytes) return;
  if (door_.Send(peer_id, bytes)) ++peer.next_sequence;
  has_news_ = true;  // Sending may have taken a notice of arrival off the descriptor.
}

void HostAgent::Refuse(const std::string& peer_id, int64_t mission_id, const std::string& why) {
  WarnOf(peer_id, "refused a mission: " + why);
  Send(peer_id, RefusalOf(mission_id, why));
}

void HostAgent::WarnOf(const std::string& peer_id, const std::string& text) {
  if (const int64_t number = ++peers_[peer_id].num_named; number < kMaxNamed) {
    terminal_.Warn(text);
  } else if (number == kMaxNamed) {
    terminal_.Warn(text + "; more of this connection is not shown");
  }
}

void HostAgent::OnMessage(const std::string& peer_id, const LinkMessage& message, int64_t wall_us) {
  if (message.kind == LinkKind::kOffer) return OnOffer(peer_id, message, wall_us);
  if (message.kind == LinkKind::kPing) {
    size_t& pong_bytes = peers_[peer_id].pong_bytes;
    for (const LinkPart& part : message.parts) pong_bytes += part.data.size();
    if (pong_bytes > kMaxPongs_bytes) return;
    LinkMessage pong{.kind = LinkKind::kPong, .parts = message.parts};
    pong.AddText("utc_us", std::to_string(UnixMicroseconds()));
    return Send(peer_id, pong);
  }
  if (session_ == nullptr || peer_id != home_) return;
  const std::string wrong = session_->OnMessage(message, wall_us);
  if (!wrong.empty()) WarnOf(peer_id, fmt::format("home sent {}; refused", wrong));
}

void HostAgent::OnOffer(const std::string& peer_id, const LinkMessage& message, int64_t wall_us) {
  if (session_ != nullptr) {
    // Home that has lost this host and found it again: what runs here is of no more use to it.
    if (message.mission_id == session_->mission_id() && peers_[peer_id].key == peers_[home_].key) {
      LoseHome("has connected again", wall_us);
    }
    return Refuse(peer_id, message.mission_id,
                  fmt::format("it runs another mission now, {}: wait until that has ended",
                              session_->mission().name));
  }
  // First of all: an offer of another version may have another form.
  const BuildFacts homes = BuildOf(message);
  if (const std::string why = WhyNotTogether(OwnBuild(), homes); !why.empty()) {
    return Refuse(peer_id, message.mission_id, why);
  }
  Result<HostOffer> offer = OfferOf(message);
  if (!offer.ok()) return Refuse(peer_id, message.mission_id, offer.error());
  was_lost_ = false;
  home_ = peer_id;
  peers_[home_].intake.set_mission_id(message.mission_id);
  session_ = std::make_unique<HostSession>(
      std::move(*offer), message.mission_id, [this](const LinkMessage& each) { Send(home_, each); },
      terminal_, port_base_);
  const std::string why = session_->Begin(options_.allow_programs);
  peers_[home_].heard_us = MonotonicMicroseconds();  // Loading took its time.
  last_time_us_ = wall_us;
  if (!why.empty()) {
    Refuse(home_, message.mission_id, why);
    session_.reset();
    home_.clear();
    return;
  }
  Send(home_, {.kind = LinkKind::kAccept, .mission_id = message.mission_id});
  terminal_.Show(fmt::format("{} as {}, seed {}: {}", session_->mission().name,
                             session_->offer().host, session_->mission().seed,
                             fmt::join(session_->offer().participants, ", ")));
}

/// Ends the mission, and lets home know why, where it is there.
void HostAgent::LoseHome(const std::string& how, int64_t wall_us) {
  if (session_ == nullptr || was_lost_) return;
  was_lost_ = true;
  terminal_.Warn(fmt::format("LOST: home {}; {} ends here", how, session_->mission().name));
  Send(home_, RefusalOf(session_->mission_id(), "home " + how));
  session_->End(wall_us);
}

/// Ends the mission where home is silent, shows signs of life where it is not.
void HostAgent::CheckHome(int64_t wall_us) {
  const bool stood_still = wall_us - last_time_us_ > kAgentPause_us;
  last_time_us_ = wall_us;
  if (session_ == nullptr) return;
  Peer& home = peers_[home_];
  if (stood_still) home.heard_us = wall_us;
  if (is_stopping_) session_->End(wall_us);
  const auto timeout_us = static_cast<int64_t>(session_->offer().timeout_s * 1e6);
  if (wall_us - home.heard_us > timeout_us && !was_lost_) {
    LoseHome(fmt::format("gave no sign of life for {} s", session_->offer().timeout_s), wall_us);
  }
  if (door_.IsStuck(home_)) LoseHome("takes nothing any more", wall_us);
  if (wall_us - home.sent_us > kAgentAlive_us) {
    Send(home_, {.kind = LinkKind::kAlive, .mission_id = session_->mission_id()});
  }
}

void HostAgent::CheckSession() {
  if (session_ == nullptr || !session_->over()) return;
  terminal_.Show(
      fmt::format("{} has ended after step {}", session_->mission().name, session_->step()));
  session_.reset();
  home_.clear();
  ++num_missions_;
}

}  // namespace shoal
