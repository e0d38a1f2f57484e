#include "lib/base/schema/schema.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "lcmtypes/lcm_sources.h"
#include "shoal/ack_message_t.hpp"
#include "shoal/acomms_event_t.hpp"
#include "shoal/acomms_member_t.hpp"
#include "shoal/acomms_t.hpp"
#include "shoal/acoustic_path_t.hpp"
#include "shoal/acoustic_rx_on_t.hpp"
#include "shoal/acoustic_rx_t.hpp"
#include "shoal/acoustic_tx_on_t.hpp"
#include "shoal/acoustic_tx_t.hpp"
#include "shoal/actuators_t.hpp"
#include "shoal/appcast_req_t.hpp"
#include "shoal/appcast_t.hpp"
#include "shoal/broker_rule_t.hpp"
#include "shoal/broker_rules_t.hpp"
#include "shoal/broker_vehicle_t.hpp"
#include "shoal/clock_command_t.hpp"
#include "shoal/clock_state_t.hpp"
#include "shoal/comms_arrivals_t.hpp"
#include "shoal/comms_fate_columns_t.hpp"
#include "shoal/comms_fates_t.hpp"
#include "shoal/comms_media_t.hpp"
#include "shoal/comms_pulse_columns_t.hpp"
#include "shoal/comms_pulse_t.hpp"
#include "shoal/comms_pulses_t.hpp"
#include "shoal/comms_rules_req_t.hpp"
#include "shoal/comms_rules_t.hpp"
#include "shoal/desired_t.hpp"
#include "shoal/fate_arrivals_t.hpp"
#include "shoal/fate_case_t.hpp"
#include "shoal/fate_medium_t.hpp"
#include "shoal/fate_sender_t.hpp"
#include "shoal/fate_t.hpp"
#include "shoal/guidance_layer_t.hpp"
#include "shoal/guidance_t.hpp"
#include "shoal/helm_aim_t.hpp"
#include "shoal/helm_command_t.hpp"
#include "shoal/helm_decision_t.hpp"
#include "shoal/helm_state_t.hpp"
#include "shoal/kept_control_t.hpp"
#include "shoal/key_value_t.hpp"
#include "shoal/link_factors_t.hpp"
#include "shoal/modem_stats_t.hpp"
#include "shoal/modem_tx_t.hpp"
#include "shoal/nav_t.hpp"
#include "shoal/navigation_range_t.hpp"
#include "shoal/navigation_t.hpp"
#include "shoal/node_message_t.hpp"
#include "shoal/node_report_t.hpp"
#include "shoal/pulse_end_t.hpp"
#include "shoal/pulse_style_t.hpp"
#include "shoal/relay_t.hpp"
#include "shoal/resend_t.hpp"
#include "shoal/sim_command_t.hpp"
#include "shoal/sonar_beam_t.hpp"
#include "shoal/sonar_t.hpp"
#include "shoal/step_count_t.hpp"
#include "shoal/step_done_t.hpp"
#include "shoal/step_dones_t.hpp"
#include "shoal/step_total_t.hpp"
#include "shoal/swarm_contact_t.hpp"
#include "shoal/swarm_count_t.hpp"
#include "shoal/swarm_source_t.hpp"
#include "shoal/swarm_t.hpp"
#include "shoal/tick_t.hpp"
#include "shoal/unc_control_t.hpp"
#include "shoal/unc_controls_req_t.hpp"
#include "shoal/unc_controls_t.hpp"
#include "shoal/view_circle_t.hpp"
#include "shoal/view_point_t.hpp"
#include "shoal/view_polygon_t.hpp"
#include "shoal/view_seglist_t.hpp"
#include "shoal/view_text_t.hpp"
#include "shoal/water_sample_t.hpp"
#include "shoal_test/deep/empty_t.hpp"
#include "shoal_test/deep/point_t.hpp"
#include "shoal_test/deep/shapes_t.hpp"
#include "shoal_test/deep/tree_t.hpp"

