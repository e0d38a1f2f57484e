#include "lib/run/verdict/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

namespace shoal {

namespace {

constexpr size_t kMaxVehicleRows = 60;
constexpr size_t kMaxMatrixVehicles = 10;  ///< A wider matrix fits no terminal.
constexpr size_t kMaxCollisionRows = 20;
constexpr size_t kMaxGroundingRows = 20;
constexpr int kAll = FateCounts::kAll;

std::string DeliveredOfOffered(const FateCounts& fates, int source, int destination) {
  return fmt::format("{}/{}", fates.Count(source, destination, "delivered"),
                     fates.CountOffered(source, destination));
}

std::string HelmText(const Judge& judge, size_t vehicle) {
  const auto& helm = judge.helm(vehicle);
  if (!helm) return "(no helm)";
  return helm->task.empty() ? helm->state : helm->state + ":" + helm->task;
}

std::string VehicleTable(const Mission& mission, const Judge& judge) {
  std::string text = fmt::format("Vehicles\n    {:<16} {:<24} {:>10} {:>10} {:>9} {:>13}\n", "name",
                                 "helm", "x_m", "y_m", "depth_m", "travelled_m");
  const size_t num_rows = std::min(mission.vehicles.size(), kMaxVehicleRows);
  for (size_t i = 0; i < num_rows; ++i) {
    const std::string& name = mission.vehicles[i].name;
    const Sighting& sighting = judge.sighting(i);
    if (!sighting.seen) {
      text += fmt::format("    {:<16} {:<24} (never seen)\n", name, HelmText(judge, i));
      continue;
    }
    const Eigen::Vector3d& position_m = sighting.position_m;
    text += fmt::format("    {:<16} {:<24} {:>10.1f} {:>10.1f} {:>9.1f} {:>13.1f}\n", name,
                        HelmText(judge, i), position_m.x(), position_m.y(), position_m.z(),
                        judge.travelled_m(i));
  }
  if (num_rows < mission.vehicles.size()) {
    text += fmt::format("    (and {} more)\n", mission.vehicles.size() - num_rows);
  }
  return text;
}

/// Sender by receiver, where that is not too wide.
std::string LinkMatrix(const Mission& mission, const FateCounts& fates) {
  std::string text = fmt::format("    {:<16}", "from \\ to");
  for (const Vehicle& vehicle : mission.vehicles) text += fmt::format(" {:>14}", vehicle.name);
  text += "\n";
  const int count = static_cast<int>(mission.vehicles.size());
  for (int from = 0; from < count; ++from) {
    text += fmt::format("    {:<16}", mission.vehicles[static_cast<size_t>(from)].name);
    for (int to = 0; to < count; ++to) {
      text += fmt::format(" {:>14}", from == to ? "-" : DeliveredOfOffered(fates, from, to));
    }
    text += "\n";
  }
  return text;
}

/// What each vehicle sent and received in all.
std::string LinkList(const Mission& mission, const FateCounts& fates) {
  std::string text = fmt::format("    {:<16} {:>20} {:>20}\n", "name", "sent", "received");
  const size_t num_rows = std::min(mission.vehicles.size(), kMaxVehicleRows);
  for (size_t i = 0; i < num_rows; ++i) {
    const int vehicle = static_cast<int>(i);
    text += fmt::format("    {:<16} {:>20} {:>20}\n", mission.vehicles[i].name,
                        DeliveredOfOffered(fates, vehicle, kAll),
                        DeliveredOfOffered(fates, kAll, vehicle));
  }
  if (num_rows < mission.vehicles.size()) {
    text += fmt::format("    (and {} more)\n", mission.vehicles.size() - num_rows);
  }
  return text;
}

std::string LinkTable(const Mission& mission, const FateCounts& fates, std::string_view title) {
  std::string text = fmt::format("{} delivered/offered\n", title);
  text += mission.vehicles.size() <= kMaxMatrixVehicles ? LinkMatrix(mission, fates)
                                                        : LinkList(mission, fates);
  text += fmt::format("    all: {}", DeliveredOfOffered(fates, kAll, kAll));
  for (const auto& [cause, count] : fates.Totals()) {
    if (cause != "delivered") text += fmt::format(", {} {}", cause, count);
  }
  return text + "\n";
}

std::string CollisionList(const Mission& mission, const Judge& judge) {
  std::string text = fmt::format(
      "\nCollisions: {}\n", mission.collisions == CollisionVerdict::kAllowed
                                ? "allowed by [mission] collisions"
                                : "the mission fails, unless [mission] collisions = \"allowed\"");
  const size_t num_rows = std::min(judge.collisions().size(), kMaxCollisionRows);
  for (size_t i = 0; i < num_rows; ++i) {
    const auto& [collision, time_s, is_obstacle] = judge.collisions()[i];
    const std::string second = is_obstacle ? "obstacle " + mission.obstacles[collision.second].id
                                           : mission.vehicles[collision.second].name;
    text += fmt::format("    {} and {} at {:.1f} s: {:.2f} m, less than {:.2f} m\n",
                        mission.vehicles[collision.first].name, second, time_s, collision.range_m,
                        collision.allowed_m);
  }
  const int64_t num_more = judge.num_collisions() - static_cast<int64_t>(num_rows);
  if (num_more > 0) text += fmt::format("    (and {} more)\n", num_more);
  return text;
}

std::string GroundingList(const Mission& mission, const Judge& judge) {
  std::string text = fmt::format(
      "\nAground: {}\n", mission.grounding == GroundingVerdict::kAllowed
                             ? "allowed by [mission] grounding"
                             : "the mission fails, unless [mission] grounding = \"allowed\"");
  const size_t num_rows = std::min(judge.groundings().size(), kMaxGroundingRows);
  for (const GroundingFact& fact : std::span(judge.groundings()).first(num_rows)) {
    text += fmt::format("    {}\n", GroundingText(mission, fact));
  }
  const int64_t num_more = judge.num_groundings() - static_cast<int64_t>(num_rows);
  if (num_more > 0) text += fmt::format("    (and {} more)\n", num_more);
  return text;
}

}  // namespace

std::string GroundingText(const Mission& mission, const GroundingFact& fact) {
  const Vehicle& vehicle = mission.vehicles[fact.vehicle];
  const double draught_m = DraughtOf(vehicle);
  return fmt::format("{} ran aground at {:.1f} s at ({:.1f}, {:.1f}): {}, the floor at {:.1f} m",
                     vehicle.name, fact.time_s, fact.position_m.x(), fact.position_m.y(),
                     draught_m > 0 ? fmt::format("draught {:g} m", draught_m)
                                   : fmt::format("{:.1f} m deep", fact.position_m.z()),
                     fact.floor_m);
}

std::string FailuresOf(const Mission& mission, const Judge& judge) {
  const std::vector<ExpectationVerdict> verdicts = judge.Verdicts();
  const auto num_missed = std::count_if(verdicts.begin(), verdicts.end(),
                                        [](const auto& verdict) { return !verdict.passed; });
  std::string text;
  if (num_missed > 0)
    text = fmt::format("{} of {} expectations missed", num_missed, verdicts.size());
  const auto add = [&](int64_t count, std::string_view what) {
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, what, count == 1 ? "" : "s");
  };
  if (judge.num_collisions() > 0 && mission.collisions == CollisionVerdict::kFail) {
    add(judge.num_collisions(), "collision");
  }
  if (judge.num_groundings() > 0 && mission.grounding == GroundingVerdict::kFail) {
    add(judge.num_groundings(), "grounding");
  }
  return text;
}

