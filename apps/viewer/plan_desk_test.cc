#include "apps/viewer/plan_desk.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace shoal::plan_desk_test {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kMission = R"([mission]
duration_s = 60

[[vehicle]]
name = "alpha"

[[vehicle.task]]
kind = "waypoints"
points = [[10, 20], [30, 40]]
)";

class Desk : public testing::Test {
 protected:
  Desk() {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "bay.toml") << kMission;
  }
  ~Desk() override { fs::remove_all(folder_); }

  PlanDesk Open(bool may_write) const {
    return PlanDesk(may_write, [file = (folder_ / "bay.toml").string()] { return PlanFile{file}; });
  }
  std::string TextOf(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name).rdbuf();
    return text.str();
  }

  const fs::path folder_ = testing::TempDir() + "plan_desk-" + std::to_string(getpid());
};

TEST_F(Desk, AnswersWithTheFileItsPlacesAndWhatIsWrong) {
  PlanDesk desk = Open(false);
  const json plan = json::parse(desk.Look("{}").body);
  EXPECT_EQ(plan["text"], kMission);
  EXPECT_EQ(plan["errors"], json::array());
  EXPECT_EQ(plan["may_write"], false);
  EXPECT_EQ(plan["vehicles"], json::parse(R"(["alpha"])"));
  EXPECT_EQ(plan["handles"][1], json::parse(R"({"vehicle": "alpha", "name": "waypoints",
      "kind": "waypoints", "key": "points", "updates": "", "shape": "line", "points": [[10, 20], [30, 40]]})"));
  EXPECT_EQ(plan["setup"]["vehicles"][0]["tasks"][0]["points"],
            json::parse("[[10, 20], [30, 40]]"));
}

TEST_F(Desk, EditsATextAndChecksItAsShoalCheckDoes) {
  PlanDesk desk = Open(false);
  const json moved = json::parse(
      desk.Look(R"({"edit": {"do": "move", "handle": 1, "point": 0, "points": [[7, 8]]}})").body);
  EXPECT_NE(moved["text"].get<std::string>().find("[[7, 8], [30, 40]]"), std::string::npos);
  EXPECT_EQ(TextOf("bay.toml"), kMission) << "the file stays";
  const json wrong = json::parse(desk.Look(R"({"text": "[mission]\nduration = 5\n"})").body);
  EXPECT_FALSE(wrong["errors"].empty());
  EXPECT_NE(wrong["errors"][0].get<std::string>().find("bay.toml:"), std::string::npos);
  EXPECT_EQ(wrong["setup"], nullptr);
}

TEST_F(Desk, RefusesWhatIsNoQuestion) {
  PlanDesk desk = Open(false);
  for (const char* body :
       {"", "[]", "{\"text\": 5}", "{\"path\": \"/etc/passwd\"}", "{\"edit\": []}",
        R"({"edit": {"do": "erase"}})", R"({"edit": {"do": "move", "handle": -1, "point": 0}})",
        R"({"edit": {"do": "move", "handle": 1, "point": 0, "points": [["a", 1]]}})",
        R"({"edit": {"do": "move", "handle": 1, "point": 0, "points": [[1e300, 1]]}})",
        R"({"edit": {"do": "move", "handle": 99, "point": 0, "points": [[1, 1]]}})"}) {
    EXPECT_EQ(desk.Look(body).status, 400) << body;
  }
  const std::string large(PlanDesk::kMaxText_bytes + 1, ' ');
  EXPECT_EQ(desk.Look(json{{"text", large}}.dump()).status, 400);
  EXPECT_EQ(PlanDesk(true, [] { return PlanFile{}; }).Look("{}").status, 404);
}

TEST_F(Desk, WritesBesideTheMissionAndNeverOverAFile) {
  PlanDesk desk = Open(true);
  const std::string body = json{{"text", std::string(kMission) + "# changed\n"}}.dump();
  std::ofstream(folder_ / "bay_plan1.toml") << "mine";
  fs::create_symlink(folder_ / "bay.toml", folder_ / "bay_plan2.toml");
  const json written = json::parse(desk.Write(body).body);
  EXPECT_EQ(written["file"], (folder_ / "bay_plan3.toml").string());
  EXPECT_EQ(TextOf("bay_plan3.toml"), std::string(kMission) + "# changed\n");
  EXPECT_EQ(TextOf("bay_plan1.toml"), "mine");
  EXPECT_EQ(TextOf("bay.toml"), kMission);
  const PlanFile plan = {(folder_ / "bay_plan3.toml").string()};
  EXPECT_EQ(json::parse(PlanDesk(true, [plan] { return plan; }).Write(body).body)["file"],
            (folder_ / "bay_plan4.toml").string());
}

TEST_F(Desk, WritesNoTextThatIsNoMission) {
  PlanDesk desk = Open(true);
  EXPECT_EQ(desk.Write(R"({"text": "[mission]\n"})").status, 400);
  EXPECT_EQ(desk.Write("{}").status, 400);
  EXPECT_EQ(desk.Run(R"({"text": "[mission]\n"})").status, 400);
  EXPECT_EQ(Open(false).Run("{}").status, 403);
  EXPECT_EQ(Open(false).Write(json{{"text", kMission}}.dump()).status, 403);
  EXPECT_FALSE(fs::exists(folder_ / "bay_plan1.toml"));
}

}  // namespace shoal::plan_desk_test
