#include "lib/bus/record/log_commands.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <sstream>

#include "lib/base/check/result.h"
#include "lib/base/schema/schema.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/bus/record/csv_rows.h"
#include "lib/bus/record/log_testing.h"

namespace shoal::log_commands_test {

Bytes Desired(int64_t utime, double heading_deg) {
  desired_t desired{};
  desired.utime = utime;
  desired.heading_deg = heading_deg;
  desired.speed_mps = 1.5;
  return Encoded(desired);
}

comms_fates_t FatesMessage(int64_t utime, const std::vector<std::string>& causes) {
  comms_fates_t fates{};
  fates.utime = utime;
  for (const std::string& cause : causes) {
    fate_t fate{};
    fate.kind = "report";
    fate.source = "alpha";
    fate.destination = "bravo";
    fate.cause = cause;
    fate.range_m = 12.5;
    fates.fates.push_back(fate);
  }
  fates.num_fates = static_cast<int32_t>(fates.fates.size());
  return fates;
}

Bytes Fates(int64_t utime, const std::vector<std::string>& causes) {
  return Encoded(FatesMessage(utime, causes));
}

/// Runs commands on logs in a directory, and keeps what they print.
class LogCommandsTest : public ::testing::Test {
 protected:
  std::string Log(const std::string& name, const std::vector<TestEvent>& events) {
    WriteLog(directory_.File(name), events);
    return directory_.File(name);
  }

  std::string Cat(const LogCatOptions& options) {
    exit_code_ = LogCat(options, out_, err_);
    return Taken();
  }
  std::string Info(const LogInfoOptions& options) {
    exit_code_ = LogInfo(options, out_, err_);
    return Taken();
  }
  std::string Diff(const std::string& a, const std::string& b,
                   const std::vector<std::string>& without = {}) {
    exit_code_ = LogDiff({.path_a = a, .path_b = b, .without = without}, out_, err_);
    return Taken();
  }
  std::string Csv(const LogCsvOptions& options) {
    exit_code_ = LogCsv(options, out_, err_);
    return Taken();
  }

  TestDirectory directory_;
  int exit_code_ = -1;
  std::ostringstream out_;
  std::ostringstream err_;

