// One part of a mission: some of its participants, stepped in this process. A mission in one
// process is a mission of one part (sim/simulation.h); where there are several, each is elsewhere,
// and they exchange a batch per step:
//
//   MissionPart part(mission, placement, rank, log_path);
//   for (each other part) part.TakeInterests(other, its Interests());        // once
//   while (!part.MustEnd()) {
//     part.Step();                                     // handlers and ticks of this part
//     for (each other part) Send(part.BatchFor(other));
//     for (each other part) part.TakeBatch(other, its batch for this part);
//     part.Decide();                                   // the same in all parts
//   }
//   part.End();
//   if (rank != 0) Send(part.FatesForFirst());          // to part 0, which
//   for (each other part) part.TakeFates(its fates);
//
// Every part steps its participants in the order of the mission, all messages have the same order
// in all parts, and what ends a mission ends it in the same step: so the log, the verdict and all
// messages are those of one process, whatever the placement.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "lib/bus/bus/memory_bus.h"
#include "lib/bus/record/channel_choice.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/app.h"
#include "lib/run/run/roster.h"
#include "lib/run/verdict/fate_tally.h"
#include "sim/part_batch.h"
#include "sim/placement.h"

namespace shoal {

class DirectorApp;

class MissionPart {
 public:
  /// Looks for faults of apps each time after this number of steps: each app is asked.
  static constexpr int64_t kStepsBetweenFaultChecks = 64;

  /// `log_path` empty: no log; the same in all parts. Look at Fault() after this.
  /// @pre CanRunInOneProcess(mission); part < placement.num_parts
  MissionPart(const Mission& mission, const Placement& placement, size_t part,
              const std::string& log_path, const ChannelChoice& log_channels = {});
  ~MissionPart();
  MissionPart(const MissionPart&) = delete;
  MissionPart& operator=(const MissionPart&) = delete;

  /// Returns which channels this part reads, for TakeInterests of the others. All subscribe before
  /// the first step.
  [[nodiscard]] Bytes Interests() const;
  /// Takes what another part reads. Returns false where it is damaged.
  /// @pre before the first step, once for each other part
  [[nodiscard]] bool TakeInterests(size_t from, std::span<const uint8_t> interests);

  /// Takes the next step: handlers of what was published in the step before, then ticks.
  /// @pre !MustEnd(), and Decide() after the step before; nothing was published before the first
  void Step();
  /// Returns what another part is to have of this step; valid until the next Step().
  [[nodiscard]] std::span<const uint8_t> BatchFor(size_t part) const;
  /// Takes the batch of another part. Returns false where it is damaged.
  [[nodiscard]] bool TakeBatch(size_t from, std::span<const uint8_t> batch);
  /// Ends the exchange of a step: all parts know the same now.
  /// @pre a batch of each other part was taken
  void Decide();
  /// True where no further step is to be taken: after the last, or for a reason that all know.
  bool MustEnd() const;

  /// All participants of this part handle what was published last, and close. Once.
  void End();
  /// Returns what the broker here has decided, for part 0. @pre End(), of another part
  [[nodiscard]] Bytes FatesForFirst() const;
  /// Takes that of another part. Returns false where it is damaged. @pre part 0
  [[nodiscard]] bool TakeFates(std::span<const uint8_t> fates);
  /// The log ends with the last step that was decided: another part is lost. Once, instead of
  /// End().
  void Abandon();

  /// Asks all parts to end the mission after the next step.
  void Interrupt() { is_interrupted_ = true; }
  /// True where a loss ends the mission.
  bool ends_by_loss() const { return news_.end_of_all.has_value(); }
  /// True where a part was interrupted.
  bool was_interrupted() const { return news_.is_interrupted; }

  /// Returns why the mission cannot go on, or an empty string. Of other parts: as of Decide().
  std::string Fault() const;
  /// Returns a line for each participant of any part that crashed and did not end the mission.
  const std::vector<std::string>& losses() const { return losses_; }

  /// The number of the last step taken, from 0; -1 before the first.
  int64_t step() const { return step_; }
  int64_t utime() const { return mission_.UtimeOf(step_); }
  const Mission& mission() const { return mission_; }
  /// Of part 0 alone: what judges the mission, and the bus of the embedding program. Else nullptr.
  const DirectorApp* director() const { return director_; }
  Bus* embedder() { return embedder_; }

 private:
  struct Member {
    uint32_t participant = 0;  ///< Its place among all of the mission.
    Bus* bus = nullptr;
    std::unique_ptr<App> app = {};          ///< Null: the embedding program, or it was lost.
    std::optional<RosterEntry> entry = {};  ///< Of those that can be started again.
    int num_restarts = 0;
  };
  struct TextHash {
    using is_transparent = void;
    size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };
  /// What this part knows of another.
  struct Other {
    bool reads_all = false;                                               ///< What is logged.
    std::unordered_set<std::string, TextHash, std::equal_to<>> channels;  ///< That it reads.
    BatchWriter writer;
    BatchReader reader;
    std::vector<uint32_t> channel_numbers;  ///< Here, by the channel's number there.
  };

  static bool Reads(const Other& other, std::string_view channel);
  bool is_shared() const { return placement_.num_parts > 1; }
  Bus* Join(const std::string& name, size_t part);
  Bus* JoinBroker(const std::string& name);
  std::unique_ptr<App> Make(const RosterEntry& entry, Bus& bus);
  void Add(Bus* bus, std::unique_ptr<App> app, std::optional<RosterEntry> entry = {});
  void TickMembers();
  void Lose(Member* member, const std::string& how);
  void WriteBatches();
  const std::vector<size_t>& ReadersOf(const MemoryBus::Published& message);
  std::optional<PartEvent> FindFault() const;

  const Mission& mission_;
  const Placement placement_;
  const size_t part_;
  MemoryBus hub_;
  uint32_t num_participants_ = 0;
  std::vector<Member> members_;
  Bus* embedder_ = nullptr;
  DirectorApp* director_ = nullptr;
  FateTally tally_;            ///< Of the broker here, where there are other parts.
  std::vector<Other> others_;  ///< By part; its own is empty.
  size_t num_interests_ = 0;   ///< Of other parts that are known.
  std::vector<std::optional<std::vector<size_t>>> readers_;  ///< Other parts, by channel.

  int64_t step_ = -1;
  bool is_interrupted_ = false;
  PartNews news_;  ///< Of the last step: of this part, after Decide() of all.
  std::vector<std::string> losses_;
};

}  // namespace shoal
