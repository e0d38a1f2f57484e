#include "lib/moos/node_report_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace shoal {
namespace {

constexpr std::string_view kMinimal = "NAME=alpha,X=5,Y=-20,SPD=1.5,HDG=90,TIME=12.3";

node_report_t Parsed(std::string_view text, const LocalFrame* frame = nullptr) {
  auto report = ParseNodeReport(text, frame);
  EXPECT_TRUE(report.ok()) << (report.ok() ? "" : report.error());
  return report.ok() ? *report : node_report_t{};
}

std::string ErrorOf(std::string_view text, const LocalFrame* frame = nullptr) {
  const auto report = ParseNodeReport(text, frame);
  return report.ok() ? "" : report.error();
}

std::string With(std::string_view fields) {
  return std::string(kMinimal) + "," + std::string(fields);
}

using Extra = std::vector<std::pair<std::string, std::string>>;

Extra ExtraOf(const node_report_t& report) {
  EXPECT_EQ(report.num_extra, static_cast<int32_t>(report.extra.size()));
  Extra extra;
  for (const key_value_t& field : report.extra) extra.emplace_back(field.key, field.value);
  return extra;
}

std::vector<uint8_t> Bytes(const node_report_t& report) {
  std::vector<uint8_t> bytes(static_cast<size_t>(report.getEncodedSize()));
  report.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

TEST(ParseNodeReport, ReadsWhatMoosWrites) {
  const node_report_t report = Parsed(
      "NAME=alpha,X=51.71,Y=-35.5,SPD=2,HDG=118.85,COG=119,DEP=4.2,LAT=43.825089,LON=-70.330305,"
      "TYPE=UUV,COLOR=red,GROUP=survey,MODE=MODE@ACTIVE:LOITERING,ALLSTOP=clear,ALTITUDE=10,"
      "SPD_OG=2.1,INDEX=36,TIME=1252348077.59,LENGTH=4,YAW=1.2,TRAJECTORY={1,2:3,4}");
  EXPECT_EQ(report.name, "alpha");
  EXPECT_EQ(report.x_m, 51.71);
  EXPECT_EQ(report.y_m, -35.5);
  EXPECT_EQ(report.speed_mps, 2);
  EXPECT_EQ(report.heading_deg, 118.85);
  EXPECT_EQ(report.course_over_ground_deg, 119);
  EXPECT_EQ(report.depth_m, 4.2);
  EXPECT_EQ(report.lat_deg, 43.825089);
  EXPECT_EQ(report.lon_deg, -70.330305);
  EXPECT_EQ(report.type, "UUV");
  EXPECT_EQ(report.color, "red");
  EXPECT_EQ(report.group, "survey");
  EXPECT_EQ(report.mode, "MODE@ACTIVE:LOITERING");
  EXPECT_EQ(report.all_stop, "clear");
  EXPECT_EQ(report.altitude_m, 10);
  EXPECT_EQ(report.speed_over_ground_mps, 2.1);
  EXPECT_EQ(report.index, 36);
  EXPECT_EQ(report.utime, 1'252'348'077'590'000);
  EXPECT_EQ(report.length_m, 4);
  EXPECT_EQ(ExtraOf(report), (Extra{{"YAW", "1.2"}, {"TRAJECTORY", "{1,2:3,4}"}}));
}

TEST(ParseNodeReport, ReadsJsonAsWell) {
  const node_report_t report =
      Parsed(R"({"NAME":"alpha","X":5,"Y":"-20","SPD":1.5,"HDG":90,"TIME":1252348077.590001,)"
             R"("ALLSTOP":"a, b","VSOURCE":{"a":[1,2]}})");
  EXPECT_EQ(report.name, "alpha");
  EXPECT_EQ(report.y_m, -20);
  EXPECT_EQ(report.utime, 1'252'348'077'590'001);
  EXPECT_EQ(report.all_stop, "a, b");
  EXPECT_EQ(ExtraOf(report), (Extra{{"VSOURCE", R"({"a":[1,2]})"}}));
}

TEST(ParseNodeReport, FillsInWhatIsAbsent) {
  const node_report_t report = Parsed(kMinimal);
  EXPECT_EQ(report.depth_m, 0);
  EXPECT_EQ(report.altitude_m, -1);
  EXPECT_EQ(report.speed_over_ground_mps, 1.5);
  EXPECT_EQ(report.course_over_ground_deg, 90);
  EXPECT_EQ(report.index, 0);
  EXPECT_EQ(report.length_m, 0);
  EXPECT_EQ(report.lat_deg, 0);
  EXPECT_EQ(report.group, "");
}

TEST(ParseNodeReport, TakesOtherNamesWhereTheUsualOneIsAbsent) {
  EXPECT_EQ(Parsed(With("HDG_OG=80")).course_over_ground_deg, 80);
  EXPECT_EQ(Parsed(With("DEPTH=7")).depth_m, 7);
  const node_report_t both = Parsed(With("HDG_OG=80,COG=70"));
  EXPECT_EQ(both.course_over_ground_deg, 70);
  EXPECT_EQ(ExtraOf(both), (Extra{{"HDG_OG", "80"}}));
}

TEST(ParseNodeReport, KnowsItsKeysWithoutRegardToCase) {
  EXPECT_EQ(Parsed("name=alpha,x=5,y=1,spd=0,hdg=0,time=0").x_m, 5);
}

TEST(ParseNodeReport, ComputesOnePairOfCoordinatesFromTheOther) {
  const LocalFrame frame({.lat_deg = 43.8253, .lon_deg = -70.3304});
  const node_report_t from_xy = Parsed(kMinimal, &frame);
  EXPECT_NEAR(from_xy.lat_deg, 43.82512, 1e-5);
  EXPECT_NEAR(from_xy.lon_deg, -70.33034, 1e-5);
  const std::string text = "NAME=a,SPD=0,HDG=0,TIME=0,LAT=" + std::to_string(from_xy.lat_deg) +
                           ",LON=" + std::to_string(from_xy.lon_deg);
  const node_report_t from_geo = Parsed(text, &frame);
  EXPECT_NEAR(from_geo.x_m, 5, 0.1);
  EXPECT_NEAR(from_geo.y_m, -20, 0.1);
  const node_report_t both = Parsed(With("LAT=1,LON=2"), &frame);
  EXPECT_EQ(both.lat_deg, 1);
  EXPECT_EQ(both.x_m, 5);
}

TEST(ParseNodeReport, NamesTheKeyThatIsMissing) {
  EXPECT_EQ(ErrorOf(""), "NAME is missing; write NAME=<vehicle>");
  EXPECT_EQ(ErrorOf("NAME=,X=1"), "NAME is empty; write NAME=<vehicle>");
  EXPECT_EQ(ErrorOf("NAME=a,X=1,Y=1,SPD=1,HDG=1"), "TIME is missing in the report of 'a'");
  EXPECT_EQ(ErrorOf("NAME=a,X=1,Y=1,HDG=1,TIME=1"), "SPD is missing in the report of 'a'");
  EXPECT_EQ(ErrorOf("NAME=a,SPD=1,HDG=1,TIME=1"), "X and Y are missing in the report of 'a'");
  EXPECT_EQ(ErrorOf("NAME=a,X=1,SPD=1,HDG=1,TIME=1"),
            "Y is missing in the report of 'a', which has X; write both or neither");
  EXPECT_EQ(ErrorOf(With("LON=1")),
            "LAT is missing in the report of 'alpha', which has LON; write both or neither");
  EXPECT_EQ(ErrorOf("NAME=a,LAT=1,LON=1,SPD=1,HDG=1,TIME=1"),
            "X and Y are missing in the report of 'a'; to take LAT and LON instead, give the "
            "mission's origin");
  EXPECT_EQ(ErrorOf(With("TYPE=glider")),
            "DEP is missing in the report of 'alpha', whose TYPE is glider; write DEP=0 for one at "
            "the surface");
}

TEST(ParseNodeReport, NamesTheValueThatIsWrong) {
  EXPECT_EQ(ErrorOf(With("DEP=nan")), "DEP = 'nan' is not a finite number");
  EXPECT_EQ(ErrorOf(With("LENGTH=5m")), "LENGTH = '5m' is not a finite number");
  EXPECT_EQ(ErrorOf(With("INDEX=1.5")), "INDEX = '1.5' is not a whole number");
  EXPECT_EQ(ErrorOf("NAME=a,TIME=now"), "TIME = 'now' is not seconds, within 9.2e12 of 0");
  EXPECT_EQ(ErrorOf(With("X=6")), "X is given twice; leave one of the two");
  const LocalFrame frame({.lat_deg = 43.8253, .lon_deg = -70.3304});
  EXPECT_NE(ErrorOf("NAME=a,LAT=91,LON=0,SPD=0,HDG=0,TIME=0", &frame), "");
  EXPECT_NE(ErrorOf("NAME=a,LAT=-43,LON=0,SPD=0,HDG=0,TIME=0", &frame), "");
  EXPECT_NE(ErrorOf("NAME=a,X=1e300,Y=0,SPD=0,HDG=0,TIME=0", &frame), "");
}

TEST(FormatNodeReport, WritesKeysInTheirUsualOrder) {
  node_report_t report = Parsed(With("TYPE=kayak,INDEX=3,USER=\"a, b\""));
  EXPECT_EQ(FormatNodeReport(report, MoosForm::kFields),
            "NAME=alpha,X=5,Y=-20,SPD=1.5,HDG=90,COG=90,DEP=0,LAT=0,LON=0,TYPE=kayak,SPD_OG=1.5,"
            "INDEX=3,TIME=12.3,LENGTH=0,USER=\"a, b\"");
  EXPECT_EQ(FormatNodeReport(report, MoosForm::kJson),
            R"({"NAME":"alpha","X":5,"Y":-20,"SPD":1.5,"HDG":90,"COG":90,"DEP":0,"LAT":0,"LON":0,)"
            R"("TYPE":"kayak","SPD_OG":1.5,"INDEX":3,"TIME":12.3,"LENGTH":0,"USER":"a, b"})");
}

TEST(FormatNodeReport, WritesNumbersThatAreNotFiniteSoThatTheyAreRefused) {
  node_report_t report = Parsed(kMinimal);
  report.depth_m = std::numeric_limits<double>::infinity();
  report.altitude_m = std::nan("");
  for (const MoosForm form : {MoosForm::kFields, MoosForm::kJson}) {
    EXPECT_NE(ErrorOf(FormatNodeReport(report, form)).find("is not a finite number"),
              std::string::npos);
  }
}

rc::Gen<double> Real() {
  return rc::gen::suchThat(
      rc::gen::oneOf(rc::gen::arbitrary<double>(), rc::gen::element(0.0, -0.0, -1.0, 1e300)),
      [](double number) { return std::isfinite(number); });
}

/// Draws reports whose texts hold every character that means something, and whose extra fields
/// have the keys that mean something else.
node_report_t DrawReport(const rc::Gen<std::string>& text) {
  node_report_t report{};
  report.utime = *rc::gen::arbitrary<int64_t>();
  report.name = *rc::gen::nonEmpty(text);
  for (auto* member : {&report.type, &report.group, &report.color, &report.mode, &report.all_stop})
    *member = *text;
  for (auto* member :
       {&report.x_m, &report.y_m, &report.depth_m, &report.altitude_m, &report.lat_deg,
        &report.lon_deg, &report.speed_mps, &report.heading_deg, &report.speed_over_ground_mps,
        &report.course_over_ground_deg, &report.length_m})
    *member = *Real();
  report.index = *rc::gen::arbitrary<int64_t>();
  const auto keys = *rc::gen::container<std::vector<std::string>>(rc::gen::oneOf(
      text, rc::gen::element<std::string>("NAME", "x", "extra.", "extra.NAME", "extra.A", "COG",
                                          "HDG_OG", "DEPTH", "LONG", "YAW", "YAW")));
  for (const std::string& key : keys) report.extra.push_back({.key = key, .value = *text});
  report.num_extra = static_cast<int32_t>(report.extra.size());
  return report;
}

rc::Gen<std::string> Text(const rc::Gen<char>& any) {
  return rc::gen::container<std::string>(
      rc::gen::oneOf(rc::gen::element('a', ',', '"', '=', '{', '}', '\\', ' ', '\n', ':'), any));
}

RC_GTEST_PROP(FormatNodeReport, IsReadBackAsTheSameReportFromFields, ()) {
  const node_report_t report = DrawReport(Text(rc::gen::arbitrary<char>()));
  Result<node_report_t> again = ParseNodeReport(FormatNodeReport(report, MoosForm::kFields));
  RC_ASSERT(again.ok());
  RC_ASSERT(Bytes(*again) == Bytes(report));
}

RC_GTEST_PROP(FormatNodeReport, IsReadBackAsTheSameReportFromJson, ()) {
  const node_report_t report = DrawReport(Text(rc::gen::inRange<char>(0, 127)));
  Result<node_report_t> again = ParseNodeReport(FormatNodeReport(report, MoosForm::kJson));
  RC_ASSERT(again.ok());
  RC_ASSERT(Bytes(*again) == Bytes(report));
}

RC_GTEST_PROP(ParseNodeReport, SurvivesAnyText, ()) {
  const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "NAME", "=", ",", "X", "Y", "TIME", "1", "nan", "\"", "{", "}", ":", "SPD", "HDG", "\\"));
  std::string text;
  for (const std::string& word : words) text += word;
  const auto report = ParseNodeReport(text);
  RC_ASSERT((report.ok() || !report.error().empty()));
}

TEST(ParseNodeReport, TakesTimeInProportionToTheNumberOfFields) {
  std::string text(kMinimal);
  std::string json = R"({"NAME":"a","X":1,"Y":1,"SPD":1,"HDG":1,"TIME":1)";
  for (int i = 0; i < 20'000; ++i) {
    text += ",k=v";
    json += R"(,"k":"v")";
  }
  EXPECT_EQ(Parsed(text).extra.size(), 20'000U);
  EXPECT_EQ(Parsed(json + "}").extra.size(), 20'000U);
}

}  // namespace
}  // namespace shoal