 private:
  std::string Taken() {
    std::string text = out_.str();
    out_.str("");
    return text;
  }
};

using LogCat_ = LogCommandsTest;
using LogInfo_ = LogCommandsTest;
using LogDiff_ = LogCommandsTest;
using LogCsv_ = LogCommandsTest;

TEST_F(LogInfo_, IsKeptBesideTheLogAndShownAgain) {
  for (const char* name : {"a.lcm", "a.lcm.zst"}) {
    const std::string path = Log(name, {{12'300'000, "DESIRED_ALPHA", Desired(12'300'000, 90)},
                                        {12'400'000, "OWN", {1, 2, 3, 4, 5, 6, 7, 8, 9}},
                                        {12'400'000, "COMMS_FATES", Bytes(3)}});
    const LogInfoOptions options{.path = path, .least_indexed_bytes = 0};
    const std::string read = Info(options);
    EXPECT_NE(read.find("fingerprint 0x0102030405060708"), std::string::npos) << read;
    ASSERT_TRUE(std::filesystem::exists(path + ".idx"));
    EXPECT_EQ(Info(options), read);
    // What is shown is what is kept: with another number in it, and where that cannot be.
    Bytes index = FileBytes(path + ".idx");
    WriteBytes(path + ".idx", Bytes(index.begin(), index.end() - 1));
    EXPECT_EQ(Info(options), read) << "damaged";
    EXPECT_EQ(FileBytes(path + ".idx"), index) << "and rewritten";
    auto log = LogReader::Open(path);
    ASSERT_TRUE(log.ok());
    const std::string key(index.begin() + 44, index.begin() + 44 + index[40]);
    const auto kept = ReadIndexPart(*log, IndexPart::kInfo, key, 0);
    ASSERT_TRUE(kept);
    int num_shown = 0;
    for (size_t i = 0; i < kept->size(); i += 11) {
      auto other = *kept;
      other[i] ^= 0x41;
      KeepIndexPart(*log, IndexPart::kInfo, key, other, 0);
      if (Info(options) != read) ++num_shown;
      EXPECT_EQ(out_.str().find('\033'), std::string::npos);
    }
    EXPECT_GT(num_shown, 3) << "numbers and names that can be";
  }
}

TEST_F(LogInfo_, NamesTheLogAsItWasNamedThisTime) {
  const std::string path = Log("a.lcm", {{12'300'000, "OWN", {1}}, {12'400'000, "OWN", {1}}});
  Bytes bytes = FileBytes(path);
  bytes.resize(bytes.size() - 1);
  WriteBytes(path, bytes);
  const std::string moved = directory_.File("b.lcm");
  (void)Info({.path = path, .least_indexed_bytes = 0});
  EXPECT_NE(err_.str().find(path + ": byte "), std::string::npos) << err_.str();
  std::filesystem::rename(path, moved);
  std::filesystem::rename(path + ".idx", moved + ".idx");
  (void)Info({.path = moved, .least_indexed_bytes = 0});
  EXPECT_NE(err_.str().find(moved + ": byte "), std::string::npos) << err_.str();
}

TEST_F(LogInfo_, LeavesAFileThatIsNoIndex) {
  const std::string path = Log("a.lcm", {{12'300'000, "OWN", {1}}});
  for (const Bytes& bytes : {Bytes(100, 'x'), Bytes{'S', 'H', 'O', 'P'}}) {
    WriteBytes(path + ".idx", bytes);
    (void)Info({.path = path, .least_indexed_bytes = 0});
    EXPECT_EQ(FileBytes(path + ".idx"), bytes);
  }
  // What a disk without room, or power, left of one.
  WriteBytes(path + ".idx", {});
  (void)Info({.path = path, .least_indexed_bytes = 0});
  EXPECT_GT(FileBytes(path + ".idx").size(), 40U);
}

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

TEST_F(LogInfo_, PrintsSpanAndATableOfChannels) {
  std::vector<TestEvent> events;
  for (int i = 0; i <= 10; ++i) {
    events.push_back({i * 100'000, "DESIRED_ALPHA", Desired(i * 100'000, i)});
  }
  events.push_back({1'000'000, "MINE", {1, 2, 3, 4, 5, 6, 7, 8}});
  const std::string path = Log("a.lcm", events);
  const std::string bytes = std::to_string(std::filesystem::file_size(path));
  EXPECT_EQ(Info({.path = path}),
            path + ": 12 events, 2 channels, " + bytes + " bytes, 0.000 s to 1.000 s\n" + R"(
channel        type         events        Hz     first_s      last_s       bytes
DESIRED_ALPHA  desired_t        11    10.000       0.000       1.000         440
MINE           ?                 1         -       1.000       1.000           8
MINE: 1 events of unknown type, fingerprint 0x0102030405060708 (give its .lcm file)
)");
  EXPECT_EQ(exit_code_, kExitOk);
}

TEST_F(LogInfo_, ReportsUndecodableEventsAndATruncatedTail) {
  Bytes cut = Desired(0, 0);
  cut.pop_back();
  const std::string path = Log("a.lcm", {{0, "C", cut}, {0, "C", Desired(0, 1)}, {0, "D", {}}});
  Bytes bytes = FileBytes(path);
  bytes.pop_back();
  WriteBytes(path, bytes);
  const std::string text = Info({.path = path});
  EXPECT_NE(text.find("C: 1 events do not decode, the first in the event at byte 0: the message "
                      "ends too early\n"),
            std::string::npos)
      << text;
  EXPECT_NE(err_.str().find("the log ends inside an event (28 bytes skipped)"), std::string::npos)
      << err_.str();
  EXPECT_EQ(exit_code_, kExitEnvironment);
}

TEST_F(LogInfo_, CalculatesWithTimesAtTheEndsOfTheirRange) {
  const std::string path = Log("a.lcm", {{std::numeric_limits<int64_t>::min(), "A", {}},
                                         {std::numeric_limits<int64_t>::max(), "A", {}}});
  EXPECT_NE(Info({.path = path}).find("-9223372036854.775808 s to 9223372036854.775807 s"),
            std::string::npos);
}

