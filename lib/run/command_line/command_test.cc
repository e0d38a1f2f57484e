#include "lib/run/command_line/command.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal::command_test {

class Command_ : public ::testing::Test {
 protected:
  Program program_{"sounder", "Measures the depth."};
};

TEST_F(Command_, WritesWhatItReadsToTheVariables) {
  int count = 0;
  std::vector<std::string> files;
  bool is_loud = false;
  program_.AddOption("--count,-c", &count, "How many").InRange(1, 8);
  program_.AddOption("FILE", &files, "Files");
  program_.AddFlag("--loud", &is_loud, "With sound");
  EXPECT_EQ(program_.Parse({"a", "-c", "8", "b", "--loud"}), std::nullopt);
  EXPECT_EQ(count, 8);
  EXPECT_EQ(files, (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(is_loud);
}

TEST_F(Command_, RefusesANumberBeyondItsRangeWithTheCodeForUsage) {
  double rate_hz = 1;
  program_.AddOption("--rate", &rate_hz, "Soundings per second").InRange(0.5, 2.0);
  EXPECT_EQ(program_.Parse({"--rate", "2.1"}), kExitUsage);
  EXPECT_EQ(program_.Parse({"--rate", "2"}), std::nullopt);
  EXPECT_EQ(rate_hz, 2);
}

TEST_F(Command_, NamesAnUnknownOptionAndTheOneThatWasMeant) {
  double warp = 1;
  std::string folder;
  const Command run = program_.AddSubcommand("run", "Measures");
  run.AddOption("--warp", &warp, "Speed");
  run.AddOption("--record", &folder, "Folder");
  program_.AddSubcommand("sim", "Pretends to");
  const auto error_of = [&](const std::vector<std::string>& words) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(program_.Parse(words), kExitUsage);
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ(error_of({"run", "--wrap", "5"}),
            "sounder run: unknown option '--wrap' (did you mean '--warp'?); `sounder run --help` "
            "lists what it takes\n");
  EXPECT_EQ(
      error_of({"sim", "--record=x"}),
      "sounder sim: unknown option '--record'; it is an option of `sounder run`; `sounder sim "
      "--help` lists what it takes\n");
  EXPECT_EQ(error_of({"sim", "more"}),
            "sounder sim: 'more' is one word too many; `sounder sim --help` lists what it takes\n");
}

TEST_F(Command_, NamesAMistypedOptionRatherThanWhatIsMissingBesideIt) {
  std::string file;
  bool is_quiet = false;
  const Command log = program_.AddSubcommand("log", "Reads");
  const Command info = log.AddSubcommand("info", "Counts");
  info.AddOption("FILE", &file, "File").Required();
  info.AddFlag("--quiet", &is_quiet, "No text");
  log.RequireSubcommand();
  program_.RequireSubcommand();
  const auto error_of = [&](const std::vector<std::string>& words) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(program_.Parse(words), kExitUsage);
    return testing::internal::GetCapturedStderr();
  };
  const std::string end = "; `sounder log info --help` lists what it takes\n";
  EXPECT_EQ(error_of({"log", "info", "--quite"}),
            "sounder log info: unknown option '--quite' (did you mean '--quiet'?)" + end);
  EXPECT_EQ(error_of({"log", "info", "-quiet", "f"}),
            "sounder log info: unknown option '-quiet' (did you mean '--quiet'?)" + end);
  EXPECT_EQ(error_of({"log", "info", "-q", "f"}), "sounder log info: unknown option '-q'" + end);
  EXPECT_EQ(error_of({"log", "info", "f", "-5"}),
            "sounder log info: '-5' is one word too many" + end);
  EXPECT_EQ(error_of({"log", "info"}), "sounder log info: FILE is required" + end);
  EXPECT_EQ(
      error_of({"--versio"}),
      "sounder: unknown option '--versio' (did you mean '--version'?); `sounder --help` lists "
      "what it takes\n");
}

TEST_F(Command_, RefusesNumbersThatAreNone) {
  double rate_hz = 1;
  std::optional<double> from_s;
  program_.AddOption("--rate", &rate_hz, "Rate");
  program_.AddOption("--from", &from_s, "Begin");
  const auto error_of = [&](const std::vector<std::string>& words) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(program_.Parse(words), kExitUsage);
    return testing::internal::GetCapturedStderr();
  };
  for (const std::string text : {"nan", "inf", "-inf", "1e999"}) {
    EXPECT_NE(error_of({"--rate", text}).find("'" + text + "' is not a finite number"),
              std::string::npos);
    EXPECT_NE(error_of({"--from=" + text}).find("--from: '" + text + "' is not a finite number"),
              std::string::npos);
  }
  EXPECT_EQ(program_.Parse({"--rate", "2.5", "--from=-1e3"}), std::nullopt);
  EXPECT_EQ(from_s, -1000);
}

