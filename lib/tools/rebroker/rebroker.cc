#include "lib/tools/rebroker/rebroker.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "lib/bus/bus/memory_bus.h"

namespace shoal {

namespace {

constexpr std::string_view kBrokerName = "shore_broker";

/// One broker, alone with the log.
class Replayed {
 public:
  Replayed(const BrokerSetup& setup, const MakeBroker& make_broker)
      : log_bus_(hub_.Join("log")),
        broker_bus_(hub_.Join(std::string(kBrokerName))),
        broker_(make_broker(setup, broker_bus_)) {
    log_bus_.SubscribeAll([this](const Message& message) {
      if (message.publisher == kBrokerName) (*on_message_)(message);
    });
  }

  std::optional<int64_t> NextArrivalUtime() const { return broker_->NextArrivalUtime(); }

  void Give(std::string_view channel, std::span<const uint8_t> data) {
    log_bus_.PublishBytes(channel, data);
  }

  /// Takes a step with what was given, and hands what the broker publishes to `on_message`.
  void Step(int64_t utime, const std::function<void(const Message&)>& on_message) {
    hub_.NextStep();
    hub_.Handle(broker_bus_);
    broker_->Tick(utime);
    hub_.NextStep();
    on_message_ = &on_message;
    hub_.Handle(log_bus_);
  }

 private:
  MemoryBus hub_;
  Bus& log_bus_;
  Bus& broker_bus_;
  std::unique_ptr<Broker> broker_;
  const std::function<void(const Message&)>* on_message_ = nullptr;
};

/// Puts events into the order of a log: by time, then by channel.
class LogOrder {
 public:
  explicit LogOrder(const EventSink& sink) : sink_(sink) {}

  bool is_wanted() const { return static_cast<bool>(sink_); }

  void Add(int64_t utime, std::string_view channel, std::span<const uint8_t> data) {
    if (!sink_) return;
    waiting_.push_back({utime, std::string(channel), Bytes(data.begin(), data.end())});
  }

  /// Hands on what waits. What is added after this is later than all that was added before.
  void Flush() {
    std::stable_sort(waiting_.begin(), waiting_.end(), [](const Event& a, const Event& b) {
      return std::tie(a.utime, a.channel) < std::tie(b.utime, b.channel);
    });
    for (const Event& event : waiting_) sink_(event.utime, event.channel, event.data);
    waiting_.clear();
  }

