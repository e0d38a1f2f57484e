#include "apps/viewer/outside_tiles.h"

#include <gtest/gtest.h>

namespace shoal::outside_tiles_test {

TEST(OutsideTiles, AreOfAnAddressWithThreePlaces) {
  EXPECT_EQ(OutsideTilesProblem("https://tile.example.org/{z}/{x}/{y}.png"), "");
  EXPECT_EQ(OutsideTilesProblem("http://127.0.0.1:8080/t?z={z}&x={x}&y={y}"), "");
  EXPECT_EQ(OriginOf("https://tile.example.org/{z}/{x}/{y}.png"), "https://tile.example.org");
  EXPECT_EQ(OriginOf("http://127.0.0.1:8080/{z}{x}{y}"), "http://127.0.0.1:8080");
}

TEST(OutsideTiles, OfOtherAddressesAreRefused) {
  for (const char* url :
       {"", "tile.example.org/{z}/{x}/{y}", "ftp://a/{z}{x}{y}", "https://", "https:///{z}{x}{y}",
        "https://a", "https://a/{z}/{x}.png", "https://a b/{z}{x}{y}", "https://{z}.a/{x}/{y}",
        "https://a;script-src */{z}{x}{y}", "https://a/{z}{x}{y}; script-src *",
        "https://a/{z}{x}{y}\r\nSet-Cookie: a", "https://a/{z}{x}{y}\"><script>",
        "https://user@a/{z}{x}{y}", "javascript://a/{z}{x}{y}"}) {
    EXPECT_NE(OutsideTilesProblem(url), "") << url;
  }
  EXPECT_NE(OutsideTilesProblem("https://a/{z}{x}{y}" + std::string(1000, 'x')), "");
}

}  // namespace shoal::outside_tiles_test
