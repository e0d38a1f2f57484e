#include "lib/run/run/step_clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "lib/base/text/terminal_text.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/run/status_page.h"
#include "lib/run/run/step_answers.h"
#include "shoal/clock_state_t.hpp"

namespace shoal {

namespace {

constexpr int64_t kRepeatAfter_us = 50'000;
constexpr int64_t kStateInterval_us = 500'000;
/// OnTime is called every 50 ms at least; a longer pause was the launcher's own.
constexpr int64_t kOwnStall_us = 1'000'000;
constexpr int64_t kHelloSilence_us = 2'000'000;  ///< Hellos come every 0.2 s.
constexpr char kClockName[] = "clock";           ///< In its seals.
constexpr int64_t kNever = std::numeric_limits<int64_t>::max();

}  // namespace

StepClock::StepClock(ClockOptions options, std::vector<std::string> participants, PortPlan plan,
                     Transport& transport)
    : options_(std::move(options)),
      plan_(std::move(plan)),
      transport_(transport),
      pace_(options_.warp, options_.tick_us, options_.fixed_pace),
      last_step_(options_.last_step) {
  for (std::string& name : participants) members_[std::move(name)];
  transport_.Listen(plan_.done_port(), channels::StepDone().name);
  transport_.Listen(plan_.done_port(), channels::StepDones().name);
  transport_.Listen(plan_.done_port(), channels::ClockCommand().name);
}

void StepClock::OnDatagram(int port, std::string_view channel, std::span<const uint8_t> datagram,
                           int64_t wall_us) {
  if (port != plan_.done_port()) return;
  if (channel == channels::ClockCommand().name) {
    clock_command_t command;
    if (!Decode(datagram, &command)) {
      ++counters_.undecodable;
      return;
    }
    ++num_commands_;
    const std::string why_not = Execute(command, wall_us);
    refusal_ =
        why_not.empty() ? "" : fmt::format("{} refused: {}", Printable(command.command), why_not);
    SendState(wall_us);
    return;
  }
  if (IsStepAnswer(channel)) OnAnswers(channel, datagram, wall_us);
}

/// Takes the answers of one process: STEP_DONE has one, STEP_DONES several.
void StepClock::OnAnswers(std::string_view channel, std::span<const uint8_t> datagram,
                          int64_t wall_us) {
  const Unsealed unsealed = Unseal(datagram);
  const std::optional<step_dones_t> answers = DecodeStepAnswers(channel, unsealed.message);
  // A hello may not know the mission's id yet.
  const auto is_foreign = [&](const step_done_t& done) {
    const bool is_hello = done.step < 0;
    return done.mission_id != options_.mission_id && !(is_hello && done.mission_id == 0);
  };
  if (!answers) {
    ++counters_.undecodable;
  } else if (std::any_of(answers->dones.begin(), answers->dones.end(), is_foreign)) {
    ++counters_.foreign;
  } else if (const std::string& first = answers->dones.front().participant;
             !IsGenuine(unsealed, options_.secret, channel) || unsealed.seal->publisher != first) {
    ++counters_.refused;
    if (refused_.empty()) refused_ = Printable(first);
  } else {
    for (const step_done_t& done : answers->dones) OnDone(done, wall_us);
  }
}

/// Executes a command. Returns why not, or an empty text.
std::string StepClock::Execute(const clock_command_t& command, int64_t wall_us) {
  if (state_ == State::kEnding || state_ == State::kEnded) return "the mission is ending";
  return pace_.Execute(command, wall_us);
}

/// `is_awaiting`: participants have not sent hello yet.
std::string_view StepClock::StateWord(bool is_awaiting) const {
  if (state_ == State::kEnding || state_ == State::kEnded) return "ending";
  if (is_awaiting) return "gathering";
  if (pace_.is_paused()) return "paused";
  return state_ == State::kGathering ? "gathering" : "running";
}

void StepClock::SendState(int64_t wall_us) {
  next_state_us_ = wall_us + kStateInterval_us;
  if (state_ == State::kRunning) pace_.MeasureFactor(wall_us);
  clock_state_t state{};
  state.utime = utime();
  state.mission_id = options_.mission_id;
  state.step = step_;
  if (state_ == State::kGathering) state.awaited = Awaited();
  state.state = StateWord(!state.awaited.empty());
  state.warp = pace_.warp();
  state.factor = pace_.factor();
  state.num_commands = num_commands_;
  state.refusal = refusal_;
  state.num_awaited = static_cast<int32_t>(state.awaited.size());
  Bytes bytes;
  EncodeInto(state, &bytes);
  transport_.Send(plan_.tick_port(), channels::ClockState().name, bytes);
}

void StepClock::OnDone(const step_done_t& done, int64_t wall_us) {
  const auto found = members_.find(done.participant);
  if (found == members_.end()) {
    if (unregistered_.empty()) unregistered_ = Printable(done.participant);
    return;
  }
  Member& member = found->second;
  if (member.exited_pids.contains(done.pid)) {
    ++counters_.refused;
    return;
  }
  if (!done.fault.empty() && fault_.empty()) {
    fault_ = done.participant + ": " + TerminalLine(done.fault);
  }
  if (!member.present) {
    // A hello may be lost; a participant that answers the present step is here just as well.
    const bool joins = state_ == State::kGathering || done.step < 0 || done.step == step_;
    if (!joins) return;
    member.pid = done.pid;
    member.hello_us = wall_us;
    if (state_ == State::kGathering) {
      member.present = true;
    } else {
      member.joins_next = true;
    }
    return;
  }
  if (done.pid == member.pid) member.hello_us = wall_us;
  if (done.pid != member.pid) {
    if (fault_.empty()) {
      fault_ = fmt::format(
          "two processes call themselves {} (pid {} and {}): end one (kill PID), or start it under "
          "another name",
          done.participant, member.pid, done.pid);
    }
    return;
  }
  if (done.step != step_ || member.answered_step == step_) return;
  member.answered_step = step_;
  member.repeated = done.repeated;
  member.outside = done.outside;
  member.foreign = done.foreign;
  member.undecodable = done.undecodable;
  member.refused = done.refused;
  for (const step_count_t& count : done.published) {
    next_totals_.push_back(
        {.publisher = done.participant, .channel = count.channel, .count = count.count});
    counters_.messages += count.count;
  }
  if (AllAnswered()) Advance(wall_us);
}

bool StepClock::AllAnswered() const {
  return std::all_of(members_.begin(), members_.end(), [&](const auto& item) {
    return !item.second.present || item.second.answered_step == step_;
  });
}

void StepClock::Advance(int64_t wall_us) {
  if (state_ == State::kEnding) {
    state_ = State::kEnded;
    UpdateCounters();
    return;
  }
  if (pace_.is_paused() && !stop_wanted_) return;
  const bool is_last = step_ >= last_step_ || stop_wanted_;
  if (!is_last && wall_us < pace_.DueTime()) return;
  pace_.ForgiveStall(wall_us);
  for (auto& [name, member] : members_) {
    if (member.joins_next) {
      member.present = true;
      member.joins_next = false;
      joining_.push_back(name);
      membership_changed_ = true;
    }
  }
  if (is_last) state_ = State::kEnding;
  SendTick(wall_us);
}

void StepClock::SendTick(int64_t wall_us) {
  ++step_;
  tick_ = tick_t{};
  tick_.utime = options_.start_utime + step_ * options_.tick_us;
  tick_.mission_id = options_.mission_id;
  tick_.step = step_;
  tick_.kind = state_ == State::kEnding ? tick_t::END : tick_t::RUN;
  tick_.warp = pace_.warp();
  tick_.totals = std::move(next_totals_);
  tick_.num_totals = static_cast<int32_t>(tick_.totals.size());
  next_totals_.clear();
  for (const auto& [name, member] : members_) {
    const bool begins = step_ == 0 && member.present;
    if (!begins && std::find(joining_.begin(), joining_.end(), name) == joining_.end()) continue;
    tick_.joined.push_back(name);
    tick_.joined_pids.push_back(member.pid);
  }
  tick_.num_joined = static_cast<int32_t>(tick_.joined.size());
  joining_.clear();
  pace_.OnStep(step_, wall_us);
  for (auto& [name, member] : members_) {
    member.asked_at_us = wall_us;
    member.next_repeat_us = wall_us + kRepeatAfter_us;
  }
  SendTickDatagram();
  // The mission has just begun, or ends.
  if (step_ == 0 || state_ == State::kEnding) SendState(wall_us);
}

/// A participant that a user starts, ends and starts again before the mission begins is awaited in
/// between.
void StepClock::ForgetSilentHellos(int64_t wall_us) {
  for (auto& [name, member] : members_) {
    if (member.present && wall_us - member.hello_us > kHelloSilence_us) member.present = false;
  }
}

void StepClock::SendTickDatagram() {
  Bytes bytes;
  EncodeInto(tick_, &bytes);
  AppendSeal({.publisher = kClockName,
              .mission_id = options_.mission_id,
              .step = tick_.step,
              .sequence = 0},
             options_.secret, topics::kTick, &bytes);
  transport_.Send(plan_.tick_port(), topics::kTick, bytes);
}

void StepClock::OnTime(int64_t wall_us) {
  if (wall_us - last_time_us_ > kOwnStall_us) {
    // The launcher itself stood still (Ctrl-Z, a paused machine): no silence counts.
    for (auto& [name, member] : members_) member.asked_at_us = wall_us;
  }
  last_time_us_ = wall_us;
  if (state_ == State::kEnded) return;
  if (wall_us >= next_state_us_) SendState(wall_us);
  if (state_ == State::kGathering) {
    ForgetSilentHellos(wall_us);
    if (stop_wanted_) {
      // No step has begun; END ends those that are there.
      for (auto& [name, member] : members_) member.answered_step = -1;
      state_ = State::kEnding;
      SendTick(wall_us);
    } else if (!pace_.is_paused() && Awaited().empty()) {
      state_ = State::kRunning;
      pace_.Begin(wall_us);
      SendTick(wall_us);
    }
    return;
  }
  if (stop_wanted_ && wall_us >= stop_deadline_us_) {
    if (state_ == State::kEnding) {
      state_ = State::kEnded;
      UpdateCounters();
      return;
    }
    // A participant does not answer: the others end without this step's totals.
    state_ = State::kEnding;
    stop_deadline_us_ = wall_us + kRepeatAfter_us * 4;
    next_totals_.clear();
    SendTick(wall_us);
    return;
  }
  if (AllAnswered()) {
    Advance(wall_us);
    return;
  }
  bool repeat = false;
  for (auto& [name, member] : members_) {
    if (!member.present || member.answered_step == step_ || wall_us < member.next_repeat_us) {
      continue;
    }
    member.next_repeat_us = wall_us + kRepeatAfter_us;
    repeat = true;
  }
  if (repeat) {
    ++counters_.ticks_again;
    SendTickDatagram();
  }
}

int64_t StepClock::NextDeadline() const {
  if (state_ == State::kEnded) return kNever;
  if (state_ == State::kGathering) return 0;
  int64_t next = stop_wanted_ ? stop_deadline_us_ : kNever;
  if (AllAnswered()) return pace_.is_paused() ? next : std::min(next, pace_.DueTime());
  for (const auto& [name, member] : members_) {
    if (member.present && member.answered_step != step_) {
      next = std::min(next, member.next_repeat_us);
    }
  }
  return next;
}

void StepClock::Drop(const std::string& participant, int64_t wall_us) {
  const auto found = members_.find(participant);
  // After the end all may go.
  if (found == members_.end() || state_ == State::kEnded) return;
  found->second.joins_next = false;
  if (!found->second.present) return;
  CountOf(found->second);
  Member dropped;
  dropped.former_pid = found->second.pid;
  dropped.exited_pids = std::move(found->second.exited_pids);
  found->second = std::move(dropped);
  membership_changed_ = true;
  // What it published in a step that it did not finish does not count.
  if (state_ != State::kGathering && state_ != State::kEnded && AllAnswered()) Advance(wall_us);
}

void StepClock::DropExited(const std::string& participant, int64_t wall_us) {
  const auto found = members_.find(participant);
  if (found != members_.end()) {
    Member& member = found->second;
    for (const int32_t pid : {member.pid, member.former_pid}) {
      if (pid != 0) member.exited_pids.insert(pid);
    }
  }
  Drop(participant, wall_us);
}

void StepClock::Leave(const std::string& participant, int64_t wall_us) {
  const auto found = members_.find(participant);
  if (state_ != State::kEnding || found == members_.end()) return;
  found->second.answered_step = step_;
  if (AllAnswered()) Advance(wall_us);
}

void StepClock::Stop(int64_t wall_us, int64_t patience_us) {
  if (stop_wanted_) return;
  stop_wanted_ = true;
  stop_deadline_us_ = wall_us + patience_us;
}

int64_t StepClock::utime() const {
  // END is a tick too, and no step.
  const bool is_end = state_ == State::kEnding || state_ == State::kEnded;
  const int64_t last_run = std::max<int64_t>(is_end ? step_ - 1 : step_, 0);
  return options_.start_utime + last_run * options_.tick_us;
}

std::vector<std::string> StepClock::Awaited() const {
  std::vector<std::string> names;
  for (const auto& [name, member] : members_) {
    if (!member.present) names.push_back(name);
  }
  return names;
}

std::vector<std::string> StepClock::Silent(int64_t wall_us) const {
  std::vector<std::string> names;
  if (state_ != State::kRunning && state_ != State::kEnding) return names;
  for (const auto& [name, member] : members_) {
    if (member.present && member.answered_step != step_ &&
        wall_us - member.asked_at_us > options_.timeout_us) {
      names.push_back(name);
    }
  }
  return names;
}

void StepClock::CountOf(const Member& member) {
  counters_.repeated += member.repeated;
  counters_.outside += member.outside;
  counters_.foreign += member.foreign;
  counters_.undecodable += member.undecodable;
  counters_.refused += member.refused;
}

void StepClock::UpdateCounters() {
  for (const auto& [name, member] : members_) CountOf(member);
}

}  // namespace shoal
