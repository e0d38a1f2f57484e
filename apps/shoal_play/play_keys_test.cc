#include "apps/shoal_play/play_keys.h"

#include <gtest/gtest.h>

namespace shoal::play_keys_test {

using Kind = PlayKey::Kind;

TEST(PlayKeys, AreOrdersToTheClock) {
  EXPECT_EQ(KeysOf(" "), (std::vector<PlayKey>{{Kind::kPause}}));
  EXPECT_EQ(KeysOf("\033[C\033[D"),
            (std::vector<PlayKey>{{Kind::kSeekBy, 10}, {Kind::kSeekBy, -10}}));
  EXPECT_EQ(KeysOf("\033[A\033[B"),
            (std::vector<PlayKey>{{Kind::kSeekBy, 60}, {Kind::kSeekBy, -60}}));
  EXPECT_EQ(KeysOf("+-0q"), (std::vector<PlayKey>{
                                {Kind::kFaster}, {Kind::kSlower}, {Kind::kFastest}, {Kind::kEnd}}));
}

TEST(PlayKeys, LeaveOutAllOthers) {
  EXPECT_TRUE(KeysOf("").empty());
  EXPECT_TRUE(KeysOf("xyz\t\xff").empty());
  EXPECT_EQ(KeysOf("x x"), (std::vector<PlayKey>{{Kind::kPause}}));
}

}  // namespace shoal::play_keys_test
