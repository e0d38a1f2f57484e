#include "apps/viewer/status_board.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace shoal::status_board_test {

appcast_t Page(const std::string& app, int64_t utime, std::vector<std::string> warnings = {}) {
  appcast_t page{};
  page.app = app;
  page.utime = utime;
  page.step = 3;
  page.num_run_warnings = static_cast<int32_t>(warnings.size());
  page.run_warnings = std::move(warnings);
  page.page = "all is well\n";
  return page;
}

TEST(StatusBoard, ShowsPagesWithWarningsFirst) {
  StatusBoard board(1'000'000);
  board.Take(Page("a", 2'500'000), 10'000'000);
  board.Take(Page("b", 2'500'000, {"lost"}), 10'000'000);
  board.Take(Page("c", 2'500'000), 11'000'000);
  const auto pages = nlohmann::json::parse(board.Json(12'500'000)).at("pages");
  ASSERT_EQ(pages.size(), 3U);
  EXPECT_EQ(pages[0], nlohmann::json::parse(R"({"app": "b", "t": 1.5, "step": 3, "age_s": 2.5,
      "config_warnings": [], "run_warnings": ["lost"], "text": "all is well\n"})"));
  EXPECT_EQ(pages[1]["app"], "a");
  EXPECT_EQ(pages[2]["app"], "c");
  EXPECT_EQ(pages[2]["age_s"], 1.5);
}

TEST(StatusBoard, KeepsTheLastPageOfEachApp) {
  StatusBoard board(0);
  board.Take(Page("a", 0, {"once"}), 0);
  board.Take(Page("a", 0), 0);
  const auto pages = nlohmann::json::parse(board.Json(0)).at("pages");
  ASSERT_EQ(pages.size(), 1U);
  EXPECT_TRUE(pages[0]["run_warnings"].empty());
}

TEST(StatusBoard, WantsPagesOnceASecondWhileTheyAreShown) {
  StatusBoard board(0);
  EXPECT_FALSE(board.WantsPages(0));
  board.Json(1'000'000);
  EXPECT_TRUE(board.WantsPages(1'000'000));
  EXPECT_FALSE(board.WantsPages(1'900'000));
  EXPECT_TRUE(board.WantsPages(2'000'000));
  EXPECT_FALSE(board.WantsPages(9'000'000));
}

TEST(StatusBoard, SurvivesPagesOfUnregisteredParticipants) {
  StatusBoard board(INT64_MIN);
  appcast_t page =
      Page("\xff\xfe", INT64_MAX, std::vector<std::string>(1'000, std::string(5'000, 'w')));
  page.page = std::string(1'000'000, '\xff');
  board.Take(page, INT64_MAX);
  for (int i = 0; i < 3'000; ++i) board.Take(Page("app" + std::to_string(i), INT64_MIN), 0);
  const auto pages = nlohmann::json::parse(board.Json(INT64_MAX)).at("pages");
  EXPECT_EQ(pages.size(), StatusBoard::kMaxPages);
  EXPECT_EQ(pages[0]["run_warnings"].size(), 100U);
  EXPECT_EQ(pages[0]["run_warnings"][0].get<std::string>().size(), 1'000U);
}

TEST(StatusBoard, ShowsTheMissionsPagesAgainAfterThoseOfUnregisteredParticipants) {
  StatusBoard board(0);
  for (int i = 0; i < 3'000; ++i) board.Take(Page("app" + std::to_string(i), 0), 0);
  board.Take(Page("helm_alpha", 0), 11'000'000);
  const auto pages = nlohmann::json::parse(board.Json(11'000'000)).at("pages");
  ASSERT_EQ(pages.size(), 1U);
  EXPECT_EQ(pages[0]["app"], "helm_alpha");
}

TEST(StatusBoard, HoldsNoMoreThanThePagesOfALargeMissionNeed) {
  StatusBoard board(0);
  appcast_t page = Page("", 0);
  page.page = std::string(StatusBoard::kMaxText_bytes, 'x');
  for (int i = 0; i < 800; ++i) {
    page.app = "app" + std::to_string(i % 400);
    board.Take(page, 0);
  }
  EXPECT_EQ(board.num_pages(), StatusBoard::kMax_bytes / StatusBoard::kMaxText_bytes - 1);
}

}  // namespace shoal::status_board_test
