#include "apps/shoal_play/player.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <signal.h>
#include <sys/random.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <utility>

#include "lib/base/check/result.h"
#include "lib/base/text/numbers.h"
#include "lib/base/time/seconds.h"
#include "lib/base/time/time_units.h"
#include "lib/bus/bus/channels.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

constexpr int64_t kLongestPoll_us = 50'000;
constexpr int64_t kStopPatience_us = 1'000'000;
constexpr std::string_view kSeek = "seek ";

/// The kernel reports how full other processes' buffers are in a table, and wakes no one when they
/// are emptied: there is no file descriptor to wait for, and so the table is read again after a
/// short pause.
void PauseFor(int64_t us) { usleep(static_cast<useconds_t>(us)); }

/// The ports at which others receive.
std::set<int> ReceiversPorts(const PortPlan& ports) {
  std::set<int> numbers = {ports.tick_port()};
  for (const int port : ports.DataPorts()) numbers.insert(port);
  return numbers;
}

}  // namespace

int64_t RandomPlaybackId() {
  int64_t id = 0;
  if (getrandom(&id, sizeof id, 0) != sizeof id) id = MonotonicMicroseconds();
  return std::max<int64_t>(id & std::numeric_limits<int64_t>::max(), 1);
}

struct Player::Session {
  Session(const PlayOptions& options, PlaybackLog* log, const Mission& mission,
          const RunningMission& running, const PortPlan& ports, const MissionSecret& secret,
          LogWriter* answers, int64_t from_utime, double warp)
      : transport(
            &lcm,
            [queues = ForeignQueues(ReceiversPorts(ports))]() mutable {
              std::ifstream table("/proc/net/udp");
              return queues.In(table);
            },
            &PauseFor),
        group({.mission_id = running.mission_id,
               .pid = getpid(),
               .secret = secret,
               .give_up_us = GiveUpAfter_us(mission)},
              ports, transport),
        app(log, options.channels, mission.tick_us, answers, group.Join(kPlaybackName)),
        clock({.mission_id = running.mission_id,
               .secret = secret,
               .warp = warp,
               .tick_us = mission.tick_us,
               .start_utime = from_utime,
               .last_step = (log->last_utime() - from_utime) / mission.tick_us,
               .timeout_us = static_cast<int64_t>(mission.participant_timeout_s * 1e6)},
              Participants(options), ports, transport) {
    group.Attach(kPlaybackName, &app);
    group.Listen();
    lcm.DeferFrom(ports.shore_port());
  }

  static std::vector<std::string> Participants(const PlayOptions& options) {
    std::vector<std::string> names = options.participants;
    names.emplace_back(kPlaybackName);
    return names;
  }

  LcmTransport lcm;
  PacedTransport transport;
  StepGroup group;
  PlaybackApp app;
  StepClock clock;
};

Player::Player(const PlayOptions& options, PlaybackLog* log, const Mission& mission,
               const RunningMission& running, LogWriter* answers, int signal_fd)
    : options_(options),
      log_(*log),
      mission_(mission),
      running_(running),
      answers_(answers),
      signal_fd_(signal_fd),
      ports_(running.Ports()),
      secret_(RandomSecret()),
      warp_(options.warp),
      is_paused_(options.paused) {}

void Player::Fail(const std::string& why) {
  if (exit_code_ == 0) terminal_.Warn("shoal: " + why);
  exit_code_ = kExitEnvironment;
}

double Player::At_s(const Session& session) const {
  return Seconds(session.clock.utime() - log_.first_utime());
}

std::unique_ptr<Player::Session> Player::MakeSession(int64_t from_utime) {
  // Participants were given the id of the first session.
  if (std::exchange(has_begun_, true)) running_.mission_id = RandomPlaybackId();
  if (const auto kept = KeepSecret(running_.port_base, secret_); !kept.ok()) {
    Fail(kept.error());
    return nullptr;
  }
  if (const auto registered = Register(running_); !registered.ok()) {
    Fail(registered.error());
    return nullptr;
  }
  log_.SeekTo(from_utime);
  auto session = std::make_unique<Session>(options_, &log_, mission_, running_, ports_, secret_,
                                           answers_, from_utime, warp_);
  session->lcm.set_receiver([this, raw = session.get()](int port, std::string_view channel,
                                                        std::span<const uint8_t> datagram) {
    Receive(raw, port, channel, datagram);
  });
  return session;
}

