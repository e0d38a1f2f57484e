// `shoal log copy`.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "lib/base/check/result.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_reader.h"
#include "lib/bus/record/log_testing.h"

namespace shoal::log_copy_test {

class LogCopyTest : public ::testing::Test {
 protected:
  LogCopyTest() {
    for (int i = 0; i < 10; ++i) {
      const auto byte = static_cast<uint8_t>(i);
      events_.push_back({i * 1'000'000, "NAV_ALPHA", Bytes(100, byte)});
      events_.push_back({i * 1'000'000, "NAV_BRAVO", {byte}});
    }
    WriteLog(plain_, events_);
  }

  int Copy(const LogCopyOptions& options) {
    out_.str("");
    err_.str("");
    return LogCopy(options, out_, err_);
  }

  /// Returns "number time channel size" of each event.
  static std::string Events(const std::string& path) {
    auto reader = LogReader::Open(path);
    EXPECT_TRUE(reader.ok()) << reader.error();
    std::string text;
    while (const auto event = reader->Next()) {
      text += std::to_string(event->number) + " " + std::to_string(event->utime / 1'000'000) + " " +
              std::string(event->channel) + " " + std::to_string(event->data.size()) + "\n";
    }
    EXPECT_EQ(reader->error(), "");
    return text;
  }