namespace shoal::schema_test {

std::string FileText(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

Schema ShoalSchema() {
  std::vector<LcmSource> sources;
  for (const std::string_view text : LcmSources())
    sources.push_back({"lcmtypes", std::string(text)});
  auto schema = Schema::Build(sources);
  EXPECT_TRUE(schema.ok()) << schema.error();
  return std::move(*schema);
}

/// Fingerprints by full name, as lcm-gen's C++ has them.
template <class... T>
std::map<std::string, int64_t> Generated(const std::string& package) {
  return {{package + "." + T::getTypeName(), T::getHash()}...};
}

std::map<std::string, int64_t> Fingerprints(const Schema& schema) {
  std::map<std::string, int64_t> fingerprints;
  for (const StructType& type : schema.types()) fingerprints[type.FullName()] = type.fingerprint;
  return fingerprints;
}

std::string BuildError(const std::string& text) {
  const auto schema = Schema::Build({{.file = "a.lcm", .text = text}});
  return schema.ok() ? "" : schema.error();
}

TEST(Schema, GivesEveryTypeOfShoalTheFingerprintOfLcmGen) {
  const auto generated =
      Generated<ack_message_t, acomms_event_t, acomms_member_t, acomms_t, acoustic_path_t,
                acoustic_rx_on_t, acoustic_rx_t, acoustic_tx_on_t, acoustic_tx_t, actuators_t,
                appcast_req_t, appcast_t, broker_rule_t, broker_rules_t, broker_vehicle_t,
                clock_command_t, clock_state_t, comms_fate_columns_t, comms_fates_t,
                comms_arrivals_t, comms_media_t, comms_pulse_columns_t, comms_pulse_t,
                comms_pulses_t, comms_rules_req_t, comms_rules_t, desired_t, fate_case_t,
                fate_arrivals_t, fate_medium_t, fate_sender_t, fate_t, guidance_layer_t, guidance_t,
                helm_aim_t, helm_command_t, helm_decision_t, helm_state_t, kept_control_t,
                key_value_t, link_factors_t, modem_stats_t, modem_tx_t, nav_t, navigation_range_t,
                navigation_t, node_message_t, node_report_t, pulse_end_t, pulse_style_t, relay_t,
                resend_t, sim_command_t, sonar_beam_t, sonar_t, step_count_t, step_done_t,
                step_dones_t, step_total_t, swarm_contact_t, swarm_count_t, swarm_source_t, swarm_t,
                tick_t, unc_control_t, unc_controls_req_t, unc_controls_t, view_circle_t,
                view_point_t, view_polygon_t, view_seglist_t, view_text_t, water_sample_t>("shoal");
  EXPECT_EQ(Fingerprints(ShoalSchema()), generated) << "a new type? Add it to this test";
}

TEST(WirePage, HoldsEachTypeToTheFingerprintThatWasPublished) {
  const std::string page = FileText(SHOAL_SOURCE_DIR "/docs/inside/wire.md");
  const std::regex row(R"(\n\| `(\w+)` \| ([0-9.]+|next) \| `([0-9a-f]{16})` \|)");
  std::map<std::string, int64_t> on_page;
  for (auto it = std::sregex_iterator(page.begin(), page.end(), row); it != std::sregex_iterator();
       ++it) {
    on_page["shoal." + it->str(1)] = static_cast<int64_t>(std::stoull(it->str(3), nullptr, 16));
  }
  EXPECT_EQ(on_page, Fingerprints(ShoalSchema()))
      << "a published type never changes: make a new one (docs/inside/wire.md), and give it a row "
         "there";
}

TEST(Schema, GivesTypesOfEveryShapeTheFingerprintOfLcmGen) {
  const auto schema = Schema::Build(
      {{"types", FileText(SHOAL_SOURCE_DIR "/lib/base/schema/schema_test_types.lcm")}});
  ASSERT_TRUE(schema.ok()) << schema.error();
  using namespace shoal_test::deep;
  EXPECT_EQ(Fingerprints(*schema),
            (Generated<shapes_t, empty_t, point_t, tree_t>("shoal_test.deep")));
}

TEST(Schema, GivesTypesThatHoldOneAnotherTheFingerprintOfLcmGen) {
  const auto schema = Schema::Build({{"m.lcm", R"(package m;
      struct ping_t { int32_t n; pong_t pongs[n]; third_t t; }
      struct pong_t { int32_t n; ping_t pings[n]; ping_t more[n]; }
      struct third_t { string n; })"}});
  ASSERT_TRUE(schema.ok()) << schema.error();
  // From lcm-gen 1.3.1 --python: its C++ of types that include each other does not compile.
  const std::map<std::string, int64_t> expected = {
      {"m.ping_t", 0x3a391aa67a2ab08a},
      {"m.pong_t", static_cast<int64_t>(0xfcd6bd74a959da37)},
      {"m.third_t", 0x0ce731b62cbcd3b8}};
  EXPECT_EQ(Fingerprints(*schema), expected);
}

TEST(Schema, KnowsNoTwoTypesOfShoalByOneFingerprint) {
  const Schema schema = ShoalSchema();
  std::set<int64_t> fingerprints;
  for (const StructType& type : schema.types()) {
    EXPECT_TRUE(fingerprints.insert(type.fingerprint).second) << type.FullName();
  }
}

TEST(Schema, FindsTypesByNameAndFingerprint) {
  const Schema schema = ShoalSchema();
  const StructType* nav = schema.FindByName("shoal.nav_t");
  ASSERT_NE(nav, nullptr);
  EXPECT_EQ(schema.FindByFingerprint(nav_t::getHash()), nav);
  EXPECT_EQ(schema.FindByName("nav_t"), nullptr);
  EXPECT_EQ(schema.FindByFingerprint(12345), nullptr);
}

TEST(Schema, KnowsSizesOfTypesWithoutStringsAndVariableArrays) {
  const Schema schema = ShoalSchema();
  EXPECT_TRUE(schema.FindByName("shoal.actuators_t")->has_fixed_size);
  EXPECT_EQ(schema.FindByName("shoal.actuators_t")->min_wire_size, 40);
  EXPECT_FALSE(schema.FindByName("shoal.key_value_t")->has_fixed_size);
  EXPECT_EQ(schema.FindByName("shoal.key_value_t")->min_wire_size, 10);
  EXPECT_FALSE(schema.FindByName("shoal.comms_fates_t")->has_fixed_size);
}

TEST(Schema, TakesATypeTwiceOnlyIfBothAreTheSame) {
  EXPECT_EQ(BuildError("struct t { int8_t a; } struct t { int8_t a; }"), "");
  EXPECT_EQ(BuildError("struct t { int8_t a; } struct t { int8_t b; }"),
            "a.lcm: struct t is there already, with other members");
}

TEST(Schema, LeavesOutATypeWithAnUnknownMemberAndThoseThatHoldIt) {
  const auto schema = Schema::Build(
      {{"a.lcm",
        "struct outer_t { inner_t i; } struct inner_t { u x; } struct good_t { int8_t a; }"},
       {"b.lcm",
        "package b; struct user_t { int8_t n; good_t g[n]; } struct good_t { int8_t a; }"}});
  ASSERT_TRUE(schema.ok()) << schema.error();
  EXPECT_EQ(schema->left_out(),
            (std::vector<std::string>{
                "struct inner_t is left out: its member 'x' has the unknown type u; give the .lcm "
                "file that declares it, too",
                "struct outer_t is left out: its member 'i' has the unknown type inner_t; give the "
                ".lcm file that declares it, too"}));
  EXPECT_EQ(schema->types().size(), 3U);
  EXPECT_EQ(schema->FindByName("inner_t"), nullptr);
  EXPECT_EQ(schema->FindByName("good_t")->name, "good_t");
  const StructType* user = schema->FindByName("b.user_t");
  ASSERT_NE(user, nullptr);
  EXPECT_EQ(schema->types()[user->members[1].struct_index].FullName(), "b.good_t");
}

// lcm-gen from 1.4 on replaces the constant by its value, as written, before it makes the hash: a
// type with the number itself has the same fingerprint, and lcm-gen 1.3.1 takes that one.
TEST(Schema, TakesAConstantOfTheStructAsTheSizeOfAnArray) {
  const auto schema = Schema::Build({{"c.lcm", R"(
      struct named_t { const int32_t DIM = 3, HEX = 0x10; int64_t utime; double p[DIM][HEX]; }
      struct number_t { int64_t utime; double p[3][0x10]; }
      struct other_t { int64_t utime; double p[3][16]; })"}});
  ASSERT_TRUE(schema.ok()) << schema.error();
  const auto fingerprint = [&](const char* name) { return schema->FindByName(name)->fingerprint; };
  EXPECT_EQ(fingerprint("named_t"), fingerprint("number_t"));
  EXPECT_NE(fingerprint("named_t"), fingerprint("other_t")) << "the text counts, not the number";
  EXPECT_EQ(schema->FindByName("named_t")->min_wire_size, 8 + 3 * 16 * 8);
  EXPECT_NE(BuildError("struct t { const double D = 3; int8_t a[D]; }").find("whole number"),
            std::string::npos);
  EXPECT_NE(BuildError("struct t { const int8_t D = 0; int8_t a[D]; }").find("greater than 0"),
            std::string::npos);
  EXPECT_NE(BuildError("struct t { int8_t a[D]; const int8_t D = 1; }").find("before it"),
            std::string::npos);
  EXPECT_NE(
      BuildError("struct a { const int8_t D = 1; } struct t { int8_t a[D]; }").find("its struct"),
      std::string::npos);
}

TEST(Schema, RefusesWhatHasNoEnd) {
  EXPECT_NE(BuildError("struct t { t x; }").find("contains itself"), std::string::npos);
  EXPECT_NE(BuildError("struct t { u x; } struct u { t x[3]; }").find("contains itself"),
            std::string::npos);
  EXPECT_EQ(BuildError("struct t { int8_t n; t x[n]; }"), "");
}

TEST(Schema, RefusesTypesThatWouldTakeForeverToFingerprint) {
  std::string text = "struct t0 { int8_t a; }";
  for (int i = 1; i <= 40; ++i) {
    std::ostringstream type;
    type << " struct t" << i << " { t" << i - 1 << " a; t" << i - 1 << " b; }";
    text += type.str();
  }
  EXPECT_NE(BuildError(text).find("nests too many structs"), std::string::npos);
}

TEST(Schema, SurvivesSizesBeyondAllMeasure) {
  EXPECT_EQ(BuildError("struct t { double x[4000000000][4000000000][4000000000]; u y[9]; }"
                       "struct u { double x[4000000000][4000000000]; }"),
            "");
}

}  // namespace shoal::schema_test
