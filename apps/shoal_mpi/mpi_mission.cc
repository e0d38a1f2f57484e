#include "apps/shoal_mpi/mpi_mission.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>

#include "apps/shoal_mpi/rank_exchange.h"
#include "lib/base/check/check.h"
#include "lib/base/time/seconds.h"
#include "lib/mission/file/drawn_seed.h"
#include "lib/mission/file/print_errors.h"
#include "lib/run/command_line/build_facts.h"
#include "lib/run/run/log_plan.h"
#include "lib/run/run/run_app.h"
#include "lib/tools/campaign/digest.h"
#include "sim/director_app.h"
#include "sim/mission_part.h"
#include "sim/sim_ending.h"
#include "sim/simulation.h"

namespace shoal {

namespace {

std::atomic<bool> was_interrupted = false;

/// Ends this rank's part early, with this exit code.
struct EarlyEnd {
  int exit_code = kExitOk;
};

std::span<const uint8_t> BytesOf(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

std::string TextOf(std::span<const uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

/// Takes the text up to the next '\n' off the front.
std::string TakeLine(std::string* text) {
  const size_t end = std::min(text->find('\n'), text->size());
  std::string line = text->substr(0, end);
  text->erase(0, end + 1);
  return line;
}

/// The mission of one rank, from its start to its end.
class RankMission {
 public:
  explicit RankMission(const MpiOptions& options)
      : options_(options),
        ranks_({.give_up_after_s = options.give_up_after_s,
                .is_interrupted = [] { return was_interrupted.load(); }}) {}

  int Run() {
    std::optional<EarlyEnd> end = Meet();
    if (!end) end = Load();
    if (!end) end = Place();
    if (!end) end = Open();
    if (!end) end = TakeSteps();
    return end ? end->exit_code : Conclude();
  }

 private:
  bool is_first() const { return ranks_.rank() == 0; }

  /// Prints an error of all ranks once.
  EarlyEnd Refuse(int exit_code, const std::string& error) const {
    if (is_first()) fmt::print(stderr, "shoal-mpi: {}\n", error);
    return {exit_code};
  }

  /// Ends the job: a rank is lost.
  [[noreturn]] void GiveUp(const Error& error) {
    if (part_) part_->Abandon();
    fmt::print(stderr, "shoal-mpi: {}\n", error.message);
    if (part_ && is_first() && !options_.log_path.empty()) {
      fmt::print(stderr, "shoal-mpi: {} holds the mission up to step {}\n", options_.log_path,
                 part_->step() - 1);
    }
    ranks_.Abort(kExitEnvironment);
  }

  /// Gives all ranks this text, and returns theirs by rank, its own included.
  std::vector<std::string> Share(const std::string& what, const std::string& text) {
    const std::vector<std::span<const uint8_t>> outgoing(ranks_.num_ranks(), BytesOf(text));
    if (const auto lost = ranks_.Round(what, outgoing, &incoming_)) GiveUp(*lost);
    std::vector<std::string> texts;
    for (const Bytes& bytes : incoming_) texts.push_back(TextOf(bytes));
    texts[ranks_.rank()] = text;
    return texts;
  }

  std::optional<EarlyEnd> Meet();
  std::optional<EarlyEnd> Load();
  std::optional<EarlyEnd> Place();
  std::optional<EarlyEnd> Open();
  std::optional<EarlyEnd> TakeSteps();
  void ExchangeBatches();
  void GatherFates();
  int Conclude();
  void ShowRanks() const;
  void ShowTimes(const std::vector<std::string>& reports) const;

  const MpiOptions& options_;
  RankExchange ranks_;
  std::vector<std::string> overrides_ = {};
  LoadedMission loaded_ = {};
  Placement placement_ = {};
  std::optional<MissionPart> part_ = {};
  std::vector<Bytes> incoming_ = {};
  std::vector<std::span<const uint8_t>> outgoing_ = {};
  int64_t begin_us_ = 0;
  int64_t exchanging_us_ = 0;  ///< Processor time.
  int64_t stepping_us_ = 0;    ///< Processor time of all steps, without exchanging.
  double setup_s_ = 0;
};

/// Rank 0 draws the seed where the mission wants one; all must be builds that can work together.
std::optional<EarlyEnd> RankMission::Meet() {
  const char* tasks = std::getenv("SLURM_STEP_NUM_TASKS");
  if (ranks_.num_ranks() == 1 && tasks != nullptr && std::atoi(tasks) > 1) {
    fmt::print(stderr,
               "shoal-mpi: srun started {} tasks that do not know of each other: use srun "
               "--mpi=pmix, or mpirun within the job\n",
               tasks);
    return EarlyEnd{kExitEnvironment};
  }
  begin_us_ = MonotonicMicroseconds();
  overrides_ = options_.overrides;
  if (is_first()) loaded_ = LoadMissionToRun(options_.mission_file, DrawSeed, &overrides_);
  const std::string drawn =
      overrides_.size() > options_.overrides.size() ? overrides_.back() : std::string();
  char host[256] = {};
  gethostname(host, sizeof host - 1);
  const BuildFacts own = OwnBuild();
  std::vector<std::string> answers =
      Share("the start", fmt::format("{}\n{}\n{}\n{}\n{}\n{}", host, getpid(), own.version,
                                     own.build, own.arithmetic, drawn));
  std::vector<RankPlace> places;
  for (size_t rank = 0; rank < answers.size(); ++rank) {
    std::string& answer = answers[rank];
    RankPlace place = {.host = TakeLine(&answer)};
    place.pid = static_cast<pid_t>(std::atol(TakeLine(&answer).c_str()));
    places.push_back(std::move(place));
    BuildFacts its = {.version = TakeLine(&answer)};
    its.build = TakeLine(&answer);
    its.arithmetic = TakeLine(&answer);
    const std::string why = WhyNotTogether(its, own);
    if (why.empty()) continue;
    return Refuse(kExitEnvironment,
                  fmt::format("rank {} on host {}: {}", rank, places.back().host, why));
  }
  ranks_.SetPlaces(std::move(places));
  const std::string from_first = TakeLine(&answers[0]);
  if (!is_first()) {
    if (!from_first.empty()) overrides_.push_back(from_first);
    loaded_ = LoadMissionToRun(options_.mission_file, DrawSeed, &overrides_);
  } else if (!from_first.empty()) {
    fmt::print("Drawn: --set {}\n", from_first);
    std::fflush(stdout);
  }
  return std::nullopt;
}

/// All must have the same mission.
std::optional<EarlyEnd> RankMission::Load() {
  const std::string digest = loaded_.errors.empty()
                                 ? Digest().Add(Explain(loaded_.mission)).Hex(32)
                                 : fmt::format("{}", fmt::join(loaded_.errors, "\n"));
  const std::vector<std::string> digests = Share("loading the mission", digest);
  if (is_first() && !LoadedWithoutErrors(loaded_)) return EarlyEnd{kExitUsage};
  for (size_t rank = 1; rank < digests.size(); ++rank) {
    if (digests[rank] == digests[0]) continue;
    return Refuse(kExitUsage,
                  fmt::format("{}: {} loads another mission than rank 0; the file, and what it "
                              "includes, must be the same on every host{}{}",
                              options_.mission_file, ranks_.NameOf(rank),
                              digests[rank].size() == digests[0].size() ? "" : ":\n",
                              digests[rank].size() == digests[0].size() ? "" : digests[rank]));
  }
  if (!loaded_.errors.empty()) return EarlyEnd{kExitUsage};
  if (const auto can = CanRunInOneProcess(loaded_.mission); !can.ok()) {
    return Refuse(kExitUsage, can.error());
  }
  if (!options_.log_channels.TakesAll() && options_.log_path.empty()) {
    return Refuse(kExitUsage, "--channels and --without need --log FILE: they are of that log");
  }
  if (std::error_code error; std::filesystem::is_directory(options_.log_path, error)) {
    return Refuse(kExitUsage, fmt::format("--log {} is a folder; name a file", options_.log_path));
  }
  return std::nullopt;
}

std::optional<EarlyEnd> RankMission::Place() {
  Result<Placement> placement = MakePlacement(loaded_.mission, ranks_.num_ranks(), options_.placed);
  if (!placement.ok()) return Refuse(kExitUsage, placement.error());
  placement_ = std::move(*placement);
  if (is_first() && !options_.quiet) ShowRanks();
  return std::nullopt;
}

std::optional<EarlyEnd> RankMission::Open() {
  if (is_first() && !options_.log_path.empty()) {
    const LogPlan plan = PlanLog(loaded_.mission, options_.log_channels, options_.log_path);
    for (const std::string& warning : plan.warnings) {
      fmt::print(stderr, "shoal-mpi: {}\n", warning);
    }
  }
  part_.emplace(loaded_.mission, placement_, ranks_.rank(), options_.log_path,
                options_.log_channels);
  const std::vector<std::string> faults = Share("opening the log", part_->Fault());
  for (const std::string& fault : faults) {
    if (!fault.empty()) return Refuse(kExitEnvironment, fault);
  }
  const std::vector<std::string> interests = Share("the subscriptions", TextOf(part_->Interests()));
  for (size_t rank = 0; rank < interests.size(); ++rank) {
    if (rank == ranks_.rank()) continue;
    if (!part_->TakeInterests(rank, BytesOf(interests[rank]))) {
      GiveUp({fmt::format("the subscriptions of {} are damaged", ranks_.NameOf(rank))});
    }
  }
  outgoing_.resize(ranks_.num_ranks());
  return std::nullopt;
}

std::optional<EarlyEnd> RankMission::TakeSteps() {
  setup_s_ = Seconds(MonotonicMicroseconds() - begin_us_);
  ranks_.ResetTotals();
  begin_us_ = MonotonicMicroseconds();
  const int64_t processor_begin_us = ProcessorMicroseconds();
  while (!part_->MustEnd()) {
    if (was_interrupted) part_->Interrupt();
    part_->Step();
    if (ranks_.num_ranks() > 1) ExchangeBatches();
    part_->Decide();
  }
  part_->End();
  if (ranks_.num_ranks() > 1) GatherFates();
  stepping_us_ = ProcessorMicroseconds() - processor_begin_us - exchanging_us_;
  return std::nullopt;
}

void RankMission::ExchangeBatches() {
  for (size_t rank = 0; rank < ranks_.num_ranks(); ++rank) {
    if (rank != ranks_.rank()) outgoing_[rank] = part_->BatchFor(rank);
  }
  const int64_t begin_us = ProcessorMicroseconds();
  const auto lost = ranks_.Round(fmt::format("step {}", part_->step()), outgoing_, &incoming_);
  if (lost) GiveUp(*lost);
  exchanging_us_ += ProcessorMicroseconds() - begin_us;
  for (size_t rank = 0; rank < ranks_.num_ranks(); ++rank) {
    if (rank == ranks_.rank() || part_->TakeBatch(rank, incoming_[rank])) continue;
    GiveUp(
        {fmt::format("step {}: what {} has sent is damaged", part_->step(), ranks_.NameOf(rank))});
  }
}

/// Each rank has counted what its part of the broker decided: rank 0 judges by all of it.
void RankMission::GatherFates() {
  const Bytes fates = is_first() ? Bytes() : part_->FatesForFirst();
  std::ranges::fill(outgoing_, std::span<const uint8_t>());
  outgoing_[0] = fates;
  if (const auto lost = ranks_.Round("the fates", outgoing_, &incoming_)) GiveUp(*lost);
  for (size_t rank = 1; rank < ranks_.num_ranks() && is_first(); ++rank) {
    if (part_->TakeFates(incoming_[rank])) continue;
    GiveUp({fmt::format("the fates that {} has counted are damaged", ranks_.NameOf(rank))});
  }
}

/// Rank 0 prints what `shoal sim` prints; all end with its exit code.
int RankMission::Conclude() {
  const double wall_s = Seconds(MonotonicMicroseconds() - begin_us_);
  const auto num_vehicles = std::ranges::count(placement_.part_of_vehicle, ranks_.rank());
  std::string report = fmt::format(
      "{} vehicles; {:.3f} s of set-up; {:.3f} s of {} steps, of which {:.3f} s exchanging; {:.3f} "
      "s "
      "of processor stepping; {} bytes sent",
      num_vehicles, setup_s_, wall_s, part_->step() + 1, ranks_.totals().wait_s,
      Seconds(stepping_us_), ranks_.totals().bytes_sent);
  int exit_code = kExitOk;
  if (is_first()) {
    const size_t num_ranks = ranks_.num_ranks();
    exit_code =
        PrintEnding({.mission = part_->mission(),
                     .director = *part_->director(),
                     .step = part_->step(),
                     .wall_s = wall_s,
                     .where = num_ranks == 1 ? "1 rank" : fmt::format("{} ranks", num_ranks),
                     .log_path = options_.log_path,
                     .losses = part_->losses(),
                     .fault = part_->Fault(),
                     .was_interrupted = part_->was_interrupted()});
    std::fflush(stdout);
  }
  report = fmt::format("{}\n{}", exit_code, report);
  std::vector<std::string> reports = Share("the end", report);
  exit_code = std::atoi(TakeLine(&reports[0]).c_str());
  if (is_first() && options_.shows_times) ShowTimes(reports);
  return exit_code;
}

void RankMission::ShowRanks() const {
  for (size_t rank = 0; rank < ranks_.num_ranks(); ++rank) {
    const auto num_vehicles = std::ranges::count(placement_.part_of_vehicle, rank);
    const bool is_whole = placement_.part_of_block.empty();
    const bool has_broker = is_whole ? rank == placement_.broker_part
                                     : std::ranges::count(placement_.part_of_block, rank) > 0;
    fmt::print("{}: {} vehicle{}{}{}\n", ranks_.NameOf(rank), num_vehicles,
               num_vehicles == 1 ? "" : "s", rank == 0 ? ", verdict" : "",
               !has_broker ? "" : (is_whole ? ", broker" : ", part of the broker"));
  }
  std::fflush(stdout);
}

void RankMission::ShowTimes(const std::vector<std::string>& reports) const {
  for (size_t rank = 0; rank < reports.size(); ++rank) {
    std::string report = reports[rank];
    if (rank > 0) TakeLine(&report);
    fmt::print(stderr, "rank {}: {}\n", rank, report);
  }
}

}  // namespace

int RunMpiMission(const MpiOptions& options) {
  signal(SIGINT, [](int) { was_interrupted = true; });
  signal(SIGTERM, [](int) { was_interrupted = true; });
  return RankMission(options).Run();
}

}  // namespace shoal