TEST_F(Command_, EndsWithSuccessAfterHelpAndVersion) {
  EXPECT_EQ(program_.Parse({"--help"}), kExitOk);
  EXPECT_EQ(program_.Parse({"--version"}), kExitOk);
}

TEST_F(Command_, TakesOneValueEachTimeOfARepeatableList) {
  std::vector<std::string> keys;
  std::string file;
  program_.AddOption("--set", &keys, "A key").Repeatable();
  program_.AddOption("FILE", &file, "File").Required();
  EXPECT_EQ(program_.Parse({"--set", "a", "mine", "--set", "b"}), std::nullopt);
  EXPECT_EQ(keys, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(file, "mine");
}

TEST_F(Command_, HoldsWhatAnOptionNeedsAndExcludes) {
  bool has_page = false;
  bool may_command = false;
  bool is_quiet = false;
  const Option page = program_.AddFlag("--page", &has_page, "A page");
  program_.AddFlag("--commands", &may_command, "It may command").Needs(page);
  program_.AddFlag("--quiet", &is_quiet, "No text").Excludes(page);
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(program_.Parse({"--commands"}), kExitUsage);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "sounder: --commands requires --page; `sounder --help` lists what it takes\n");
  EXPECT_EQ(program_.Parse({"--commands", "--page"}), std::nullopt);
  EXPECT_EQ(program_.Parse({"--quiet", "--page"}), kExitUsage);
  EXPECT_EQ(program_.Parse({"--quiet"}), std::nullopt);
}

TEST_F(Command_, CallsBackTheSubcommandThatIsNamedAlone) {
  std::string called;
  for (const std::string name : {"ping", "listen"}) {
    program_.AddSubcommand(name, "").Callback([&called, name] { called += name; });
  }
  program_.RequireSubcommand();
  EXPECT_EQ(program_.Parse({}), kExitUsage);
  EXPECT_EQ(program_.Parse({"listen"}), std::nullopt);
  EXPECT_EQ(called, "listen");
}

TEST_F(Command_, RefusesWhatACheckedCallbackFindsWrong) {
  std::string error = "sounder: needs water";
  program_.CheckedCallback([&error] { return error; });
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(program_.Parse({}), kExitUsage);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "sounder: needs water\nRun with --help for more information.\n");
  error.clear();
  EXPECT_EQ(program_.Parse({}), std::nullopt);
}

TEST_F(Command_, LeavesTheWordsBehindAPrefixAsTheyAre) {
  std::string target;
  program_.AddOption("TARGET", &target, "A vehicle");
  program_.PrefixCommand();
  EXPECT_EQ(program_.Parse({"alpha", "goto", "-10", "--x"}), std::nullopt);
  EXPECT_EQ(target, "alpha");
  EXPECT_EQ(program_.Remaining(), (std::vector<std::string>{"goto", "-10", "--x"}));
}

TEST(SplitWords, KeepsAQuotedPartInOneWord) {
  EXPECT_EQ(SplitWords("-A \"two words\" -n 3"),
            (std::vector<std::string>{"-A", "two words", "-n", "3"}));
}

}  // namespace shoal::command_test
