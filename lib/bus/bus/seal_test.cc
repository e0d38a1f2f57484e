#include "lib/bus/bus/seal.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "lib/bus/bus/bus.h"
#include "shoal/nav_t.hpp"

namespace shoal::seal_test {

TEST(Seal, ComesBackAsItWasPut) {
  std::vector<uint8_t> bytes = {1, 2, 3};
  AppendSeal({.publisher = "helm_alpha", .mission_id = -5, .step = 1LL << 40, .sequence = 7},
             MissionSecret{}, "NAV_ALPHA", &bytes);
  const Unsealed unsealed = Unseal(bytes);
  ASSERT_TRUE(unsealed.seal.has_value());
  EXPECT_EQ(unsealed.seal->publisher, "helm_alpha");
  EXPECT_EQ(unsealed.seal->mission_id, -5);
  EXPECT_EQ(unsealed.seal->step, 1LL << 40);
  EXPECT_EQ(unsealed.seal->sequence, 7U);
  EXPECT_EQ(std::vector<uint8_t>(unsealed.message.begin(), unsealed.message.end()),
            (std::vector<uint8_t>{1, 2, 3}));
}

/// 0, 1, 2, ... 31.
MissionSecret CountedSecret() {
  MissionSecret secret;
  for (size_t i = 0; i < secret.bytes.size(); ++i) secret.bytes[i] = static_cast<uint8_t>(i);
  return secret;
}

TEST(Seal, HasTheBytesThatTheProtocolPageStates) {
  std::vector<uint8_t> bytes = {0xaa};
  AppendSeal(
      {.publisher = "ab", .mission_id = 0x0102030405060708, .step = 9, .sequence = 0x0a0b0c0d},
      CountedSecret(), "NAV_ALPHA", &bytes);
  // The tag by Python: hashlib.blake2b(b"NAV_ALPHA\0" + the bytes before it, key=bytes(range(32)),
  // digest_size=16).
  EXPECT_EQ(bytes, (std::vector<uint8_t>{0xaa, 'a',  'b',  2,    1,    2,    3,    4,    5,
                                         6,    7,    8,    0,    0,    0,    0,    0,    0,
                                         0,    9,    0x0a, 0x0b, 0x0c, 0x0d, 0x3f, 0x6b, 0x60,
                                         0x39, 0xc3, 0x10, 0x62, 0x6b, 0x89, 0xa9, 0xdf, 0x8c,
                                         0x6b, 0x4a, 0xbf, 0x1c, 'S',  'H',  'O',  '2'}));
}

TEST(Seal, IsGenuineForItsSecretItsChannelAndItsBytesOnly) {
  std::vector<uint8_t> bytes = {1, 2, 3};
  AppendSeal({.publisher = "helm_alpha", .mission_id = 1, .step = 2, .sequence = 3},
             CountedSecret(), "NAV_ALPHA", &bytes);
  EXPECT_TRUE(IsGenuine(Unseal(bytes), CountedSecret(), "NAV_ALPHA"));
  EXPECT_FALSE(IsGenuine(Unseal(bytes), CountedSecret(), "NAV_BRAVO"));
  EXPECT_FALSE(IsGenuine(Unseal(bytes), MissionSecret{}, "NAV_ALPHA"));
  EXPECT_FALSE(IsGenuine(Unseal(std::vector<uint8_t>{1, 2, 3}), CountedSecret(), "NAV_ALPHA"));
  for (size_t i = 0; i < bytes.size(); ++i) {
    std::vector<uint8_t> changed = bytes;
    changed[i] ^= 0x10;
    EXPECT_FALSE(IsGenuine(Unseal(changed), CountedSecret(), "NAV_ALPHA")) << i;
  }
}

TEST(MissionSecret, ComesBackFromItsText) {
  const std::string text = SecretText(CountedSecret());
  EXPECT_EQ(text, "000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f\n");
  ASSERT_TRUE(ParseSecret(text).ok());
  EXPECT_EQ(*ParseSecret(text), CountedSecret());
  EXPECT_NE(RandomSecret(), RandomSecret());
}

TEST(MissionSecret, RefusesEveryOtherTextWithoutRepeatingIt) {
  const std::string text = SecretText(CountedSecret());
  for (const std::string& wrong :
       {std::string(), text.substr(0, 64), text + "x", "g" + text.substr(1), text.substr(2)}) {
    const Result<MissionSecret> parsed = ParseSecret(wrong);
    ASSERT_FALSE(parsed.ok()) << wrong;
    EXPECT_EQ(parsed.error(), "a mission's secret is 64 hexadecimal digits and a line break");
  }
}

TEST(MissionSecret, IsReadFromAPlainFileOfThisUserThatNoOtherMayRead) {
  const std::string path = testing::TempDir() + "shoal_secret_" + std::to_string(getpid());
  std::ofstream(path) << SecretText(CountedSecret());
  chmod(path.c_str(), 0644);
  EXPECT_NE(ReadSecretFile(path).error().find("mode 0600"), std::string::npos);
  chmod(path.c_str(), 0600);
  ASSERT_TRUE(ReadSecretFile(path).ok());
  EXPECT_EQ(*ReadSecretFile(path), CountedSecret());
  const std::string link = path + "_link";
  ASSERT_EQ(symlink(path.c_str(), link.c_str()), 0);
  EXPECT_FALSE(ReadSecretFile(link).ok());
  unlink(link.c_str());
  unlink(path.c_str());
  EXPECT_FALSE(ReadSecretFile(path).ok());
}

TEST(Seal, DoesNotKeepLcmFromDecodingTheMessage) {
  nav_t nav{};
  nav.x_m = 12.5;
  Bytes bytes;
  EncodeInto(nav, &bytes);
  AppendSeal({.publisher = "vehicle_sim_alpha", .mission_id = 1, .step = 2, .sequence = 3},
             MissionSecret{}, "NAV_ALPHA", &bytes);
  nav_t decoded{};
  EXPECT_GT(decoded.decode(bytes.data(), 0, static_cast<int>(bytes.size())), 0);
  EXPECT_EQ(decoded.x_m, 12.5);
}

RC_GTEST_PROP(Seal, IsNeverFoundWhereThereIsNone, (std::vector<uint8_t> bytes)) {
  const Unsealed unsealed = Unseal(bytes);
  RC_ASSERT(unsealed.message.size() <= bytes.size());
  if (!unsealed.seal) RC_ASSERT(unsealed.message.size() == bytes.size());
}

RC_GTEST_PROP(Seal, SurvivesTruncationWithoutHarm, (std::vector<uint8_t> message)) {
  AppendSeal({.publisher = "x", .mission_id = 1, .step = 2, .sequence = 3}, MissionSecret{},
             "NAV_ALPHA", &message);
  for (size_t size = 0; size < message.size(); ++size) {
    const Unsealed unsealed = Unseal(std::span(message).first(size));
    RC_ASSERT(unsealed.message.size() <= size);
  }
}

}  // namespace shoal::seal_test