 private:
  struct Event {
    int64_t utime = 0;
    std::string channel;
    Bytes data;
  };
  const EventSink& sink_;
  std::vector<Event> waiting_;
};

bool IsControl(std::string_view channel) { return FindControlOnChannel(channel) != nullptr; }

/// Returns when the broker takes a step. It forgets the silent at the end of every step; without a
/// report between, the step before one with inputs forgets all vehicles that would have been
/// forgotten in the steps before.
std::vector<int64_t> TimesOfSteps(const CommsLog& log) {
  std::vector<int64_t> times;
  for (const LoggedMessage& input : log.inputs) {
    times.push_back(input.utime - log.tick_us);
    times.push_back(input.utime);
  }
  for (const BrokerStart& start : log.starts) {
    times.push_back(start.utime);
    times.push_back(start.rules_utime);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::erase_if(times, [&](int64_t utime) {
    return utime < log.starts.front().utime || utime > log.last_utime;
  });
  return times;
}

SameDecision HowToCompare(const CommsLog& log) {
  if (log.time == LogTime::kWall) return SameDecision::kFateOnly;
  return log.gaps.empty() ? SameDecision::kWhole : SameDecision::kWithoutNumbers;
}

/// The recorded decisions, in time.
class RecordedFates {
 public:
  RecordedFates(const CommsLog& log, int64_t* num_undecodable)
      : log_(log), num_undecodable_(num_undecodable) {}

  /// Appends the decisions up to `utime`, and returns when the first of them was made.
  int64_t TakeUntil(int64_t utime, std::vector<fate_t>* fates) {
    const int64_t first = HasNext() ? log_.fates[next_].utime : utime;
    for (; HasNext() && log_.fates[next_].utime <= utime; ++next_) {
      if (!Decode(log_.BytesOf(log_.fates[next_]), &message_)) {
        ++*num_undecodable_;
        continue;
      }
      fates->insert(fates->end(), message_.fates.begin(), message_.fates.end());
    }
    return std::min(first, utime);
  }
  bool HasNext() const { return next_ < log_.fates.size(); }
  int64_t NextUtime() const { return log_.fates[next_].utime; }

 private:
  const CommsLog& log_;
  int64_t* num_undecodable_;
  size_t next_ = 0;
  comms_fates_t message_;
};

/// One run through a log.
class Run {
 public:
  Run(const CommsLog& log, const RebrokerSettings& settings, const MakeBroker& make_broker,
      const EventSink& sink)
      : log_(log),
        settings_(settings),
        make_broker_(make_broker),
        out_(sink),
        recorded_(log, &outcome_.num_undecodable),
        absences_(settings.absences) {
    outcome_.comparison = DecisionComparison(HowToCompare(log));
    empty_controls_.utime = 0;
    empty_controls_.num_controls = 0;
  }

  RebrokerOutcome Take() {
    if (!log_.starts.empty()) {
      std::vector<int64_t> times = TimesOfSteps(log_);
      times.push_back(log_.last_utime + 1);  // Until then, what is in transit arrives.
      for (size_t i = 0; i + 1 < times.size(); ++i) {
        Step(times[i]);
        for (auto utime = NextArrival(times[i]); utime && *utime < times[i + 1];
             utime = NextArrival(*utime)) {
          Step(*utime);
        }
      }
    }
    Compare(log_.last_utime, {});
    WriteInputsUntil(INT64_MAX);
    out_.Flush();
    for (const BrokerAbsence& absence : absences_) {
      if (absence.num_decisions > 0) outcome_.absences.push_back(absence);
    }
    return std::move(outcome_);
  }

 private:
  void Step(int64_t utime) {
    while (next_start_ < log_.starts.size() && log_.starts[next_start_].utime <= utime) Start();
    GiveTruthUntil(utime);
    for (; next_input_ < log_.inputs.size() && log_.inputs[next_input_].utime <= utime;
         ++next_input_) {
      const LoggedMessage& input = log_.inputs[next_input_];
      if (input.utime < utime) {
        ++outcome_.num_too_early;
      } else if (IsGiven(input)) {
        broker_->Give(BrokerChannels()[input.channel], DataOf(input));
      }
    }
    while (next_absence_ < absences_.size() && absences_[next_absence_].before_utime <= utime) {
      ++next_absence_;
    }
    BrokerAbsence* absence = nullptr;
    if (next_absence_ < absences_.size() && absences_[next_absence_].after_utime < utime) {
      absence = &absences_[next_absence_];
    }
    std::vector<fate_t> fates;
    broker_->Step(utime, [&](const Message& message) {
      if (message.channel == channels::CommsFates().name) {
        comms_fates_t published;
        SHOAL_CHECK(Decode(message.data, &published), "a broker's COMMS_FATES decodes");
        fates.insert(fates.end(), published.fates.begin(), published.fates.end());
      }
      if (absence == nullptr && out_.is_wanted() && IsLogged(message.channel)) {
        out_.Add(utime, message.channel, message.data);
      }
    });
    if (absence != nullptr) {
      absence->num_decisions += static_cast<int64_t>(fates.size());
      fates.clear();
    }
    for (const fate_t& fate : fates) outcome_.links.AddNow(fate);
    Compare(utime, std::move(fates));
    WriteInputsUntil(utime);
    out_.Flush();
  }

  /// Returns the step after `utime` in which something may arrive; nothing where nothing is in
  /// transit. Other steps are skipped: a packet may be in transit for a day.
  std::optional<int64_t> NextArrival(int64_t utime) const {
    const std::optional<int64_t> next_utime = broker_->NextArrivalUtime();
    if (!next_utime) return std::nullopt;
    const int64_t waits_us = std::max<int64_t>(*next_utime - utime, 1);
    const int64_t num_steps = (waits_us - 1) / log_.tick_us + 1;
    return utime + num_steps * log_.tick_us;
  }

  /// A broker asks for the controls that it has missed where the mission began before it did; the
  /// acoustic network and its time stamps count from the mission's start.
  int64_t MissionStart(const BrokerStart& start) const {
    if (!start.in_the_midst) return start.utime;
    const BrokerStart& first = log_.starts.front();
    const bool knows_mission = !first.in_the_midst && log_.time != LogTime::kWall;
    return knows_mission ? std::min(first.utime, start.utime - 1) : start.utime - 1;
  }

  void Start() {
    CompareAll();
    const BrokerStart& start = log_.starts[next_start_++];
    BrokerSetup setup = settings_.setup;
    setup.start_utime = MissionStart(start);
    broker_ = std::make_unique<Replayed>(setup, make_broker_);
  }

  /// Of the steps that are skipped, the last place of each vehicle counts.
  void GiveTruthUntil(int64_t utime) {
    if (!settings_.setup.GoesByTruth()) return;
    for (; next_truth_ < log_.truths.size() && log_.truths[next_truth_].utime <= utime;
         ++next_truth_) {
      const LoggedTruth& truth = log_.truths[next_truth_];
      broker_->Give(log_.truth_channels[truth.vehicle], log_.BytesOf(truth));
    }
  }

  bool IsGiven(const LoggedMessage& input) const {
    return settings_.with_controls || !IsControl(BrokerChannels()[input.channel]);
  }

  /// A broker that asks for controls is answered in any case.
  std::span<const uint8_t> DataOf(const LoggedMessage& input) {
    const bool is_answer = BrokerChannels()[input.channel] == channels::UncControls().name;
    if (settings_.with_controls || !is_answer) return log_.BytesOf(input);
    EncodeInto(empty_controls_, &bytes_);
    return bytes_;
  }

  /// Inputs were published a step before they were handled.
  void WriteInputsUntil(int64_t utime) {
    WriteTruthUntil(utime);
    for (; next_written_ < log_.inputs.size(); ++next_written_) {
      const LoggedMessage& input = log_.inputs[next_written_];
      if (input.utime - log_.tick_us > utime) return;
      if (!IsGiven(input)) continue;
      out_.Add(input.utime - log_.tick_us, BrokerChannels()[input.channel], DataOf(input));
    }
  }

  void WriteTruthUntil(int64_t utime) {
    if (!out_.is_wanted() || !settings_.setup.GoesByTruth()) return;
    for (; next_written_truth_ < log_.truths.size(); ++next_written_truth_) {
      const LoggedTruth& truth = log_.truths[next_written_truth_];
      const int64_t published_utime = truth.utime - log_.tick_us;
      if (published_utime > utime) return;
      out_.Add(published_utime, log_.truth_channels[truth.vehicle], log_.BytesOf(truth));
    }
  }

  /// Compares what was decided since the step before with `now`, all of it decided at `utime`.
  void Compare(int64_t utime, std::vector<fate_t> now) {
    if (log_.time == LogTime::kWall) {
      // The logger's times are a little later than the broker's.
      waiting_now_.insert(waiting_now_.end(), std::make_move_iterator(now.begin()),
                          std::make_move_iterator(now.end()));
      if (utime == log_.last_utime) CompareAll();
      return;
    }
    while (recorded_.HasNext() && recorded_.NextUtime() < utime) {
      CompareStep(recorded_.NextUtime(), {});
    }
    CompareStep(utime, now);
  }

  void CompareStep(int64_t utime, std::span<const fate_t> now) {
    std::vector<fate_t> then;
    const int64_t first_utime = recorded_.TakeUntil(utime, &then);
    for (const fate_t& fate : then) outcome_.links.AddRecorded(fate);
    outcome_.comparison.Compare(first_utime, then, now);
  }

  /// kWall: compares all that one broker decided, before the next begins.
  void CompareAll() {
    if (log_.time != LogTime::kWall || broker_ == nullptr) return;
    const bool is_last = next_start_ == log_.starts.size();
    CompareStep(is_last ? log_.last_utime : log_.starts[next_start_].utime - 1, waiting_now_);
    waiting_now_.clear();
  }

  const CommsLog& log_;
  const RebrokerSettings& settings_;
  const MakeBroker& make_broker_;
  LogOrder out_;
  RebrokerOutcome outcome_;
  RecordedFates recorded_;
  std::vector<BrokerAbsence> absences_;
  unc_controls_t empty_controls_;
  Bytes bytes_;
  std::unique_ptr<Replayed> broker_;
  std::vector<fate_t> waiting_now_;  ///< kWall: since the broker's start.
  size_t next_start_ = 0;
  size_t next_input_ = 0;
  size_t next_written_ = 0;
  size_t next_truth_ = 0;
  size_t next_written_truth_ = 0;
  size_t next_absence_ = 0;
};

}  // namespace

std::vector<BrokerAbsence> AbsencesIn(const CommsLog& log) {
  std::vector<BrokerAbsence> absences;
  if (log.fates.empty()) return absences;
  for (size_t i = 0; i < log.starts.size(); ++i) {
    const bool is_last = i + 1 == log.starts.size();
    const int64_t end_utime = is_last ? log.last_utime + 1 : log.starts[i + 1].utime;
    const auto behind = std::lower_bound(
        log.fates.begin(), log.fates.end(), end_utime,
        [](const LoggedMessage& fates, int64_t utime) { return fates.utime < utime; });
    int64_t last_word_utime = log.starts[i].rules_utime;
    if (behind != log.fates.begin()) {
      last_word_utime = std::max(last_word_utime, (behind - 1)->utime);
    }
    absences.push_back(
        {.after_utime = last_word_utime, .before_utime = end_utime, .to_the_end = is_last});
  }
  return absences;
}

RebrokerOutcome Rebroker(const CommsLog& log, const RebrokerSettings& settings,
                         const MakeBroker& make_broker, const EventSink& sink) {
  return Run(log, settings, make_broker, sink).Take();
}

}  // namespace shoal
