#include "lib/run/moos_text/node_report_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "lib/base/text/numbers.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal::node_report_text_test {

node_report_t SmallReport() {
  node_report_t report{};
  report.utime = 12'300'000;
  report.name = "alpha";
  report.x_m = 5;
  report.y_m = -20;
  report.speed_mps = report.speed_over_ground_mps = 1.5;
  report.heading_deg = report.course_over_ground_deg = 90;
  report.altitude_m = -1;
  return report;
}

TEST(FormatNodeReport, WritesKeysInTheirUsualOrder) {
  node_report_t report = SmallReport();
  report.type = "kayak";
  report.index = 3;
  report.extra = {{.key = "USER", .value = "a, b"}};
  report.num_extra = 1;
  EXPECT_EQ(FormatNodeReport(report),
            "NAME=alpha,X=5,Y=-20,SPD=1.5,HDG=90,COG=90,DEP=0,LAT=0,LON=0,TYPE=kayak,SPD_OG=1.5,"
            "INDEX=3,TIME=12.3,LENGTH=0,USER=\"a, b\"");
}

TEST(FormatNodeReport, WritesWhatIsKnownOfGroupModeAndAltitude) {
  node_report_t report = SmallReport();
  report.group = "survey";
  report.mode = "MODE@ACTIVE:LOITERING";
  report.all_stop = "clear";
  report.altitude_m = 10;
  report.color = "red";
  EXPECT_EQ(FormatNodeReport(report),
            "NAME=alpha,X=5,Y=-20,SPD=1.5,HDG=90,COG=90,DEP=0,LAT=0,LON=0,COLOR=red,GROUP=survey,"
            "MODE=MODE@ACTIVE:LOITERING,ALLSTOP=clear,ALTITUDE=10,SPD_OG=1.5,INDEX=0,TIME=12.3,"
            "LENGTH=0");
}

TEST(FormatNodeReport, SetsExtraFieldsWithAStandardKeyApart) {
  node_report_t report = SmallReport();
  report.extra = {{.key = "name", .value = "1"}, {.key = "extra.A", .value = "2"}};
  const std::string text = FormatNodeReport(report);
  EXPECT_TRUE(text.ends_with(",LENGTH=0,extra.name=1,extra.extra.A=2")) << text;
}

TEST(FormatNodeReport, WritesNumbersThatAreNotFiniteSoThatTheyAreRefused) {
  node_report_t report = SmallReport();
  report.depth_m = std::numeric_limits<double>::infinity();
  report.altitude_m = std::nan("");
  const std::string text = FormatNodeReport(report);
  EXPECT_NE(text.find(",DEP=inf,"), std::string::npos) << text;
  EXPECT_NE(text.find(",ALTITUDE=nan,"), std::string::npos) << text;
}

/// Draws reports whose texts hold every character that means something, and whose extra fields
/// have the keys that mean something else.
node_report_t DrawReport() {
  const auto text = rc::gen::container<std::string>(
      rc::gen::oneOf(rc::gen::element('a', ',', '"', '=', '{', '}', '\\', ' ', '\n', ':'),
                     rc::gen::arbitrary<char>()));
  const auto real = rc::gen::suchThat(
      rc::gen::oneOf(rc::gen::arbitrary<double>(), rc::gen::element(0.0, -0.0, -1.0, 1e300)),
      [](double number) { return std::isfinite(number); });
  node_report_t report{};
  report.utime = *rc::gen::arbitrary<int64_t>();
  report.name = *text;
  for (auto* member : {&report.type, &report.group, &report.color, &report.mode, &report.all_stop})
    *member = *text;
  for (auto* member :
       {&report.x_m, &report.y_m, &report.depth_m, &report.altitude_m, &report.lat_deg,
        &report.lon_deg, &report.speed_mps, &report.heading_deg, &report.speed_over_ground_mps,
        &report.course_over_ground_deg, &report.length_m})
    *member = *real;
  report.index = *rc::gen::arbitrary<int64_t>();
  const auto keys = *rc::gen::container<std::vector<std::string>>(rc::gen::oneOf(
      text, rc::gen::element<std::string>("NAME", "x", "extra.", "extra.NAME", "extra.A", "COG",
                                          "HDG_OG", "DEPTH", "LONG", "YAW", "YAW")));
  for (const std::string& key : keys) report.extra.push_back({.key = key, .value = *text});
  report.num_extra = static_cast<int32_t>(report.extra.size());
  return report;
}

RC_GTEST_PROP(FormatNodeReport, IsReadBackFieldByFieldWhateverTheTextsHold, ()) {
  const node_report_t report = DrawReport();
  const auto fields = ParseFields(FormatNodeReport(report));
  RC_ASSERT(fields.ok());
  RC_ASSERT(fields->size() >= report.extra.size());
  const size_t num_standard = fields->size() - report.extra.size();
  std::map<std::string, std::string> standard;
  for (size_t i = 0; i < num_standard; ++i) standard.emplace((*fields)[i].key, (*fields)[i].value);
  RC_ASSERT(standard.size() == num_standard);  // No key twice.

  const std::map<std::string, std::string> texts = {{"TYPE", report.type},
                                                    {"COLOR", report.color},
                                                    {"GROUP", report.group},
                                                    {"MODE", report.mode},
                                                    {"ALLSTOP", report.all_stop}};
  RC_ASSERT(standard.at("NAME") == report.name);
  for (const auto& [key, value] : texts) {
    const auto found = standard.find(key);
    RC_ASSERT((found == standard.end()) == value.empty());
    if (found != standard.end()) {
      RC_ASSERT(found->second == value);
    }
  }
  const std::map<std::string, double> numbers = {{"X", report.x_m},
                                                 {"Y", report.y_m},
                                                 {"SPD", report.speed_mps},
                                                 {"HDG", report.heading_deg},
                                                 {"COG", report.course_over_ground_deg},
                                                 {"DEP", report.depth_m},
                                                 {"LAT", report.lat_deg},
                                                 {"LON", report.lon_deg},
                                                 {"SPD_OG", report.speed_over_ground_mps},
                                                 {"LENGTH", report.length_m}};
  for (const auto& [key, value] : numbers) {
    RC_ASSERT(std::bit_cast<uint64_t>(NumberIn(standard.at(key)).value()) ==
              std::bit_cast<uint64_t>(value));
  }
  RC_ASSERT(standard.contains("ALTITUDE") == (report.altitude_m != -1));
  RC_ASSERT(standard.at("INDEX") == std::to_string(report.index));
  RC_ASSERT(standard.at("TIME") == SecondsText(report.utime));
  for (size_t i = 0; i < report.extra.size(); ++i) {
    RC_ASSERT((*fields)[num_standard + i].key.ends_with(report.extra[i].key));
    RC_ASSERT((*fields)[num_standard + i].value == report.extra[i].value);
  }
}

}  // namespace shoal::node_report_text_test
