#include "lib/run/launch/mission_hosts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/epoll.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <span>

#include "lib/base/time/seconds.h"
#include "lib/base/time/time_units.h"
#include "lib/run/command_line/build_facts.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

constexpr int64_t kConnectLimit_us = 10 * kSecond_us;
/// A host that checks a mission and starts its processes answers late.
constexpr int64_t kAcceptLimit_us = 30 * kSecond_us;
constexpr int64_t kRetry_us = kSecond_us / 2;
constexpr int64_t kAliveInterval_us = 150'000;
/// OnTime is called every 50 ms at least; a longer pause was the launcher's own.
constexpr int64_t kOwnPause_us = 500'000;

constexpr uint32_t kNoHost = std::numeric_limits<uint32_t>::max();

/// `host`: the number of the host whose link the descriptor is of.
void Watch(int poll, int descriptor, uint32_t host = kNoHost) {
  epoll_event event{.events = EPOLLIN, .data = {.u32 = host}};
  epoll_ctl(poll, EPOLL_CTL_ADD, descriptor, &event);
}

/// False for a program of the user's, in place of one of shoal's or beside them.
bool IsShoalsOwn(const RosterEntry& entry) {
  return !entry.app.empty() && entry.provider == Provider::kShoal;
}

double Milliseconds(int64_t us) { return static_cast<double>(us) / 1e3; }

}  // namespace

std::vector<HostOptions> HostsInUse(const Mission& mission) {
  std::vector<HostOptions> hosts;
  for (const HostOptions& host : mission.hosts) {
    if (!host.vehicles.empty() || !host.participants.empty()) hosts.push_back(host);
  }
  return hosts;
}

Result<HostAccess> PrepareHosts(const Mission& mission, const RunOptions& options,
                                const LaunchedApps& apps) {
  HostAccess access;
  const std::string folder = std::filesystem::path(mission.file).parent_path().string();
  for (const HostOptions& host : HostsInUse(mission)) {
    if (host.address.empty() || host.key.empty()) {
      return Error{fmt::format(
          "{}: [[host]] {} runs vehicles and has no {}: write address = \"tcp://ADDRESS:PORT\" and "
          "key = \"FILE.pub\" (docs/missions/many_machines.md)",
          mission.file, host.name, host.address.empty() ? "address" : "key")};
    }
    const Result<std::string> public_key = FindPublicKey(host.key, folder);
    if (!public_key.ok()) {
      return Error{
          fmt::format("{}: key of [[host]] {}: {}", mission.file, host.name, public_key.error())};
    }
    access.public_keys[host.name] = *public_key;
  }
  Result<HostKey> key = ReadHostKey(HostKeyPath(options.key_file));
  if (!key.ok()) return Error{key.error()};
  access.key = std::move(*key);
  Result<std::vector<OfferedFile>> files = FilesOfMission(options.mission_file, options.overrides);
  if (!files.ok()) return Error{files.error()};
  access.files = std::move(*files);
  for (const RosterEntry& entry : MakeRoster(mission, false)) {
    if (entry.host.empty() || !IsShoalsOwn(entry)) continue;
    access.subscriptions[entry.name] = apps.subscriptions_of(entry, mission);
  }
  return access;
}

MissionHosts::MissionHosts(const LaunchContext& context, const MissionSecret& secret,
                           const std::vector<RosterProcess>& processes, Transport& transport,
                           HostAccess access)
    : context_(context),
      access_(std::move(access)),
      secret_(secret),
      digest_(MissionDigest(context.mission, access_.files)),
      poll_(epoll_create1(EPOLL_CLOEXEC)) {
  std::vector<RelayedHost> relayed;
  for (const HostOptions& options : HostsInUse(context.mission)) {
    Host host{.options = options};
    RelayedHost each;
    std::vector<std::string> subscriptions;
    bool may_read_all = false;
    std::set<std::string, std::less<>> programs;
    for (const RosterProcess& process : processes) {
      if (process.entries.front().host != options.name) continue;
      host.processes.push_back(process.name);
      for (const RosterEntry& entry : process.entries) {
        host.participants.push_back(entry.name);
        each.participants.insert(entry.name);
        // A program of the user's own may subscribe to anything.
        if (!IsShoalsOwn(entry)) {
          may_read_all = true;
          programs.insert(entry.name);
        }
        const auto found = access_.subscriptions.find(entry.name);
        if (found == access_.subscriptions.end()) continue;
        subscriptions.insert(subscriptions.end(), found->second.begin(), found->second.end());
      }
    }
    each.wants = ChannelsOf(VehicleNames(context.mission), options.vehicles, subscriptions);
    if (may_read_all) each.wants = [](std::string_view) { return true; };
    each.may_publish = ChannelsFrom(VehicleNames(context.mission), options.vehicles, programs);
    if (host.participants.empty()) continue;
    relayed.push_back(std::move(each));
    hosts_.push_back(std::move(host));
  }
  relay_ = std::make_unique<HomeRelay>(
      RelayOptions{.name = "hosts",
                   .mission_id = context.mission_id,
                   .secret = secret,
                   .tick_us = context.mission.tick_us},
      context.ports, transport, std::move(relayed),
      [this](size_t number, const LinkMessage& message) { Send(&hosts_[number], message); });
  const int64_t now = MonotonicMicroseconds();
  for (Host& host : hosts_) Connect(&host, now);
}

