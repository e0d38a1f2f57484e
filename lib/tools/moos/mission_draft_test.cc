#include "lib/tools/moos/mission_draft.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/mission/file/load.h"

namespace shoal::mission_draft_test {

MissionDraft Loadable() {
  MissionDraft draft("# Preamble\n");
  draft.AddTable("mission", "[mission]", true);
  draft.AddTable("comms", "[comms]");
  draft.AddTable("vehicle", "[[vehicle]]", true);
  draft.AddTable("event", "[[event]]");
  draft.Set("mission",
            {.key = "duration_s", .value = "600", .origin = "", .text = "", .reason = "Assumed."});
  draft.Set("vehicle", {.key = "name", .value = "\"a\"", .origin = "", .text = "", .reason = ""});
  return draft;
}

DraftLine Line(std::string key, std::string value) {
  return {.key = key, .value = value, .origin = "f:7", .text = key + "=" + value, .reason = ""};
}

TEST(MissionDraft, WritesSettingsWithTheirLines) {
  MissionDraft draft = Loadable();
  draft.Set("comms", Line("comms_range", "50"));
  draft.Remark("comms", "f:9", "x = y", "no counterpart");
  EXPECT_EQ(draft.Text(),
            "# Preamble\n\n[mission]\n# Assumed.\nduration_s = 600\n\n[comms]\ncomms_range = 50  # "
            "f:7\n# f:9: x = y: no counterpart\n\n[[vehicle]]\nname = \"a\"\n");
  EXPECT_EQ(draft.MakeLoadable(), std::vector<std::string>());
}

TEST(MissionDraft, KeepsWhatALaterLineReplaces) {
  MissionDraft draft = Loadable();
  DraftLine same = Line("comms_range", "50");
  draft.Set("comms", same);
  draft.Set("comms", same);
  same.origin = "f:8";
  draft.Set("comms", same);
  draft.Set("comms", Line("comms_range", "60"));
  EXPECT_NE(
      draft.Text().find("[comms]\n# f:7, f:8: comms_range=50: replaced by f:7\ncomms_range = 60"),
      std::string::npos)
      << draft.Text();
}

TEST(MissionDraft, TurnsWhatTheReaderRefusesIntoComments) {
  MissionDraft draft = Loadable();
  draft.Set("comms", Line("comms_range", "-5e99"));
  draft.Set("comms", Line("stale_time", "\"soon\""));
  draft.Set("comms", Line("no_such_key", "1"));
  draft.Set("comms", Line("stale_forget_s", "70"));
  const std::vector<std::string> refused = draft.MakeLoadable();
  ASSERT_EQ(refused.size(), 2U) << draft.Text();
  EXPECT_TRUE(refused[0].starts_with("f:7: stale_time=\"soon\": ")) << refused[0];
  EXPECT_TRUE(refused[1].starts_with("f:7: no_such_key=1: ")) << refused[1];
  EXPECT_NE(draft.Text().find("\n# f:7: no_such_key=1: "), std::string::npos);
  const LoadedMission loaded = LoadMissionText(draft.Text(), "m");
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  EXPECT_EQ(loaded.mission.comms.stale_forget_s, 70);
}

TEST(MissionDraft, DropsATableThatIsWrongAsAWhole) {
  MissionDraft draft = Loadable();
  draft.Set("event", Line("at_s", "0"));
  const auto refused = draft.MakeLoadable();
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(draft.Text().find("[[event]]"), std::string::npos);
  EXPECT_EQ(LoadMissionText(draft.Text(), "m").errors, std::vector<std::string>());
}

TEST(MissionDraft, ReportsWhatItCannotFix) {
  MissionDraft draft("");
  draft.AddTable("mission", "[mission]", true);
  const auto refused = draft.MakeLoadable();
  ASSERT_FALSE(refused.empty());
  EXPECT_TRUE(refused[0].starts_with("the mission needs care: ")) << refused[0];
}

}  // namespace shoal::mission_draft_test
