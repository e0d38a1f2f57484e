#include <gtest/gtest.h>

#include <string>

#include "lib/base/check/result.h"
#include "lib/base/schema/schema.h"
#include "lib/bus/bus/seal.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_commands_testing.h"

namespace shoal::log_cat_test {

using LogCat_ = LogCommandsTest;

TEST_F(LogCat_, PrintsOneLinePerMessage) {
  const std::string path =
      Log("a.lcm", {{12'300'000, "DESIRED_ALPHA", Desired(12'300'000, 90)},
                    {12'400'000, "DESIRED_ALPHA", Desired(12'300'000, 91)},
                    {12'400'000, "COMMS_FATES", Fates(12'400'000, {"delivered"})}});
  EXPECT_EQ(Cat({.path = path}),
            "12.300 DESIRED_ALPHA desired_t heading_deg=90 speed_mps=1.5 depth_m=0\n"
            "12.400 DESIRED_ALPHA desired_t utime=12300000 heading_deg=91 speed_mps=1.5 depth_m=0\n"
            "12.400 COMMS_FATES comms_fates_t fates=[{kind=report source=alpha destination=bravo "
            "count=0 number=0 cause=delivered override_rule=\"\" range_m=12.5 limit_m=0 age_s=0 "
            "age_limit_s=0 wait_s=0 loss_pct=0 length_bytes=0 length_limit_bytes=0 path=[]}]\n");
  EXPECT_EQ(exit_code_, kExitOk);
  EXPECT_EQ(err_.str(), "");
}

TEST_F(LogCat_, PrintsPulsesInColumnsAsTheListThatTheyStandFor) {
  comms_pulse_columns_t columns{};
  columns.num_ends = 2;
  columns.ends = {{"ALPHA", 1, 2}, {"BRAVO", 3, 4}};
  columns.num_styles = columns.num_pulses = 1;
  columns.styles.resize(1);
  columns.styles[0].ptype = "nrep";
  columns.source = columns.style = {0};
  columns.destination = {1};
  columns.beam_width_m = {5};
  const std::string path = Log("a.lcm", {{0, "VIEW_COMMS_PULSE", Encoded(columns)}});
  EXPECT_EQ(Cat({.path = path}),
            "0.000 VIEW_COMMS_PULSE comms_pulses_t pulses=[{sx_m=1 sy_m=2 tx_m=3 "
            "ty_m=4 beam_width_m=5 duration_s=0 fill=0 label=ALPHA2BRAVO ptype=nrep "
            "fill_color=\"\" edge_color=\"\" edge_size=0}]\n");
}

TEST_F(LogCat_, SelectsChannelsTimesAndLines) {
  std::vector<TestEvent> events;
  for (int i = 0; i < 5; ++i) {
    const int64_t utime = i * 100'000;
    events.push_back({utime, "DESIRED_ALPHA", Desired(utime, i)});
    events.push_back({utime, "DESIRED_BRAVO", Desired(utime, i)});
  }
  const std::string path = Log("a.lcm", events);
  EXPECT_EQ(Cat({.path = path,
                 .selection = {.channels = {"*_ALPHA"}, .from_s = 0.1, .to_s = 0.3},
                 .limit = 2}),
            "0.100 DESIRED_ALPHA desired_t heading_deg=1 speed_mps=1.5 depth_m=0\n"
            "0.200 DESIRED_ALPHA desired_t heading_deg=2 speed_mps=1.5 depth_m=0\n");
  const std::string all_from_to = Cat({.path = path, .selection = {.from_s = 0.1, .to_s = 0.3}});
  EXPECT_EQ(std::count(all_from_to.begin(), all_from_to.end(), '\n'), 6);
}

TEST_F(LogCat_, OfChannelsThatTheLogDoesNotHaveIsAnError) {
  const std::string path = Log("a.lcm", {{12'300'000, "DESIRED_ALPHA", Desired(12'300'000, 90)}});
  EXPECT_EQ(Cat({.path = path, .selection = {.channels = {"DESIRED_ALHPA", "X*"}}}), "");
  EXPECT_EQ(exit_code_, kExitUsage);
  EXPECT_NE(err_.str().find("no channel matches 'DESIRED_ALHPA'; there are: DESIRED_ALPHA"),
            std::string::npos)
      << err_.str();
  EXPECT_NE(Cat({.path = path, .selection = {.channels = {"X*", "DESIRED_*"}}}), "");
  EXPECT_EQ(exit_code_, kExitOk) << "one matches";
  EXPECT_EQ(Cat({.path = path, .selection = {.channels = {"DESIRED_ALPHA"}, .from_s = 99.0}}), "");
  EXPECT_EQ(exit_code_, kExitOk) << "the channel is there, though not then";
  Csv({.path = path, .out_dir = directory_.File("csv"), .selection = {.channels = {"X*"}}});
  EXPECT_EQ(exit_code_, kExitUsage);
}

TEST_F(LogCat_, ShowsWhatItCannotDecode) {
  Bytes cut = Desired(0, 0);
  cut.pop_back();
  const std::string path =
      Log("a.lcm", {{0, "A", {1, 2, 3, 4, 5, 6, 7, 8, 9}}, {0, "B", {1}}, {0, "C", cut}});
  EXPECT_EQ(Cat({.path = path}),
            "0.000 A ? (fingerprint 0x0102030405060708, 9 bytes)\n"
            "0.000 B ? (no fingerprint, 1 bytes)\n"
            "0.000 C desired_t ? (does not decode at byte 8 of 39: the message ends too early)\n");
}

TEST_F(LogCat_, DecodesSealedMessagesOfLcmLogger) {
  Bytes sealed = Desired(5, 90);
  AppendSeal({.publisher = "helm_alpha", .mission_id = 1, .step = 2, .sequence = 3},
             MissionSecret{}, "DESIRED_ALPHA", &sealed);
  const std::string path = Log("a.lcm", {{5, "D", sealed}});
  EXPECT_EQ(Cat({.path = path}), "0.000005 D desired_t heading_deg=90 speed_mps=1.5 depth_m=0\n");
}

TEST_F(LogCat_, DecodesTypesOfAUser) {
  const std::string types = directory_.File("mine.lcm");
  const std::string text = "package mine; struct probe_t { int64_t utime; int8_t n; }";
  WriteBytes(types, Bytes(text.begin(), text.end()));
  const auto schema = Schema::Build({{.file = types, .text = text}});
  const auto fingerprint = static_cast<uint64_t>(schema->FindByName("mine.probe_t")->fingerprint);
  Bytes probe;
  for (int shift = 56; shift >= 0; shift -= 8) {
    probe.push_back(static_cast<uint8_t>(fingerprint >> shift));
  }
  probe.insert(probe.end(), {0, 0, 0, 0, 0, 0, 0, 5, 7});
  const std::string path = Log("a.lcm", {{0, "P", probe}});
  EXPECT_EQ(Cat({.path = path, .types = {types}}), "0.000 P mine.probe_t utime=5 n=7\n");
  EXPECT_NE(Cat({.path = path}).find("0.000 P ? (fingerprint"), std::string::npos);

  WriteBytes(types, {'s', 't', 'r', 'u', 'c', 't'});
  Cat({.path = path, .types = {types}});
  EXPECT_EQ(exit_code_, kExitUsage);
  EXPECT_NE(err_.str().find(types + ":1:7: expected the name of a struct"), std::string::npos);
}

TEST_F(LogCat_, StopsAtDamageUnlessAskedToSkipIt) {
  const std::string path = Log("a.lcm", {{0, "A", Desired(0, 1)}, {0, "B", Desired(0, 2)}});
  Bytes bytes = FileBytes(path);
  bytes.insert(bytes.begin(), 'x');
  WriteBytes(path, bytes);
  EXPECT_EQ(Cat({.path = path}), "");
  EXPECT_EQ(exit_code_, kExitEnvironment);
  EXPECT_NE(err_.str().find("byte 0: not an LCM event log"), std::string::npos);
  const std::string all = Cat({.path = path, .skip_damage = true});
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 2);
  EXPECT_EQ(exit_code_, kExitOk);
}

}  // namespace shoal::log_cat_test
