#include "apps/shoal/rebroker_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <utility>

#include "apps/shoal/rebroker.h"
#include "lib/check/result.h"
#include "lib/mission/load_comms.h"
#include "lib/record/log_source.h"
#include "lib/record/log_writer.h"

namespace shoal {

namespace {

/// More links than this are shown only where they differ.
constexpr size_t kMostLinksShown = 50;

std::string Seconds(int64_t utime) {
  return fmt::format("{:.3f} s", static_cast<double>(utime) / 1e6);
}

std::string Joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

/// What the command works with, as far as it has come.
class RebrokerCommand {
 public:
  RebrokerCommand(const RebrokerOptions& options, std::ostream& out, std::ostream& err)
      : options_(options), out_(out), err_(err) {}

  int Run() {
    for (const auto& step :
         {&RebrokerCommand::LoadRules, &RebrokerCommand::CheckPaths, &RebrokerCommand::ReadLogs,
          &RebrokerCommand::ChooseSetup, &RebrokerCommand::Decide}) {
      if (const int code = (this->*step)(); code != kExitOk) return code;
    }
    PrintTable();
    return ExitCode();
  }

 private:
  int Fail(int code, const std::string& why) {
    err_ << "shoal: " << why << '\n';
    return code;
  }
  void Warn(const std::string& what) { err_ << "shoal: warning: " << what << '\n'; }

  int LoadRules() {
    if (options_.comms_file.empty()) return kExitOk;
    comms_ = LoadComms(options_.comms_file);
    for (const std::string& error : comms_->errors) err_ << error << '\n';
    for (const std::string& warning : comms_->warnings) err_ << warning << '\n';
    return comms_->errors.empty() ? kExitOk : kExitUsage;
  }

  int CheckPaths() {
    if (options_.out_path.empty()) return kExitOk;
    std::error_code ignored;
    if (std::filesystem::is_directory(options_.out_path, ignored)) {
      return Fail(kExitUsage, fmt::format("--log {} is a folder; name a file", options_.out_path));
    }
    for (const std::string& path : options_.logs) {
      if (!std::filesystem::equivalent(path, options_.out_path, ignored)) continue;
      return Fail(kExitUsage, fmt::format("--log {} would overwrite the log that is read; name "
                                          "another file",
                                          options_.out_path));
    }
    return kExitOk;
  }

  int ReadLogs() {
    CommsLogBuilder builder;
    const OnDamage on_damage = options_.skip_damage ? OnDamage::kSkip : OnDamage::kStop;
    for (const std::string& path : options_.logs) {
      std::optional<LogReader> reader = OpenLog(path, on_damage, err_);
      if (!reader) return kExitEnvironment;
      builder.BeginLog();
      while (const auto event = reader->Next()) builder.Add(*event);
      is_whole_ = ReportDamage(*reader, err_) && is_whole_;
    }
    std::optional<int64_t> tick_us;
    if (comms_ && comms_->mission) tick_us = comms_->mission->tick_us;
    log_ = builder.Build(tick_us);
    if (!log_.inputs.empty()) return kExitOk;
    return Fail(is_whole_ ? kExitUsage : kExitEnvironment,
                fmt::format("{}: nothing to broker: no message on {} among {} events; the log of "
                            "the mission, or of the shore's port, is needed",
                            Joined(options_.logs),
                            channels::NodeReportLocal().name + ", " +
                                channels::NodeReportFromOutside().name +
                                " or another channel that "
                                "the broker hears",
                            log_.num_events));
  }

  /// What the log holds, and then what the user wants instead.
  int ChooseSetup() {
    if (log_.rules) {
      Result<BrokerSetup> recorded = SetupOf(*log_.rules);
      if (!recorded.ok()) return Fail(kExitUsage, Joined(options_.logs) + ": " + recorded.error());
      recorded_ = std::move(*recorded);
      setup_ = *recorded_;
    } else if (!comms_) {
      return Fail(kExitUsage,
                  fmt::format("{}: the log does not tell the rules (it holds no COMMS_RULES); give "
                              "the mission file: --comms FILE.toml",
                              Joined(options_.logs)));
    }
    if (!comms_) return kExitOk;
    setup_.rules = comms_->rules;
    if (comms_->mission) {
      const BrokerSetup of_file = SetupOf(*comms_->mission);
      setup_.factors = of_file.factors;
      if (!recorded_) setup_ = of_file;
    }
    setup_.tick_us = log_.tick_us;
    return kExitOk;
  }