std::string Summarize(const Mission& mission, const Judge& judge, bool complete) {
  std::string text = VehicleTable(mission, judge) + "\n" +
                     LinkTable(mission, judge.tally().fates(Kind::kReport), "Reports");
  for (const auto& [kind, title] :
       {std::pair(Kind::kMessage, "Messages"), std::pair(Kind::kAck, "Acks"),
        std::pair(Kind::kPacket, "Packets")}) {
    const FateCounts& fates = judge.tally().fates(kind);
    if (fates.CountOffered(kAll, kAll) > 0) text += "\n" + LinkTable(mission, fates, title);
  }
  if (!judge.tally().acoustic().IsEmpty()) text += "\n" + judge.tally().acoustic().Text();
  if (judge.num_collisions() > 0) text += CollisionList(mission, judge);
  if (judge.num_groundings() > 0) text += GroundingList(mission, judge);
  const std::vector<ExpectationVerdict> verdicts = judge.Verdicts();
  if (!verdicts.empty()) text += "\nExpectations\n";
  for (const ExpectationVerdict& verdict : verdicts) {
    text += fmt::format("    {} {}: {} [{}]\n", verdict.passed ? "pass" : "FAIL", verdict.text,
                        verdict.numbers, verdict.where);
  }
  if (!complete) return text + "\nINCOMPLETE: the mission did not run to its end\n";
  const std::vector<std::string> warnings = judge.Warnings();
  if (!warnings.empty()) text += "\nWarnings\n";
  for (const std::string& warning : warnings) text += fmt::format("    {}\n", warning);
  const std::string failures = FailuresOf(mission, judge);
  return text + (failures.empty() ? "\nPASS\n" : fmt::format("\nFAIL: {}\n", failures));
}

}  // namespace shoal
