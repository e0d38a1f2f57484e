#include "lib/run/hosts/host_keys.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace shoal::host_keys_test {

class HostKeys : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "keysXXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string folder_;
};

TEST_F(HostKeys, AreReadAsTheyWereWritten) {
  const HostKey key = MakeHostKey();
  const std::string prefix = folder_ + "/new/host";
  const auto written = WriteHostKey(key, prefix);
  ASSERT_TRUE(written.ok()) << written.error();
  const auto read = ReadHostKey(prefix + ".key");
  ASSERT_TRUE(read.ok()) << read.error();
  EXPECT_EQ(read->public_key, key.public_key);
  EXPECT_EQ(read->secret_key, key.secret_key);
  EXPECT_EQ(*FindPublicKey("host.pub", folder_ + "/new"), key.public_key);
  EXPECT_EQ(*FindPublicKey(key.public_key, ""), key.public_key);
  struct stat status {};
  ASSERT_EQ(stat((prefix + ".key").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(HostKeys, AreNeverWrittenOverOthers) {
  const std::string prefix = folder_ + "/host";
  ASSERT_TRUE(WriteHostKey(MakeHostKey(), prefix).ok());
  const auto written = WriteHostKey(MakeHostKey(), prefix);
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().find("exists"), std::string::npos) << written.error();
}

TEST_F(HostKeys, ThatOthersCanReadAreRefused) {
  const std::string prefix = folder_ + "/host";
  ASSERT_TRUE(WriteHostKey(MakeHostKey(), prefix).ok());
  ASSERT_EQ(chmod((prefix + ".key").c_str(), 0640), 0);
  const auto read = ReadHostKey(prefix + ".key");
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().find("mode 640). If none has: chmod 600"), std::string::npos)
      << read.error();
}

TEST_F(HostKeys, ErrorsNameTheRemedy) {
  const auto missing = ReadHostKey(folder_ + "/none.key");
  ASSERT_FALSE(missing.ok());
  EXPECT_NE(missing.error().find("`shoal host keygen`"), std::string::npos) << missing.error();
  std::ofstream(folder_ + "/x.pub") << "no key\n";
  const auto wrong = FindPublicKey("x.pub", folder_);
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(wrong.error().find("holds no public key"), std::string::npos) << wrong.error();
}

}  // namespace shoal::host_keys_test