void Player::Receive(Session* session, int port, std::string_view channel,
                     std::span<const uint8_t> datagram) {
  const int64_t now = MonotonicMicroseconds();
  if (port != ports_.done_port()) {
    session->group.OnDatagram(port, channel, datagram, now);
    return;
  }
  clock_command_t command;
  const bool is_order = channel == channels::ClockCommand().name && Decode(datagram, &command);
  if (is_order && std::string_view(command.command).starts_with(kSeek)) {
    if (const auto to_s = ReadNumber<double>(command.command.substr(kSeek.size()))) {
      SeekTo(*to_s);
      return;
    }
  }
  session->clock.OnDatagram(port, channel, datagram, now);
  if (!is_order) return;
  // The clock may have refused the order, for instance because it ends: its own state counts.
  if (command.command == "warp") warp_ = session->clock.warp();
  if (command.command == "pause" || command.command == "resume") {
    is_paused_ = session->clock.paused();
  }
}

void Player::SeekTo(double since_begin_s) {
  const double length_s = Seconds(log_.last_utime() - log_.first_utime());
  const double to_s = std::clamp(std::isfinite(since_begin_s) ? since_begin_s : 0, 0.0, length_s);
  const auto steps = static_cast<int64_t>(std::llround(to_s * 1e6)) / mission_.tick_us;
  seek_utime_ = log_.first_utime() + steps * mission_.tick_us;
}

/// Gives the clock an order as if it had come from outside.
void Player::Order(Session* session, const std::string& command, double warp) {
  clock_command_t order{};
  order.command = command;
  order.warp = warp;
  Bytes bytes;
  EncodeInto(order, &bytes);
  Receive(session, ports_.done_port(), channels::ClockCommand().name, bytes);
}

void Player::ObeyKeys(Session* session) {
  constexpr double kFactor = 2;
  constexpr double kFromMax = 16;
  for (const PlayKey& key : keyboard_.Pressed()) {
    switch (key.kind) {
      case PlayKey::Kind::kPause:
        Order(session, is_paused_ ? "resume" : "pause");
        break;
      case PlayKey::Kind::kSeekBy:
        // Several keys may be pressed at once: each moves on from where the one before leads to.
        SeekTo((seek_utime_ ? Seconds(*seek_utime_ - log_.first_utime()) : At_s(*session)) +
               key.seconds);
        break;
      case PlayKey::Kind::kBegin:
        SeekTo(0);
        break;
      case PlayKey::Kind::kFaster:
        if (warp_ > 0) Order(session, "warp", warp_ * kFactor);
        break;
      case PlayKey::Kind::kSlower:
        Order(session, "warp", warp_ > 0 ? warp_ / kFactor : kFromMax);
        break;
      case PlayKey::Kind::kFastest:
        Order(session, "warp", 0);
        break;
      case PlayKey::Kind::kEnd:
        is_over_ = true;
        break;
    }
  }
}

void Player::ShowProgress(Session& session) {
  const int64_t now = MonotonicMicroseconds();
  if (options_.quiet || now < next_progress_us_) return;
  next_progress_us_ = now + (terminal_.is_interactive() ? kSecond_us / 4 : 5 * kSecond_us);
  if (const auto awaited = session.clock.Awaited();
      session.clock.state() == StepClock::State::kGathering && !awaited.empty()) {
    terminal_.ShowProgress(fmt::format("playback waits for {}", fmt::join(awaited, ", ")));
    return;
  }
  const PlaybackCounts& counts = session.app.counts();
  terminal_.ShowProgress(fmt::format("PLAYBACK {:8.1f} of {:.1f} s  {}  {} messages, {} bytes",
                                     At_s(session), Seconds(log_.last_utime() - log_.first_utime()),
                                     session.clock.paused() ? "paused"
                                     : warp_ > 0            ? fmt::format("speed {:g}", warp_)
                                                            : "as fast as the receivers",
                                     counts_.played + counts.played, counts_.bytes + counts.bytes));
}