  int Decide() {
    PrintLog();
    WarnOfLog();
    const bool as_recorded = !comms_ && !options_.no_controls;
    std::vector<BrokerAbsence> absences =
        recorded_ ? AbsencesIn(log_) : std::vector<BrokerAbsence>();
    if (!as_recorded && recorded_) {
      const RebrokerOutcome before =
          Rebroker(log_, {.setup = *recorded_, .with_controls = true, .absences = absences}, {});
      PrintReproduced(before);
      // By other rules there may be decisions where the recorded broker had none to make.
      absences = before.absences;
      for (BrokerAbsence& absence : absences) absence.num_decisions = 0;
    }
    std::optional<LogWriter> writer;
    EventSink sink;
    if (!options_.out_path.empty()) {
      Result<LogWriter> made = LogWriter::Create(options_.out_path);
      if (!made.ok()) return Fail(kExitEnvironment, made.error());
      writer = std::move(*made);
      sink = [&](int64_t utime, std::string_view channel, std::span<const uint8_t> data) {
        writer->Append(utime, channel, data);
        constexpr int64_t kFlushEvery = 10'000;
        if (++num_written_ % kFlushEvery == 0) (void)writer->Flush();  // Close() tells what failed.
      };
    }
    outcome_ = Rebroker(
        log_,
        {.setup = setup_, .with_controls = !options_.no_controls, .absences = std::move(absences)},
        sink);
    if (writer) {
      if (const auto error = writer->Close()) return Fail(kExitEnvironment, error->message);
    }
    if (as_recorded) PrintReproduced(outcome_);
    PrintRules();
    PrintAbsences();
    return kExitOk;
  }

  void PrintLog() {
    constexpr std::pair<LogTime, std::string_view> kTimes[] = {
        {LogTime::kMission, "mission time"},
        {LogTime::kSeals, "lcm-logger's, steps and order restored from the seals"},
        {LogTime::kWall, "lcm-logger's of a live broker, each message at its own time"}};
    std::string_view time;
    for (const auto& [value, text] : kTimes) {
      if (value == log_.time) time = text;
    }
    out_ << fmt::format("Log:      {}, {} to {}, {}\n", Joined(options_.logs),
                        Seconds(log_.first_utime), Seconds(log_.last_utime), time);
    std::map<std::string, int64_t> counts;
    for (const LoggedMessage& input : log_.inputs) ++counts[BrokerChannels()[input.channel]];
    std::vector<std::string> words;
    for (const auto& [channel, count] : counts)
      words.push_back(fmt::format("{} {}", count, channel));
    out_ << fmt::format("Heard:    {}\n", Joined(words));
    if (recorded_) {
      out_ << fmt::format("Mission:  {} vehicles, seed {}, tick {} s\n", recorded_->vehicles.size(),
                          recorded_->seed, static_cast<double>(log_.tick_us) / 1e6);
    }
    for (size_t i = 1; i < log_.starts.size(); ++i) {
      out_ << fmt::format("Restart:  the broker was started again at {} and knew nobody\n",
                          Seconds(log_.starts[i].utime));
    }
  }

  void WarnOfLog() {
    int64_t num_missing = 0;
    std::string vehicles;
    constexpr size_t kMostNamed = 10;
    for (size_t i = 0; i < log_.gaps.size(); ++i) {
      const ReportGap& gap = log_.gaps[i];
      num_missing = std::min(num_missing, INT64_MAX / 2) + gap.num_missing;
      if (i < kMostNamed) {
        vehicles += fmt::format("{}{} {} of {}", i == 0 ? "" : ", ", gap.vehicle, gap.num_missing,
                                gap.num_found + gap.num_missing);
      }
    }
    if (num_missing > 0) {
      if (log_.gaps.size() > kMostNamed) vehicles += ", ...";
      Warn(
          fmt::format("{} node reports seem to be missing, by the vehicles' own count ({}); "
                      "lcm-logger loses bursts, `shoal run --record` does not. What each report's "
                      "number decides (drop_percentage) is not reproduced",
                      num_missing, vehicles));
    }
    const auto warn_of = [this](int64_t count, std::string_view what) {
      if (count > 0) Warn(fmt::format("{} {}", count, what));
    };
    if (log_.time == LogTime::kMission) {
      warn_of(log_.num_backward, "events are earlier than the one before; sorted by time");
    }
    warn_of(log_.num_repeated, "messages are there twice; each is taken once");
    warn_of(log_.num_foreign, "messages of another mission left out");
    warn_of(log_.num_impossible, "events with a time that no mission has left out");
    warn_of(log_.num_unsealed,
            "messages from outside have no seal: their step is that of the message before");
    if (log_.tick_is_guessed) {
      Warn(fmt::format("the log does not tell the tick; {} s is a guess",
                       static_cast<double>(log_.tick_us) / 1e6));
    }
    if (!recorded_) {
      Warn(fmt::format("the log holds no COMMS_RULES: rules of {}, seed {}", options_.comms_file,
                       setup_.seed));
    } else if (log_.rules->is_start == 0) {
      Warn(fmt::format("the log does not hold the broker's start: its rules are those of {}",
                       Seconds(log_.rules->utime)));
    }
  }