  TestDirectory directory_;
  const std::string plain_ = directory_.File("a.lcm");
  const std::string compressed_ = directory_.File("b.lcm.zst");
  const std::string copy_ = directory_.File("c.lcm");
  std::vector<TestEvent> events_;
  std::ostringstream out_;
  std::ostringstream err_;
};

using LogCopy_ = LogCopyTest;

TEST_F(LogCopy_, LeavesWhatIsThereWhereItCopiesNothing) {
  ASSERT_EQ(Copy({.path = plain_, .out_path = copy_}), kExitOk) << err_.str();
  const auto before = FileBytes(copy_);
  EXPECT_EQ(Copy({.path = plain_, .out_path = copy_, .selection = {.from_s = 1000}}), kExitUsage);
  EXPECT_EQ(err_.str(),
            "shoal: none of the 20 events of " + plain_ +
                " is chosen by --from, --to, --channels and --without; `shoal log info` "
                "shows times and channels\n");
  EXPECT_EQ(Copy({.path = plain_, .out_path = copy_, .selection = {.channels = {"NAV_CHARLY"}}}),
            kExitUsage);
  EXPECT_EQ(FileBytes(copy_), before);
  const auto files = std::filesystem::directory_iterator(directory_.File(""));
  EXPECT_EQ(std::distance(begin(files), end(files)), 2) << "the log and its copy";
}

TEST_F(LogCopy_, ReadsWhatAKilledCopyLeft) {
  const std::string left = directory_.File(".part-c.lcm");
  std::filesystem::rename(plain_, left);
  ASSERT_EQ(Copy({.path = left, .out_path = copy_}), kExitOk) << err_.str();
  EXPECT_EQ(FileBytes(copy_), FileBytes(left));
  EXPECT_EQ(FileBytes(copy_).size(), 1750U);
}

TEST_F(LogCopy_, TakesThePlaceOfAFileWithItsPermissionsAndOfALongName) {
  namespace fs = std::filesystem;
  WriteBytes(copy_, {});
  fs::permissions(copy_, fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_EQ(Copy({.path = plain_, .out_path = copy_}), kExitOk) << err_.str();
  EXPECT_EQ(fs::status(copy_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  const std::string longest = directory_.File(std::string(251, 'x') + ".lcm");
  EXPECT_EQ(Copy({.path = plain_, .out_path = longest}), kExitOk) << err_.str();
  EXPECT_EQ(FileBytes(longest), FileBytes(plain_));
}

TEST_F(LogCopy_, WritesWhereALinkLeadsAndReportsOneThatLeadsNowhere) {
  namespace fs = std::filesystem;
  const std::string link = directory_.File("link.lcm");
  fs::create_symlink(copy_, link);
  for (int i = 0; i < 2; ++i) {  // The copy is not there; then it is.
    ASSERT_EQ(Copy({.path = plain_, .out_path = link}), kExitOk) << err_.str();
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(FileBytes(copy_), FileBytes(plain_));
  }
  const std::string loop = directory_.File("loop.lcm");
  fs::create_symlink(loop, loop);
  EXPECT_EQ(Copy({.path = plain_, .out_path = loop}), kExitEnvironment);
  EXPECT_NE(err_.str().find("cannot write " + loop), std::string::npos) << err_.str();
}

TEST_F(LogCopy_, GivesTheSameBytesBackFromACompressedLog) {
  EXPECT_EQ(Copy({.path = plain_, .out_path = compressed_}), kExitOk) << err_.str();
  EXPECT_EQ(out_.str(), compressed_ + ": 20 of 20 events, 1750 bytes of the log\n");
  EXPECT_LT(FileBytes(compressed_).size(), FileBytes(plain_).size() / 2);
  EXPECT_EQ(Copy({.path = compressed_, .out_path = copy_}), kExitOk) << err_.str();
  EXPECT_EQ(FileBytes(copy_), FileBytes(plain_));
}

TEST_F(LogCopy_, CutsByTimeAndChannelAndKeepsNumbers) {
  const LogSelection selection = {
      .channels = {"NAV_*"}, .without = {"*ALPHA"}, .from_s = 3, .to_s = 5};
  EXPECT_EQ(Copy({.path = plain_, .out_path = copy_, .selection = selection}), kExitOk);
  EXPECT_EQ(Events(copy_), "7 3 NAV_BRAVO 1\n9 4 NAV_BRAVO 1\n11 5 NAV_BRAVO 1\n");
}

TEST_F(LogCopy_, ReportsAPatternThatMatchesNothing) {
  EXPECT_EQ(Copy({.path = plain_, .out_path = copy_, .selection = {.channels = {"NVA_*"}}}),
            kExitUsage);
  EXPECT_NE(err_.str().find("no channel matches 'NVA_*'; there are: NAV_ALPHA, NAV_BRAVO"),
            std::string::npos)
      << err_.str();
  EXPECT_EQ(Copy({.path = plain_, .out_path = copy_, .selection = {.without = {"NVA_*"}}}),
            kExitOk);
  EXPECT_NE(err_.str().find("no channel matches 'NVA_*'"), std::string::npos) << err_.str();
}

TEST_F(LogCopy_, RefusesToWriteOverTheLogItself) {
  const Bytes before = FileBytes(plain_);
  EXPECT_EQ(Copy({.path = plain_, .out_path = plain_}), kExitUsage);
  EXPECT_NE(err_.str().find("is the log itself"), std::string::npos) << err_.str();
  EXPECT_EQ(FileBytes(plain_), before);
}

TEST_F(LogCopy_, CopiesWhatIsWholeOfADamagedLogWhereAsked) {
  Bytes bytes = FileBytes(plain_);
  bytes.resize(bytes.size() - 5);
  WriteBytes(plain_, bytes);
  EXPECT_EQ(Copy({.path = plain_, .out_path = copy_}), kExitEnvironment);
  EXPECT_NE(err_.str().find("the log ends inside an event"), std::string::npos) << err_.str();
  EXPECT_EQ(Copy({.path = plain_, .out_path = copy_, .skip_damage = true}), kExitOk);
  EXPECT_NE(Events(copy_).find("18 9 NAV_ALPHA 100\n"), std::string::npos);
}

TEST_F(LogCopy_, ReportsWhereItCannotWrite) {
  EXPECT_EQ(Copy({.path = plain_, .out_path = directory_.File("no/c.lcm")}), kExitEnvironment);
  EXPECT_NE(err_.str().find("make its folder first"), std::string::npos) << err_.str();
  EXPECT_EQ(Copy({.path = plain_, .out_path = "/dev/full"}), kExitEnvironment);
  EXPECT_NE(err_.str().find("free some space"), std::string::npos) << err_.str();
}

}  // namespace shoal::log_copy_test
