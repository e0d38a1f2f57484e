#include "lib/comms/swarm/field_checks.h"

#include <gtest/gtest.h>

#include <set>

#include "lib/base/time/seconds.h"
#include "tests/golden/read_swarm_golden.h"

namespace shoal::field_checks_test {

constexpr FieldLimits kLimits;
constexpr int64_t kNow_us = 16'020'000;

std::vector<double> NumbersOf(const nlohmann::json& data) {
  std::vector<double> numbers;
  for (const nlohmann::json& number : data) numbers.push_back(GoldenNumber(number));
  return numbers;
}

FieldFault VerdictOf(const nlohmann::json& row) {
  const std::string kind = row["expType"];
  const nlohmann::json& data = row["data"];
  std::optional<uint32_t> own_id;
  if (row["kwargs"].contains("uid")) own_id = row["kwargs"]["uid"].get<uint32_t>();
  if (kind == "type") return CheckType(FromHex(data));
  if (kind == "group_id") return CheckGroupId(FromHex(data));
  if (kind == "reporter_id") return CheckReporterId(data, own_id, kLimits);
  if (kind == "num_followers") return CheckNumFollowers(data, kLimits);
  if (kind == "int") return CheckInteger(data);
  if (kind == "rspn_sched") return CheckSchedule(std::vector<int64_t>(data), own_id, kLimits);
  if (kind == "float") return CheckNumbers(std::vector{GoldenNumber(data)});
  if (kind == "float_array") return CheckNumbers(NumbersOf(data));
  if (kind == "position") return CheckPosition(NumbersOf(data), kLimits);
  if (kind == "velocity") return CheckVelocity(NumbersOf(data), kLimits);
  EXPECT_EQ(kind, "timestamp");
  return CheckTimeStamp(GoldenNumber(data), std::nullopt, kLimits);
}

TEST(FieldChecks, JudgeAsMuNetsDocumentationDoes) {
  std::set<std::string> kinds;
  for (const nlohmann::json& row : ReadGoldenJson("munet/data_is_corrupted.json")) {
    kinds.insert(row["expType"]);
    EXPECT_EQ(VerdictOf(row) != FieldFault::kNone, row["right"].get<bool>()) << row;
  }
  EXPECT_EQ(kinds.size(), 11U);
}

TEST(FieldChecks, HaveAReasonInWordsForEachFault) {
  std::set<std::string_view> texts;
  for (size_t i = 0; i < kNumFieldFaults; ++i) texts.insert(TextOf(static_cast<FieldFault>(i)));
  EXPECT_EQ(texts.size(), kNumFieldFaults);
  EXPECT_FALSE(texts.contains(""));
}

TEST(PositionCheck, KnowsRangeFromNonsense) {
  EXPECT_EQ(CheckPosition(std::vector{1e5, -1e5, 0.0}, kLimits), FieldFault::kNone);
  EXPECT_EQ(CheckPosition(std::vector{0.0, std::nextafter(1e5, 2e5), 0.0}, kLimits),
            FieldFault::kTooFar);
  EXPECT_EQ(CheckPosition(std::vector{0.0, 0.0, std::nan("")}, kLimits), FieldFault::kNotFinite);
  EXPECT_EQ(CheckPosition(std::vector{0.0, 0.0}, kLimits), FieldFault::kWrongLength);
}

TEST(VelocityCheck, KnowsSpeedFromNonsense) {
  EXPECT_EQ(CheckVelocity(std::vector{100.0, -100.0, 0.0}, kLimits), FieldFault::kNone);
  EXPECT_EQ(CheckVelocity(std::vector{0.0, 0.0, -100.01}, kLimits), FieldFault::kTooFast);
  EXPECT_EQ(CheckVelocity(std::vector{1.0, 2.0, 3.0, 4.0}, kLimits), FieldFault::kWrongLength);
}

TEST(ReporterIdCheck, DoesNotLetAVehicleReportToItself) {
  EXPECT_EQ(CheckReporterId(3, 3, kLimits), FieldFault::kOwnId);
  EXPECT_EQ(CheckReporterId(1003, 3, kLimits), FieldFault::kNone);
  EXPECT_EQ(CheckReporterId(1004, 3, kLimits), FieldFault::kFarFromOwnId);
  EXPECT_EQ(CheckReporterId(INT64_MIN, 3, kLimits), FieldFault::kOutsideIntegers);
}

TEST(TimeStampCheck, MayBeZeroButNotNegative) {
  EXPECT_EQ(CheckTimeStamp(0, kNow_us, kLimits), FieldFault::kNone);
  EXPECT_EQ(CheckTimeStamp(-1e-6, kNow_us, kLimits), FieldFault::kNegativeTime);
  EXPECT_EQ(CheckTimeStamp(1e6, std::nullopt, kLimits), FieldFault::kTooLate);
}

TEST(TimeStampCheck, RefusesReportsFromTheFuture) {
  EXPECT_EQ(CheckTimeStamp(16.02, kNow_us, kLimits), FieldFault::kNone);
  EXPECT_EQ(CheckTimeStamp(16.13, kNow_us, kLimits), FieldFault::kFromTheFuture);
  EXPECT_EQ(CheckTimeStamp(16.13, std::nullopt, kLimits), FieldFault::kNone);
}

TEST(TimeStampCheck, ForgivesWhatFloat32RoundsAtTheLongestTime) {
  const double sent_s = 999'999.97;
  const auto wire_s = static_cast<float>(sent_s);
  ASSERT_GT(double{wire_s}, sent_s);
  const FieldLimits longer{.max_time_s = 2e6};
  EXPECT_EQ(CheckTimeStamp(wire_s, Microseconds(sent_s), longer), FieldFault::kNone);
}

TEST(ResponseStartCheck, WantsATimeThatIsStillToCome) {
  EXPECT_EQ(CheckResponseStart(16.02, kNow_us, kLimits), FieldFault::kNone);
  EXPECT_EQ(CheckResponseStart(16.01, kNow_us, kLimits), FieldFault::kInThePast);
  EXPECT_EQ(CheckResponseStart(16.01, std::nullopt, kLimits), FieldFault::kNone);
  EXPECT_EQ(CheckResponseStart(-1, std::nullopt, kLimits), FieldFault::kNegativeTime);
}

TEST(ResponseStartCheck, TakesALateStartIfTheMissionAllowsIt) {
  const FieldLimits lenient{.late_start_us = 2'000'000};
  EXPECT_EQ(CheckResponseStart(14.02, kNow_us, lenient), FieldFault::kNone);
  EXPECT_EQ(CheckResponseStart(14.01, kNow_us, lenient), FieldFault::kInThePast);
}

}  // namespace shoal::field_checks_test
