#include "apps/shoal_rebroker/rebroker_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>
#include <utility>

#include "lib/base/check/result.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/log_writer.h"
#include "lib/mission/file/load_comms.h"
#include "lib/sea/acoustics/validate_options.h"
#include "lib/tools/rebroker/outside_inputs.h"
#include "lib/tools/rebroker/rebroker.h"
#include "lib/tools/rebroker/rebroker_text.h"
#include "sim/app_factory.h"

namespace shoal {

namespace {

/// More links than this are shown only where they differ.
constexpr size_t kMaxLinksShown = 50;

std::string LogNames(const std::vector<std::string>& logs) {
  return fmt::format("{}", fmt::join(logs, ", "));
}

/// The state of the command while it runs.
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
                            LogNames(options_.logs),
                            channels::NodeReportLocal().name + ", " +
                                channels::NodeReportFromOutside().name +
                                " or another channel that "
                                "the broker subscribes to",
                            log_.num_events));
  }

  /// Sets the rules: those of the log, then those of the user.
  int ChooseSetup() {
    if (log_.rules) {
      Result<BrokerSetup> recorded = SetupOf(*log_.rules);
      if (!recorded.ok())
        return Fail(kExitUsage, LogNames(options_.logs) + ": " + recorded.error());
      recorded_ = std::move(*recorded);
      setup_ = *recorded_;
    } else if (!comms_) {
      return Fail(kExitUsage,
                  fmt::format("{}: the log does not hold the rules (no COMMS_RULES); give "
                              "the mission file: --comms FILE.toml",
                              LogNames(options_.logs)));
    }
    if (!comms_) return kExitOk;
    setup_.rules = comms_->rules;
    if (comms_->acoustics) setup_.media.acoustics = *comms_->acoustics;
    if (comms_->mission) {
      const BrokerSetup of_file = SetupOf(*comms_->mission);
      setup_.factors = of_file.factors;
      setup_.media = of_file.media;
      setup_.floor = of_file.floor;
      setup_.arrivals = of_file.arrivals;
      setup_.nodes = of_file.nodes;
      if (!recorded_) setup_ = of_file;
    }
    setup_.tick_us = log_.tick_us;
    for (const Acoustics* network : setup_.media.Networks()) {
      const std::string missing = setup_.MissingOf(*network);
      if (missing.empty()) continue;
      return Fail(kExitUsage, fmt::format("{}: [acoustics] {}: --comms FILE.toml",
                                          LogNames(options_.logs), missing));
    }
    if (!setup_.media.acoustics.is_used) return kExitOk;
    for (const OptionProblem& problem :
         FindProblems(setup_.media.acoustics.options, setup_.nodes)) {
      return Fail(kExitUsage, fmt::format("{}: the vehicles of the log find no room: [acoustics] "
                                          "{}: {}",
                                          options_.comms_file, problem.option, problem.message));
    }
    return kExitOk;
  }

  int Decide() {
    out_ << LogText(options_.logs, log_, recorded_);
    WarnOfLog();
    std::vector<BrokerAbsence> absences =
        recorded_ ? AbsencesIn(log_) : std::vector<BrokerAbsence>();
    if (recorded_) {
      RebrokerOutcome before = DecideAsRecorded(absences);
      out_ << ReproducedText(log_, before);
      if (AsRecorded() && options_.out_path.empty()) {
        outcome_ = std::move(before);
        PrintRules();
        return kExitOk;
      }
      // With other rules there may be decisions that the recorded broker did not make.
      absences = before.absences;
      for (BrokerAbsence& absence : absences) absence.num_decisions = 0;
    }
    std::optional<LogWriter> writer;
    EventSink sink;
    if (!options_.out_path.empty()) {
      Result<LogWriter> made = LogWriter::Create(options_.out_path);
      if (!made.ok()) return Fail(kExitEnvironment, made.error());
      writer.emplace(std::move(*made));
      sink = [&](int64_t utime, std::string_view channel, std::span<const uint8_t> data) {
        writer->Append(utime, channel, data);
        constexpr int64_t kFlushEvery = 10'000;
        if (++num_written_ % kFlushEvery == 0) (void)writer->Flush();  // Close() returns the error.
      };
    }
    outcome_ = Rebroker(
        log_,
        {.setup = setup_, .with_controls = !options_.no_controls, .absences = std::move(absences)},
        MakeShoreBroker, sink);
    if (writer) {
      if (const auto error = writer->Close()) return Fail(kExitEnvironment, error->message);
    }
    PrintRules();
    return kExitOk;
  }

  /// Decides by the recorded rules, and moves what came from outside to its step.
  RebrokerOutcome DecideAsRecorded(const std::vector<BrokerAbsence>& absences) {
    const RebrokerSettings settings = {
        .setup = *recorded_, .with_controls = true, .absences = absences};
    RebrokerOutcome outcome = Rebroker(log_, settings, MakeShoreBroker, {});
    if (log_.fates.empty() || outcome.comparison.IsEqual()) return outcome;
    CommsLog moved = log_;
    const int64_t num_moved = MoveToTheStepsOfTheBroker(&moved);
    if (num_moved == 0) return outcome;
    RebrokerOutcome better = Rebroker(moved, settings, MakeShoreBroker, {});
    if (better.comparison.num_reproduced() <= outcome.comparison.num_reproduced()) return outcome;
    out_ << fmt::format(
        "Outside:  {} messages from outside moved by a step, to where the broker "
        "handled them\n",
        num_moved);
    log_ = std::move(moved);
    return better;
  }

  void WarnOfLog() {
    for (const std::string& warning : WarningsOf(log_)) Warn(warning);
    if (recorded_) return;
    Warn(fmt::format("the log holds no COMMS_RULES: rules of {}, seed {}", options_.comms_file,
                     setup_.seed));
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
    if (comms_ && recorded_) out_ << ChangesText(*recorded_, setup_);
    out_ << AbsencesText(log_, outcome_);
  }

  void PrintTable() {
    const bool has_recorded = !log_.fates.empty();
    const std::string table = outcome_.links.Text(
        options_.all_links ? LinkTable::kAllLinks : kMaxLinksShown, has_recorded);
    out_ << '\n' << (table.empty() ? "There was nothing to decide.\n\n" : table);
    if (!options_.out_path.empty()) {
      out_ << fmt::format("Log written: {}, {} events\n", options_.out_path, num_written_);
    }
  }

  bool AsRecorded() const { return !comms_ && !options_.no_controls; }

  int ExitCode() const {
    if (!is_whole_) return kExitEnvironment;
    const bool differs = !log_.fates.empty() && !outcome_.comparison.IsEqual();
    return AsRecorded() && differs ? kDecisionsDiffer : static_cast<int>(kExitOk);
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