std::string MissionHosts::Describe(const Host& host) const {
  return fmt::format("host {} ({})", host.options.name, host.options.address);
}

void MissionHosts::Connect(Host* host, int64_t wall_us) {
  host->link = std::make_unique<HomeLink>(host->options.address,
                                          access_.public_keys.at(host->options.name), access_.key);
  host->intake = LinkIntake();
  host->intake.set_mission_id(context_.mission_id);
  host->next_sequence = 0;
  host->state = State::kConnecting;
  host->since_us = wall_us;
  host->has_news = true;
  Watch(poll_.get(), host->link->fd(), static_cast<uint32_t>(host - hosts_.data()));
}

void MissionHosts::WatchToo(int descriptor) { Watch(poll_.get(), descriptor); }

void MissionHosts::Send(Host* host, const LinkMessage& message) {
  host->sent_us = MonotonicMicroseconds();
  const Bytes bytes = EncodeLinkMessage(message, host->next_sequence);
  // A request that no link takes: the host shows no page, and the mission goes on.
  if (message.kind == LinkKind::kAside && bytes.size() > LimitsOf(message.kind).bytes) return;
  if (host->link->Send(bytes)) ++host->next_sequence;
  host->has_news = true;  // Sending may have taken a notice of arrival off the descriptor.
}

void MissionHosts::Offer(Host* host) {
  const HostOffer offer{.build = OwnBuild(),
                        .host = host->options.name,
                        .files = access_.files,
                        .overrides = context_.options.overrides,
                        .digest = digest_,
                        .participants = host->participants,
                        .grouping = context_.options.grouping,
                        .secret = secret_,
                        .layout = context_.ports.layout(),
                        .timeout_s = host->options.timeout_s};
  Send(host, ToLinkMessage(offer, context_.mission_id));
}

void MissionHosts::OnTime(int64_t wall_us) {
  // The launcher itself stood still (Ctrl-Z, a paused machine): no silence counts.
  if (wall_us - last_time_us_ > kOwnPause_us) {
    for (Host& host : hosts_) host.heard_us = wall_us;
  }
  last_time_us_ = wall_us;
  relay_->OnTime(wall_us);
  std::array<epoll_event, 64> events{};
  const int num = epoll_wait(poll_.get(), events.data(), static_cast<int>(events.size()), 0);
  for (const epoll_event& event : std::span(events).first(static_cast<size_t>(std::max(num, 0)))) {
    if (event.data.u32 != kNoHost) hosts_[event.data.u32].has_news = true;
  }
  for (size_t i = 0; i < hosts_.size(); ++i) {
    Host& host = hosts_[i];
    if (host.link == nullptr && host.retry_us > 0 && wall_us >= host.retry_us) {
      host.retry_us = 0;
      Connect(&host, wall_us);
    }
    if (host.link == nullptr) continue;
    ReadLink(i, wall_us);
    CheckTimes(i, wall_us);
    ReadLink(i, wall_us);
  }
}

int64_t MissionHosts::NextDeadline() const {
  const bool has_rest = std::ranges::any_of(
      hosts_, [](const Host& host) { return host.link != nullptr && host.has_news; });
  return has_rest ? 0 : relay_->NextDeadline();
}

void MissionHosts::ReadLink(size_t number, int64_t wall_us) {
  Host& host = hosts_[number];
  LinkTurn turn(MonotonicMicroseconds());
  while (host.link != nullptr && host.has_news && !turn.IsOver(MonotonicMicroseconds())) {
    host.has_news = false;
    const std::optional<Bytes> bytes = host.link->Receive();
    if (!bytes) continue;
    host.has_news = true;
    turn.Count(bytes->size());
    host.heard_us = wall_us;
    const Result<LinkMessage> message = host.intake.Take(*bytes);
    if (message.ok()) {
      OnMessage(number, *message, wall_us);
      continue;
    }
    const std::string how = fmt::format("{} sent {}", Describe(host), message.error());
    Refuse(&host, how);
    if (host.intake.has_gap() && !is_ending_) Lose(number, how, wall_us);
  }
}

