// Every row of munet/recovery.json: what a strategy makes of a damaged field. Where muNet differs
// from its documentation the file's `right_value` stands, and where that is missing the rules of
// docs/communication/swarm.md, worked out here once more.
#include <gtest/gtest.h>

#include "lib/comms/swarm/recovery.h"
#include "tests/golden/read_swarm_golden.h"

namespace shoal::recovery_golden_test {

using Json = nlohmann::json;

MessageFlag FlagOf(const Json& hex) {
  const std::vector<uint8_t> bytes = FromHex(hex.get<std::string>().substr(4));
  MessageFlag flag = {};
  for (size_t i = 0; i < flag.size(); ++i) flag[i] = static_cast<char>(bytes.at(i));
  return flag;
}

FieldValue ValueOf(SwarmField field, const Json& value) {
  switch (field) {
    case SwarmField::kType:
      return FlagOf(value);
    case SwarmField::kGroupId:
      return FromHex(value.get<std::string>().substr(4)).at(0);
    case SwarmField::kReporterId:
    case SwarmField::kNumFollowers:
      return value.get<int64_t>();
    case SwarmField::kTimeStamp:
    case SwarmField::kFollowersRspn:
    case SwarmField::kRspnStart:
      return GoldenNumber(value);
    case SwarmField::kRspnSched:
      return value.get<std::vector<int64_t>>();
    default:
      return GoldenVector(value);
  }
}

/// Same values; NaN is like NaN, and numbers may differ by rounding.
bool AreLike(const FieldValue& a, const FieldValue& b) {
  if (const auto* vector = std::get_if<Eigen::Vector3d>(&a)) {
    const auto& other = std::get<Eigen::Vector3d>(b);
    return (vector->hasNaN() && other.hasNaN()) || (*vector - other).norm() < 1e-9;
  }
  if (const auto* number = std::get_if<double>(&a)) {
    return std::abs(*number - std::get<double>(b)) < 1e-9;
  }
  return a == b;
}

std::string TextOf(const std::optional<FieldValue>& value) {
  struct Print {
    std::string operator()(const MessageFlag& flag) const { return {flag.begin(), flag.end()}; }
    std::string operator()(const Eigen::Vector3d& v) const {
      return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
    }
    std::string operator()(const std::vector<int64_t>& ids) const { return Json(ids).dump(); }
    std::string operator()(double number) const { return std::to_string(number); }
    std::string operator()(int64_t number) const { return std::to_string(number); }
    std::string operator()(uint8_t number) const { return std::to_string(number); }
  };
  return value ? std::visit(Print{}, *value) : "nothing";
}

/// The documented value of `predict` and `default` where muNet does something else and the file has
/// no `right_value`.
struct Documented {
  bool applies = false;
  std::optional<FieldValue> value;
};

Documented DocumentedPrediction(const std::string& strategy, SwarmField field,
                                const SwarmContact* contact, double clock_s) {
  using enum SwarmField;
  const bool is_position = field == kReporterPos || field == kFollowersPos || field == kLeaderPos;
  const bool is_velocity = field == kReporterVel || field == kFollowersVel || field == kLeaderVel;
  if (!contact || !(is_position || is_velocity)) return {};
  if (strategy != "predict" && strategy != "default") return {};
  const auto& log = contact->log.entries;
  if (is_position && !log.empty()) {
    const double elapsed_s = clock_s - static_cast<double>(log.back().time_us) * 1e-6;
    const Motion& last = log.back().motion;
    return {true, Eigen::Vector3d(last.position_m + last.velocity_mps * elapsed_s)};
  }
  if (is_velocity && log.size() >= 2) {
    const TimedMotion& last = log.back();
    const TimedMotion& before = log[log.size() - 2];
    const double elapsed_s = clock_s - static_cast<double>(last.time_us) * 1e-6;
    const double between_s = static_cast<double>(last.time_us - before.time_us) * 1e-6;
    const Eigen::Vector3d acceleration_mps2 =
        (last.motion.velocity_mps - before.motion.velocity_mps) / between_s;
    return {true, Eigen::Vector3d(last.motion.velocity_mps + acceleration_mps2 * elapsed_s)};
  }
  if (strategy == "predict") return {true, std::nullopt};
  return {true, is_position ? contact->report.now.position_m : contact->report.now.velocity_mps};
}

std::optional<FieldValue> ExpectedOf(const Json& row, SwarmField field, const FieldValue& bad,
                                     const Documented& documented) {
  if (row.contains("right_value")) {
    if (!row["right_ok"].get<bool>()) return std::nullopt;
    return row["right_value"] == "bad" ? bad : ValueOf(field, row["right_value"]);
  }
  if (documented.applies) return documented.value;
  // muNet's limit of 16 differing bits lets noise pass for a flag.
  if (field == SwarmField::kType && row["bad"] == "hex:00000000") return std::nullopt;
  if (!row["peer_ok"].get<bool>()) return std::nullopt;
  return ValueOf(field, row["peer_value"]);
}

TEST(Recovery, AgreesWithTheDocumentationOfMuNet) {
  const Json golden = ReadGoldenJson("munet/recovery.json");
  int num_checked = 0;
  for (const Json& row : golden["cases"]) {
    const auto field = FieldNamed(row["field"].get<std::string>());
    if (!field) continue;                      // "unknown_field": shoal's fields are a closed list.
    if (row["bad"] == "hex:4c5250") continue;  // A flag has four bytes, or there is no message.
    const Json& vehicle = golden["vehicles"][row["vehicle"].get<std::string>()];
    const GroupState state = GoldenState(vehicle);
    FieldSubject subject{.is_leader = row["kwargs"].value("isLeader", false)};
    if (row["kwargs"].contains("id")) subject.id = row["kwargs"]["id"].get<int64_t>();
    const DamagedField damaged{*field, ValueOf(*field, row["bad"]), subject};
    const RecoverySources sources{state, {}, GoldenClock_us(vehicle)};

    const std::string strategy = row["strategy"];
    std::optional<FieldValue> found;
    if (strategy == "default") {
      if (auto recovered = Recover({}, damaged, sources)) found = recovered->value;
    } else {
      found = RecoverBy(RecoveryStrategyOf(strategy).value(), damaged, sources);
    }
    const SwarmContact* contact = nullptr;
    if (subject.is_leader && state.target) contact = &*state.target;
    if (subject.id) contact = FindMember(state, *subject.id);
    const auto expected =
        ExpectedOf(row, *field, damaged.value,
                   DocumentedPrediction(strategy, *field, contact, GoldenNumber(vehicle["clock"])));
    ++num_checked;
    EXPECT_EQ(found.has_value(), expected.has_value())
        << row << "\nfound " << TextOf(found) << ", expected " << TextOf(expected);
    if (found && expected) {
      EXPECT_TRUE(AreLike(*found, *expected))
          << row << "\nfound " << TextOf(found) << ", expected " << TextOf(expected);
    }
  }
  EXPECT_EQ(num_checked, static_cast<int>(golden["cases"].size()) - 2);
}

}  // namespace shoal::recovery_golden_test