  void PrintReproduced(const RebrokerOutcome& outcome) {
    const DecisionComparison& comparison = outcome.comparison;
    if (log_.fates.empty()) {
      out_ << "Recorded: no decisions (COMMS_FATES), so there is nothing to compare with\n";
      return;
    }
    out_ << fmt::format("Recorded: reproduced {} of {} decisions\n", comparison.num_reproduced(),
                        comparison.num_recorded());
    if (comparison.num_now() > comparison.num_recorded()) {
      out_ << fmt::format("          {} decisions more than the log holds\n",
                          comparison.num_now() - comparison.num_recorded());
    }
    if (!comparison.IsEqual()) {
      out_ << "          The first difference:\n" << comparison.first_difference();
    }
    if (outcome.num_undecodable > 0) {
      Warn(fmt::format("{} recorded COMMS_FATES do not decode", outcome.num_undecodable));
    }
  }

  void PrintRules() {
    const bool has_controls =
        std::any_of(log_.inputs.begin(), log_.inputs.end(), [](const LoggedMessage& input) {
          return FindControlOnChannel(BrokerChannels()[input.channel]) != nullptr;
        });
    const std::string controls = !has_controls          ? ""
                                 : options_.no_controls ? "; the recorded controls are left out"
                                                        : "; the recorded controls apply";
    out_ << fmt::format("Rules:    {}{}\n", comms_ ? options_.comms_file : "as recorded", controls);
    if (!comms_ || !recorded_) return;
    const std::vector<std::string> then = ExplainComms(recorded_->rules);
    const std::vector<std::string> now = ExplainComms(setup_.rules);
    size_t num_changed = 0;
    for (size_t i = 0; i < std::min(then.size(), now.size()); ++i) {
      if (then[i] == now[i]) continue;
      ++num_changed;
      out_ << fmt::format("          {} (was {})\n", now[i], then[i].substr(then[i].find('=') + 2));
    }
    const auto factors_of = [](const BrokerSetup& setup) {
      std::map<std::string, LinkFactors> factors;
      for (const auto& [name, value] : setup.factors) factors[name] = value;
      return factors;
    };
    std::map<std::string, LinkFactors> before = factors_of(*recorded_);
    std::map<std::string, LinkFactors> after = factors_of(setup_);
    for (const auto& [name, factors] : before) after.emplace(name, LinkFactors());
    for (const auto& [name, factors] : after) {
      if (factors == before[name]) continue;
      ++num_changed;
      out_ << fmt::format("          {}: stealth = {} (was {}), earange = {} (was {})\n", name,
                          factors.stealth, before[name].stealth, factors.earange,
                          before[name].earange);
    }
    if (num_changed == 0) out_ << "          the same as recorded\n";
  }

  void PrintAbsences() {
    for (const BrokerAbsence& absence : outcome_.absences) {
      out_ << fmt::format(
          "Away:     while the broker was away, {} to {}: {} decisions more, not "
          "counted below\n",
          Seconds(absence.after_utime),
          absence.to_the_end ? "the end" : Seconds(absence.before_utime), absence.num_decisions);
    }
    if (outcome_.num_too_early > 0) {
      out_ << fmt::format("Early:    {} messages were said before the broker began\n",
                          outcome_.num_too_early);
    }
  }

  void PrintTable() {
    const bool has_recorded = !log_.fates.empty();
    const std::string table = outcome_.links.Text(
        options_.all_links ? LinkTable::kAllLinks : kMostLinksShown, has_recorded);
    out_ << '\n' << (table.empty() ? "There was nothing to decide.\n\n" : table);
    if (!options_.out_path.empty()) {
      out_ << fmt::format("Log written: {}, {} events\n", options_.out_path, num_written_);
    }
  }

  int ExitCode() const {
    if (!is_whole_) return kExitEnvironment;
    const bool as_recorded = !comms_ && !options_.no_controls;
    const bool differs = !log_.fates.empty() && !outcome_.comparison.IsEqual();
    return as_recorded && differs ? kDecisionsDiffer : static_cast<int>(kExitOk);
  }

  const RebrokerOptions& options_;
  std::ostream& out_;
  std::ostream& err_;
  std::optional<LoadedComms> comms_;
  CommsLog log_;
  bool is_whole_ = true;  ///< The logs could be read to their ends.
  std::optional<BrokerSetup> recorded_;
  BrokerSetup setup_;
  RebrokerOutcome outcome_;
  int64_t num_written_ = 0;
};

}  // namespace

int RunRebroker(const RebrokerOptions& options, std::ostream& out, std::ostream& err) {
  return RebrokerCommand(options, out, err).Run();
}

}  // namespace shoal