/// Counts what a host has sent and must not; the first is shown.
void MissionHosts::Refuse(Host* host, const std::string& what) {
  if (host->num_refused++ == 0) notes_.push_back(what + "; refused");
}

void MissionHosts::OnMessage(size_t number, const LinkMessage& message, int64_t wall_us) {
  Host& host = hosts_[number];
  switch (message.kind) {
    case LinkKind::kAccept:
      if (host.state != State::kOffered) break;
      host.state = State::kRunning;
      host.running = {host.processes.begin(), host.processes.end()};
      relay_->SetConnected(number, true);
      if (host.was_running) {
        notes_.push_back(fmt::format("{} is there again; its participants join", Describe(host)));
      }
      host.was_running = true;
      break;
    case LinkKind::kRefuse:
      if (host.state == State::kRunning) {
        Lose(number, fmt::format("{} ends its part: {}", Describe(host), message.TextOf("why")),
             wall_us);
        break;
      }
      host.link.reset();
      if (host.was_running) {
        host.retry_us = wall_us + kRetry_us;  // It ends what it ran before it was lost.
        break;
      }
      troubles_.push_back(
          {.host = host.options.name,
           .how = fmt::format("{} refuses the mission: {}", Describe(host), message.TextOf("why")),
           .is_fatal = true});
      break;
    case LinkKind::kDone:
    case LinkKind::kAside: {
      const std::string channel = relay_->OnMessage(number, message, wall_us);
      if (channel.empty() || std::exchange(host.has_shown_dropped, true)) break;
      notes_.push_back(
          fmt::format("{} sent a message on {}, where none of its processes publishes; dropped, "
                      "and counted in the summary (docs/inside/security.md)",
                      Describe(host), channel));
      break;
    }
    case LinkKind::kExit: {
      const HostExit exit = ExitOf(message);
      if (std::ranges::find(host.processes, exit.name) == host.processes.end()) {
        Refuse(&host, fmt::format("{} sent the end of {}, which it does not run", Describe(host),
                                  exit.name));
        break;
      }
      // The end of a process that has ended, over and over, would be a line each.
      if (host.running.erase(exit.name) == 0) {
        Refuse(&host, fmt::format("{} sent the end of {} twice", Describe(host), exit.name));
        break;
      }
      exits_.push_back(exit);
      break;
    }
    default:
      break;
  }
}

void MissionHosts::CheckTimes(size_t number, int64_t wall_us) {
  Host& host = hosts_[number];
  if (host.link == nullptr || is_ending_) return;
  const HomeLink::State link = host.link->state();
  const int64_t waited_us = wall_us - host.since_us;
  const auto fail = [&](std::string how) {
    host.link.reset();
    troubles_.push_back({.host = host.options.name, .how = std::move(how), .is_fatal = true});
  };
  if (host.state == State::kConnecting) {
    if (link == HomeLink::State::kOpen) {
      host.state = State::kOffered;
      host.since_us = host.heard_us = wall_us;
      Offer(&host);
    } else if (!host.link->error().empty()) {
      fail(fmt::format("{}: {}", Describe(host), host.link->error()));
    } else if (host.was_running) {
      return;  // It may come back whenever it wants.
    } else if (link == HomeLink::State::kKeyRefused) {
      fail(
          fmt::format("{} does not accept this computer's key: start it with --allow and the "
                      "public key {}",
                      Describe(host), access_.key.public_key));
    } else if (link == HomeLink::State::kHandshakeFailed && waited_us > kSecond_us) {
      fail(
          fmt::format("{} does not prove the key {} that the mission gives for it: is it the "
                      "computer that you mean, and `shoal host` what listens there?",
                      Describe(host), access_.public_keys.at(host.options.name)));
    } else if (waited_us > kConnectLimit_us) {
      fail(
          fmt::format("{} cannot be reached within {} s: is `shoal host` running there, and does "
                      "a firewall let its TCP port in?",
                      Describe(host), kConnectLimit_us / kSecond_us));
    }
    return;
  }
  if (link == HomeLink::State::kLost) {
    Lose(number, fmt::format("{} ended the connection", Describe(host)), wall_us);
    return;
  }
  if (host.link->outbox().is_stuck()) {
    Lose(number,
         fmt::format("{} takes nothing any more: {} MiB wait for it", Describe(host),
                     LinkOutbox::kMaxWaiting_bytes >> 20),
         wall_us);
    return;
  }
  const auto timeout_us = static_cast<int64_t>(host.options.timeout_s * 1e6);
  const int64_t limit_us =
      host.state == State::kOffered ? std::max(kAcceptLimit_us, timeout_us) : timeout_us;
  if (wall_us - host.heard_us > limit_us) {
    Lose(number,
         fmt::format("{} gave no sign of life for {} s (hung, or the network is down)",
                     Describe(host), Seconds(limit_us)),
         wall_us);
    return;
  }
  if (wall_us - host.sent_us > kAliveInterval_us) {
    Send(&host, {.kind = LinkKind::kAlive, .mission_id = context_.mission_id});
  }
  CheckAnswer(number, wall_us);
}