/// Plays until the log's end, a jump in it, a signal or an error.
void Player::Work(Session* session) {
  bool has_begun = false;
  while (session->clock.state() != StepClock::State::kEnded) {
    int64_t now = MonotonicMicroseconds();
    session->group.OnTime(now);
    session->clock.OnTime(now);
    ObeyKeys(session);
    ShowProgress(*session);
    if (!session->lcm.error().empty()) return Fail(session->lcm.error());
    if (!session->clock.fault().empty()) return Fail(session->clock.fault());
    for (const std::string& name : session->clock.Silent(now)) {
      terminal_.Warn(
          fmt::format("shoal: {} does not answer any more; playback goes on without it", name));
      session->clock.Drop(name, now);
    }
    if (is_over_ || seek_utime_) return;
    if (!has_begun && session->clock.step() >= 0) {
      has_begun = true;
      // It was moved while paused. It pauses again after one step, so that viewers show the place.
      if (is_paused_) Order(session, "pause");
    }
    const int64_t deadline = std::min(session->group.NextDeadline(), session->clock.NextDeadline());
    now = MonotonicMicroseconds();
    if (session->lcm.Poll(std::clamp<int64_t>(deadline - now, 0, kLongestPoll_us), signal_fd_)) {
      signalfd_siginfo signal{};
      while (read(signal_fd_, &signal, sizeof signal) == sizeof signal) {
        is_over_ = is_over_ || signal.ssi_signo != SIGCHLD;
      }
    }
  }
}

void Player::End(Session* session) {
  session->clock.Stop(MonotonicMicroseconds(), kStopPatience_us);
  while (session->clock.state() != StepClock::State::kEnded) {
    const int64_t now = MonotonicMicroseconds();
    session->group.OnTime(now);
    session->clock.OnTime(now);
    session->lcm.Poll(1'000);
    if (!session->lcm.error().empty()) break;
  }
  const PlaybackCounts& counts = session->app.counts();
  counts_.played += counts.played;
  counts_.bytes += counts.bytes;
  counts_.left_out += counts.left_out;
  counts_.not_chosen += counts.not_chosen;
  counts_.repeated += counts.repeated;
  counts_.answers += counts.answers;
  num_given_up_ += session->transport.num_given_up();
  num_repeated_ += session->clock.counters().repeated;
}

int Player::Run() {
  SeekTo(options_.from_s);
  const int64_t begin_utime = *seek_utime_;
  bool waits_at_begin = is_paused_;
  while (!is_over_ && exit_code_ == 0) {
    const int64_t from_utime = seek_utime_.value_or(begin_utime);
    seek_utime_.reset();
    const std::unique_ptr<Session> session = MakeSession(from_utime);
    if (session == nullptr) break;
    // It pauses before the first step, so that receivers that start now miss nothing.
    if (std::exchange(waits_at_begin, false)) Order(session.get(), "pause");
    Work(session.get());
    End(session.get());
    if (!seek_utime_ && !options_.loop) break;
  }
  terminal_.EndProgress();
  LaunchTerminal::Print(fmt::format(
      "Played: {} messages, {} bytes{}{}{}\n", counts_.played, counts_.bytes,
      counts_.repeated > 0 ? fmt::format("; again, as of before: {}", counts_.repeated) : "",
      counts_.left_out > 0
          ? fmt::format("; left out: {} of the stepping and of LCM", counts_.left_out)
          : "",
      counts_.not_chosen > 0 ? fmt::format("; not chosen: {}", counts_.not_chosen) : ""));
  if (num_repeated_ > 0) {
    LaunchTerminal::Print(fmt::format("Sent again to participants: {} datagrams\n", num_repeated_));
  }
  if (num_given_up_ > 0) {
    terminal_.Warn(
        fmt::format("shoal: {} receivers on this machine read nothing for a second, and "
                    "were not waited for: they have lost messages",
                    num_given_up_));
  }
  if (log_.num_damages() > 0) {
    Fail(fmt::format("{} damaged parts of {} were skipped; `shoal log info` shows them",
                     log_.num_damages(), log_.path()));
  }
  return exit_code_;
}

}  // namespace shoal