TEST_F(LogDiff_, StatesThatLogsAreEqual) {
  const std::vector<TestEvent> events = {{0, "D", Desired(0, 1)}, {100'000, "D", Desired(0, 2)}};
  EXPECT_EQ(Diff(Log("a.lcm", events), Log("b.lcm", events)), "equal: 2 events in 2 steps\n");
  EXPECT_EQ(exit_code_, kExitOk);
}

TEST_F(LogDiff_, FindsStepTimeChannelAndFieldOfTheFirstDifference) {
  const TestEvent first = {0, "D", Desired(0, 1)};
  const std::string a = Log("a.lcm", {first, {100'000, "COMMS_FATES", Fates(0, {"lost", "lost"})}});
  const std::string b =
      Log("b.lcm", {first, {100'000, "COMMS_FATES", Fates(0, {"lost", "delivered"})}});
  EXPECT_EQ(Diff(a, b),
            "first difference: step 1, 0.100 s, COMMS_FATES, comms_fates_t "
            "fates[1].cause\n  " +
                a + ": lost\n  " + b + ": delivered\n" +
                "every channel has the same number of events in both logs\n");
  EXPECT_EQ(exit_code_, kLogsDiffer);
}

TEST_F(LogDiff_, LeavesOutChannels) {
  const std::string a = Log("a.lcm", {{0, "D", Desired(0, 1)}, {0, "E_X", Desired(0, 1)}});
  const std::string b =
      Log("b.lcm", {{0, "E_X", Desired(0, 2)}, {0, "E_Y", {}}, {0, "D", Desired(0, 1)}});
  EXPECT_EQ(Diff(a, b, {"F", "E_*"}), "equal: 1 events in 1 steps\n");
  EXPECT_EQ(exit_code_, kExitOk);
  EXPECT_NE(Diff(a, b, {"E_Y"}), "equal: 2 events in 1 steps\n");
  EXPECT_EQ(exit_code_, kLogsDiffer);
}

TEST_F(LogDiff_, NamesTheArithmeticOfBothLogsWhereItDiffers) {
  const auto rules_of = [](const std::string& arithmetic) {
    broker_rules_t rules{};
    rules.arithmetic = arithmetic;
    return Encoded(rules);
  };
  const std::string a = Log("a.lcm", {{0, "COMMS_RULES", rules_of("a1")}, {0, "D", Desired(0, 1)}});
  const std::string b = Log("b.lcm", {{0, "COMMS_RULES", rules_of("b2")}, {0, "D", Desired(0, 1)}});
  const std::string note =
      "the logs are of builds with another arithmetic, which give other logs:\n  " + a +
      ": a1\n  " + b + ": b2\n";
  EXPECT_NE(Diff(a, b).find(note), std::string::npos);
  EXPECT_EQ(exit_code_, kLogsDiffer);
  EXPECT_EQ(Diff(a, b, {"COMMS_RULES"}), note + "equal: 1 events in 1 steps\n");
  EXPECT_EQ(exit_code_, kExitOk);
  const std::string old = Log("c.lcm", {{0, "COMMS_RULES", rules_of("")}, {0, "D", Desired(0, 1)}});
  EXPECT_EQ(Diff(a, old).find("arithmetic, which"), std::string::npos);
}

TEST_F(LogDiff_, FindsAMissingMessageAndCountsItsChannel) {
  const std::string a = Log("a.lcm", {{0, "D", Desired(0, 1)}, {0, "E", Desired(0, 1)}});
  const std::string b = Log("b.lcm", {{0, "E", Desired(0, 1)}});
  const std::string line = " desired_t heading_deg=1 speed_mps=1.5 depth_m=0\n";
  EXPECT_EQ(Diff(a, b), "first difference: step 0, 0.000 s, other messages follow\n  " + a +
                            ": 0.000 D" + line + "  " + b + ": 0.000 E" + line +
                            "different numbers of events:\n  D: 1 in " + a + ", 0 in " + b + "\n");
}

TEST_F(LogDiff_, FindsThatOneLogEnds) {
  const std::string a = Log("a.lcm", {{0, "D", Desired(0, 1)}});
  const std::string b = Log("b.lcm", {{0, "D", Desired(0, 1)}, {5, "E", {}}});
  EXPECT_EQ(Diff(a, b), "first difference: step 1, 0.000005 s, one log ends\n  " + a +
                            ": (ends here)\n  " + b + ": 0.000005 E ? (no fingerprint, 0 bytes)\n" +
                            "different numbers of events:\n  E: 0 in " + a + ", 1 in " + b + "\n");
}

TEST_F(LogDiff_, NamesTheByteWhereItKnowsNoField) {
  const std::string a = Log("a.lcm", {{0, "D", {1, 2, 3}}});
  const std::string b = Log("b.lcm", {{0, "D", {1, 2}}});
  EXPECT_EQ(Diff(a, b), "first difference: step 0, 0.000 s, D, byte 2 of the message\n  " + a +
                            ": 0x03\n  " + b + ": (ends)\n" +
                            "every channel has the same number of events in both logs\n");
}

TEST_F(LogDiff_, RefusesADamagedLog) {
  const std::string a = Log("a.lcm", {{0, "D", {1, 2, 3}}});
  const std::string b = Log("b.lcm", {{0, "D", {1, 2, 3}}});
  Bytes bytes = FileBytes(b);
  bytes.pop_back();
  WriteBytes(b, bytes);
  Diff(a, b);
  EXPECT_EQ(exit_code_, kExitEnvironment);
  EXPECT_NE(err_.str().find(b + ": byte 0: the log ends inside an event"), std::string::npos);
}

TEST_F(LogCsv_, WritesOneTablePerChannelWithARowPerElement) {
  comms_fates_t fates = FatesMessage(100'000, {"lost", "a \"b\", c"});
  acoustic_path_t path_taken{};
  path_taken.packet = 7;
  path_taken.sent_utime = 2'500'000;
  path_taken.air_s = 0.25;
  path_taken.num_named = 1;
  path_taken.colliders = {"alpha 12"};
  fates.fates[1].num_paths = 1;
  fates.fates[1].path = {path_taken};
  const std::string path = Log("a.lcm", {{100'000, "DESIRED_ALPHA", Desired(0, 90)},
                                         {100'000, "COMMS_FATES", Encoded(fates)},
                                         {200'000, "COMMS_FATES", Fates(200'000, {})}});
  const std::string dir = directory_.File("csv");
  EXPECT_EQ(Csv({.path = path, .out_dir = dir}),
            dir + "/COMMS_FATES.csv: 2 messages\n" + dir + "/DESIRED_ALPHA.csv: 1 messages\n");
  EXPECT_EQ(TextOfFile(dir + "/DESIRED_ALPHA.csv"),
            "time_s,utime_s,heading_deg,speed_mps,depth_m\n0.100,0.000,90,1.5,0\n");
  EXPECT_EQ(TextOfFile(dir + "/COMMS_FATES.csv"),
            "time_s,utime_s,num_fates,index,fates.kind,fates.source,fates.destination,"
            "fates.count,fates.number,fates.cause,fates.override_rule,fates.range_m,fates.limit_m,"
            "fates.age_s,fates.age_limit_s,fates.wait_s,fates.loss_pct,fates.length_bytes,"
            "fates.length_limit_bytes,fates.num_paths,fates.path.packet,fates.path.channel,"
            "fates.path.sent_utime_s,fates.path.num_bytes,fates.path.air_s,fates.path.travel_s,"
            "fates.path.jitter_s,fates.path.snr_db,fates.path.loss_probability,"
            "fates.path.bit_error_probability,fates.path.bits_flipped,fates.path.num_colliders,"
            "fates.path.own_packet,fates.path.num_named,fates.path.colliders\n"
            "0.100,0.100,2,0,report,alpha,bravo,0,0,lost,,12.5,0,0,0,0,0,0,0,0,,,,,,,,,,,,,,,\n"
            "0.100,0.100,2,1,report,alpha,bravo,0,0,\"a \"\"b\"\", c\",,12.5,0,0,0,0,0,0,0,1,"
            "7,0,2.500,0,0.25,0,0,0,0,0,0,0,0,1,\"[\"\"alpha 12\"\"]\"\n"
            "0.200,0.200,0,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,\n");
  EXPECT_EQ(err_.str(), "");
}

TEST_F(LogCsv_, KeepsFilesOfHostileChannelsInItsDirectory) {
  const std::string path = Log("a.lcm", {{0, "../x/y", Desired(0, 1)},
                                         {0, "___x_y", Desired(0, 2)},
                                         {0, "___x_y", Fates(0, {})},
                                         {0, "Z", {1}}});
  const std::string dir = directory_.File("csv");
  EXPECT_EQ(Csv({.path = path, .out_dir = dir}), dir + "/___x_y.comms_fates_t.csv: 1 messages\n" +
                                                     dir + "/___x_y.csv: 1 messages\n" + dir +
                                                     "/___x_y.desired_t.csv: 1 messages\n");
  EXPECT_NE(err_.str().find("Z: 1 messages left out"), std::string::npos);
}

TEST_F(LogCsv_, WritesLinesBesideTheTablesOfOneTypeWhereAskedTo) {
  const std::string path = Log("a.lcm", {{1, "D", Desired(0, 1)},
                                         {2, "D", Fates(0, {})},
                                         {3, "D", Desired(0, 2)},
                                         {4, "F", Fates(0, {})}});
  const std::string dir = directory_.File("csv");
  const auto append = [](int64_t event_utime, std::string_view channel,
                         std::span<const uint8_t> message, std::string* out) {
    *out += std::to_string(event_utime) + " " + std::string(channel) + " " +
            std::to_string(message.size()) + "\n";
  };
  const LogLines lines{
      .type = "desired_t", .extension = ".txt", .header = "%%\n", .append = append};
  EXPECT_EQ(Csv({.path = path, .out_dir = dir, .lines = lines}),
            dir + "/D.comms_fates_t.csv: 1 messages\n" + dir + "/D.csv: 2 messages\n" + dir +
                "/D.txt: 2 lines\n" + dir + "/F.csv: 1 messages\n");
  EXPECT_EQ(TextOfFile(dir + "/D.txt"), "%%\n1 D 40\n3 D 40\n");
}

TEST_F(LogCsv_, ReplacesLinksAndLeavesWhatTheyLeadTo) {
  const std::string path = Log("a.lcm", {{0, "A", Desired(0, 1)}, {0, "B", Desired(0, 2)}});
  const std::string dir = directory_.File("csv");
  const std::string victim = directory_.File("victim");
  std::filesystem::create_directory(dir);
  std::ofstream(victim) << "precious";
  std::filesystem::create_symlink("../victim", dir + "/A.csv");
  std::filesystem::create_hard_link(victim, dir + "/B.csv");
  Csv({.path = path, .out_dir = dir});
  EXPECT_EQ(exit_code_, kExitOk) << err_.str();
  EXPECT_EQ(TextOfFile(victim), "precious");
  for (const char* name : {"/A.csv", "/B.csv"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(dir + name)));
    EXPECT_TRUE(TextOfFile(dir + name).starts_with("time_s,")) << name;
  }
}

TEST_F(LogCsv_, StatesWhatItCannotWrite) {
  const std::string path = Log("a.lcm", {{0, "D", Desired(0, 1)}});
  Csv({.path = path, .out_dir = "/dev/null/x"});
  EXPECT_EQ(exit_code_, kExitEnvironment);
  EXPECT_NE(err_.str().find("cannot make /dev/null/x"), std::string::npos);
}

TEST_F(LogCsv_, HasAColumnForEachKeyOfTheUsersOwnFields) {
  const auto report = [](std::vector<key_value_t> extra) {
    node_report_t message{};
    message.extra = std::move(extra);
    message.num_extra = static_cast<int32_t>(message.extra.size());
    return Encoded(message);
  };
  const std::string path = Log(
      "a.lcm", {{0, "NODE_REPORT_LOCAL", report({{"fuel", "9"}})},
                {1, "NODE_REPORT_LOCAL", report({})},
                {2, "NODE_REPORT_LOCAL", report({{"a,b", "1"}, {"fuel", "8"}, {"fuel", "7"}})}});
  Csv({.path = path, .out_dir = directory_.File("csv")});
  std::istringstream table(TextOfFile(directory_.File("csv/NODE_REPORT_LOCAL.csv")));
  std::string header;
  std::getline(table, header);
  EXPECT_TRUE(
      header.ends_with(",num_extra,row_index,extra.key,extra.value,extra[fuel],"
                       "\"extra[a,b]\""))
      << header;
  std::string rest;
  for (std::string line; std::getline(table, line);) {
    std::vector<std::string> cells;
    std::string_view row = line;
    ASSERT_TRUE(TakeCsvRow(&row, &cells));
    for (size_t i = cells.size() - 5; i < cells.size(); ++i) rest += cells[i] + "|";
    rest += "\n";
  }
  EXPECT_EQ(rest,
            "0|fuel|9|9||\n"
            "|||||\n"
            "0|a,b|1|8|1|\n1|fuel|8|8|1|\n2|fuel|7|8|1|\n");
}

}  // namespace shoal::log_commands_test