/// Names a host that is there and does not answer for half of its time-out; again where it takes
/// twice as long.
void MissionHosts::CheckAnswer(size_t number, int64_t wall_us) {
  Host& host = hosts_[number];
  const auto patience_us = static_cast<int64_t>(host.options.timeout_s * 1e6 / 2);
  const int64_t waited_us = relay_->WaitedFor(number, wall_us);
  if (waited_us <= std::max(patience_us, 2 * host.slow_us)) return;
  host.slow_us = waited_us;
  notes_.push_back(
      fmt::format("step {}: {} has been slow for {:.2f} s; it gives signs of life, and "
                  "its answer is waited for",
                  relay_->step(), Describe(host), Seconds(waited_us)));
}

void MissionHosts::Lose(size_t number, const std::string& how, int64_t wall_us) {
  Host& host = hosts_[number];
  relay_->SetConnected(number, false);
  host.running.clear();
  host.state = State::kLost;
  host.link.reset();
  if (host.options.on_loss == OnLoss::kRestart) Connect(&host, wall_us);
  troubles_.push_back({.host = host.options.name, .how = how});
}

void MissionHosts::Start(const RosterProcess& process) {
  for (Host& host : hosts_) {
    if (host.options.name != process.entries.front().host || host.state != State::kRunning)
      continue;
    LinkMessage message{.kind = LinkKind::kStart, .mission_id = context_.mission_id};
    message.AddText("name", process.name);
    host.running.insert(process.name);
    Send(&host, message);
  }
}

void MissionHosts::Signal(const RosterProcess& process, int signal) {
  for (Host& host : hosts_) {
    if (host.options.name != process.entries.front().host || host.state != State::kRunning)
      continue;
    LinkMessage message{.kind = LinkKind::kSignal, .mission_id = context_.mission_id};
    message.AddText("name", process.name);
    message.AddText("signal", std::to_string(signal));
    Send(&host, message);
  }
}

bool MissionHosts::IsRunning(const std::string& name) const {
  return std::any_of(hosts_.begin(), hosts_.end(),
                     [&](const Host& host) { return host.running.contains(name); });
}

void MissionHosts::End() {
  is_ending_ = true;
  for (Host& host : hosts_) {
    if (host.link == nullptr) continue;
    Send(&host, {.kind = LinkKind::kEnd, .mission_id = context_.mission_id});
  }
}

std::vector<HostExit> MissionHosts::TakeExits() { return std::exchange(exits_, {}); }
std::vector<HostTrouble> MissionHosts::TakeTroubles() { return std::exchange(troubles_, {}); }
std::vector<std::string> MissionHosts::TakeNotes() { return std::exchange(notes_, {}); }

std::string MissionHosts::Summary() const {
  std::string text;
  for (size_t i = 0; i < hosts_.size(); ++i) {
    const HomeRelay::Timing& timing = relay_->timing(i);
    std::vector<int32_t> sorted = timing.answer_us;
    if (sorted.empty()) continue;
    std::sort(sorted.begin(), sorted.end());
    const auto at = [&](double share) {
      return Milliseconds(
          sorted[static_cast<size_t>(static_cast<double>(sorted.size() - 1) * share)]);
    };
    const std::string late = timing.num_late == 0
                                 ? "never late"
                                 : fmt::format("late in {} steps, by {:.1f} ms at worst",
                                               timing.num_late, Milliseconds(timing.worst_late_us));
    text += fmt::format(
        "Host {}: {} steps, answers after {:.2f} ms (median), {:.2f} ms (95 %), {:.2f} ms (worst); "
        "{}; {} batches refused{}\n",
        hosts_[i].options.name, sorted.size(), at(0.5), at(0.95), at(1), late,
        hosts_[i].num_refused,
        relay_->num_dropped(i) == 0 ? ""
                                    : fmt::format("; {} messages dropped that none of its "
                                                  "processes publishes",
                                                  relay_->num_dropped(i)));
  }
  return text;
}

}  // namespace shoal
