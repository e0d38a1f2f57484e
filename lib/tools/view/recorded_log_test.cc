// Logs that are not as they should be, as RecordedView::Open shows them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <limits>

#include "lib/tools/view/recorded_testing.h"

namespace shoal::recorded_log_test {

using ::nlohmann::json;

std::unique_ptr<RecordedView> OpenOrFail(const std::string& path,
                                         const RecordedViewOptions& options = {}) {
  auto view = RecordedView::Open(path, options);
  EXPECT_TRUE(view.ok()) << view.error();
  return view.ok() ? std::move(*view) : nullptr;
}

bool HasNote(const RecordedView& view, std::string_view text) {
  for (const std::string& note : view.notes()) {
    if (note.find(text) != std::string::npos) return true;
  }
  return false;
}

TEST(OpenedLog, IsFoundInTheFolderOfARecording) {
  const TestDirectory directory;
  OpenTraffic(directory, TrafficMaker(1).Make(20));
  std::ofstream(directory.File("run.txt"))
      << "mission_file /somewhere/harbour.toml\nset mission.duration_s=77\n";
  const auto view = OpenOrFail(directory.File(""));
  EXPECT_EQ(view->mission().name, "harbour");
  EXPECT_EQ(view->mission().duration_s, 77);
  EXPECT_EQ(view->end_s(), 2);
  EXPECT_TRUE(view->notes().empty());
}

TEST(OpenedLog, IsAnErrorWhereThereIsNone) {
  const TestDirectory directory;
  const auto absent = RecordedView::Open(directory.File("no.lcm"));
  ASSERT_FALSE(absent.ok());
  EXPECT_NE(absent.error().find("no.lcm: No such file"), std::string::npos) << absent.error();
  const auto folder = RecordedView::Open(directory.File(""));
  ASSERT_FALSE(folder.ok());
  EXPECT_NE(folder.error().find("without a mission.lcm"), std::string::npos) << folder.error();
  std::ofstream(directory.File("text.lcm")) << "this is not a log";
  const auto text = RecordedView::Open(directory.File("text.lcm"));
  ASSERT_FALSE(text.ok());
  EXPECT_NE(text.error().find("text.lcm holds no event"), std::string::npos) << text.error();
}

TEST(OpenedLog, IsAnErrorWhereTheMissionFileNamedDoesNotLoad) {
  const TestDirectory directory;
  WriteLog(directory.File("a.lcm"), TrafficMaker(1).Make(5));
  std::ofstream(directory.File("bad.toml")) << "[mission]\nduration_s = 1\nsped = 3\n";
  const auto view =
      RecordedView::Open(directory.File("a.lcm"), {.mission_file = directory.File("bad.toml")});
  ASSERT_FALSE(view.ok());
  EXPECT_NE(view.error().find("bad.toml:3:1"), std::string::npos) << view.error();
}

TEST(OpenedLog, IsShownWithoutTheMissionBesideItThatDoesNotLoad) {
  const TestDirectory directory;
  WriteLog(directory.File("mission.lcm"), TrafficMaker(1).Make(20));
  std::ofstream(directory.File("mission.toml")) << "[mission]\nduration_s = -1\n";
  const auto view = OpenOrFail(directory.File(""));
  EXPECT_TRUE(HasNote(*view, "mission.toml:2"));
  EXPECT_TRUE(HasNote(*view, "without its mission"));
  EXPECT_EQ(view->mission().vehicles.size(), 3U);
}

TEST(OpenedLog, TakesVehiclesFromItsMessagesWhereItHasNoMission) {
  const TestDirectory directory;
  WriteLog(directory.File("sea.lcm"), TrafficMaker(2).Make(100));
  const auto view = OpenOrFail(directory.File("sea.lcm"));
  EXPECT_TRUE(HasNote(*view, "no mission.toml"));
  const json setup = json::parse(view->SetupJson(false));
  EXPECT_EQ(setup["mission"], "sea");
  EXPECT_EQ(setup["duration_s"], 10);
  EXPECT_EQ(setup["tick_s"], 0.1);
  ASSERT_EQ(setup["vehicles"].size(), 3U);
  EXPECT_EQ(setup["vehicles"][1]["name"], "Bravo");
  const json frame = json::parse(view->FrameJson(5));
  EXPECT_EQ(frame["vehicles"][2]["nav"]["t"], 5);
  EXPECT_EQ(frame["rules"]["critical_range_m"], 30);
}

TEST(OpenedLog, KnowsNoRulesUntilTheBrokerPublishesThem) {
  const TestDirectory directory;
  std::vector<TestEvent> events = TrafficMaker(2).Make(10);
  std::erase_if(events, [](const TestEvent& event) { return event.channel == "COMMS_RULES"; });
  WriteLog(directory.File("a.lcm"), events);
  const auto view = OpenOrFail(directory.File("a.lcm"));
  EXPECT_TRUE(json::parse(view->FrameJson(1))["rules"].is_null());
  EXPECT_EQ(view->mission().vehicles.size(), 3U);
}

TEST(OpenedLog, OfLcmLoggerIsShownInTheTimeOfItsMessages) {
  const TestDirectory directory;
  std::vector<TestEvent> events = TrafficMaker(3).Make(300);
  const auto plain = OpenTraffic(directory, events);
  uint32_t sequence = 0;
  for (TestEvent& event : events) {
    // The mission ran at twice the speed of the wall's clock.
    event.utime = 1'700'000'000'000'000 + event.utime / 2;
    AppendSeal({.publisher = "sim", .mission_id = 7, .step = 1, .sequence = ++sequence},
               MissionSecret{}, event.channel, &event.data);
  }
  WriteLog(directory.File("wall.lcm"), events);
  const auto wall = OpenOrFail(directory.File("wall.lcm"));
  EXPECT_TRUE(HasNote(*wall, "wall times"));
  EXPECT_EQ(wall->begin_s(), 0);
  EXPECT_EQ(wall->end_s(), 30);
  for (const double t_s : {3.0, 29.0, 11.5, 11.6}) {
    EXPECT_EQ(json::parse(wall->FrameJson(t_s)), json::parse(plain->FrameJson(t_s))) << t_s;
  }
  EXPECT_EQ(wall->EventsJson(), plain->EventsJson());
}

TEST(OpenedLog, CountsFromItsFirstEventWhereTheMissionIsAnother) {
  const TestDirectory directory;
  std::string text = kTrafficMissionText;
  text.replace(text.find("duration_s"), 0, "start_utime = 1600000000000000\n");
  std::ofstream(directory.File("m.toml")) << text;
  WriteLog(directory.File("a.lcm"), TrafficMaker(4).Make(30));
  const auto view = OpenOrFail(directory.File("a.lcm"), {.mission_file = directory.File("m.toml")});
  EXPECT_TRUE(HasNote(*view, "is it the log of another mission?"));
  EXPECT_EQ(view->begin_s(), 0);
  EXPECT_EQ(view->end_s(), 3);
}

TEST(OpenedLog, MayBeEmpty) {
  const TestDirectory directory;
  WriteLog(directory.File("a.lcm"), {});
  const auto view = OpenOrFail(directory.File("a.lcm"));
  EXPECT_TRUE(HasNote(*view, "the log is empty"));
  EXPECT_EQ(json::parse(view->FrameJson(5))["t"], 0);
  EXPECT_EQ(json::parse(view->EventsJson())["events"], json::array());
}

TEST(OpenedLog, EndsWhereItWasCut) {
  const TestDirectory directory;
  const auto whole = OpenTraffic(directory, TrafficMaker(5).Make(300));
  Bytes bytes = FileBytes(directory.File("mission.lcm"));
  bytes.resize(bytes.size() / 2);
  WriteBytes(directory.File("cut.lcm"), bytes);
  const auto cut = OpenOrFail(directory.File("cut.lcm"));
  EXPECT_TRUE(HasNote(*cut, "damaged in 1 place; "));
  EXPECT_TRUE(HasNote(*cut, "the log ends inside an event"));
  EXPECT_GT(cut->end_s(), 10);
  EXPECT_LT(cut->end_s(), 20);
  EXPECT_EQ(ComparableFrame(cut->FrameJson(9)), ComparableFrame(whole->FrameJson(9)));
}

TEST(OpenedLog, GoesOnBehindGarbage) {
  const TestDirectory directory;
  const auto whole = OpenTraffic(directory, TrafficMaker(6).Make(300));
  Bytes bytes = FileBytes(directory.File("mission.lcm"));
  std::fill_n(bytes.begin() + static_cast<ptrdiff_t>(bytes.size() / 2), 5000, uint8_t{0xed});
  WriteBytes(directory.File("mission.lcm"), bytes);
  const auto view = OpenOrFail(directory.File(""));
  EXPECT_TRUE(HasNote(*view, "damaged in 1 place; "));
  EXPECT_EQ(view->end_s(), 30);
  const json expected = json::parse(whole->FrameJson(29))["vehicles"];
  EXPECT_EQ(json::parse(view->FrameJson(29))["vehicles"], expected);
  EXPECT_EQ(json::parse(view->FrameJson(16))["vehicles"][0]["nav"]["t"], 16);
  EXPECT_EQ(json::parse(view->FrameJson(29))["vehicles"], expected);
}

TEST(OpenedLog, MayShrinkWhileItIsOpen) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(7).Make(300));
  std::filesystem::resize_file(directory.File("mission.lcm"), 3000);
  for (const double t_s : {29.0, 1.0, 15.0}) {
    EXPECT_EQ(json::parse(view->FrameJson(t_s))["t"], t_s);
    EXPECT_TRUE(json::accept(view->FatesJson({}, t_s)));
    EXPECT_TRUE(view->LinkJson("alpha", "bravo", t_s).ok());
  }
}

TEST(OpenedLog, KeepsItsEventsWhenAnotherFileTakesItsName) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(8).Make(300));
  const std::string before = view->FrameJson(25);
  WriteLog(directory.File("new.lcm"), TrafficMaker(9).Make(10));
  std::filesystem::rename(directory.File("new.lcm"), directory.File("mission.lcm"));
  view->FrameJson(3);
  EXPECT_EQ(view->FrameJson(25), before);
}

TEST(OpenedLog, OfTwoRunsShowsTheSecondBehindTheFirst) {
  const TestDirectory directory;
  std::vector<TestEvent> events = TrafficMaker(10).Make(300);
  const std::vector<TestEvent> second = TrafficMaker(11).Make(200);
  events.insert(events.end(), second.begin(), second.end());
  const auto view = OpenTraffic(directory, events);
  EXPECT_TRUE(HasNote(*view, "clock jumped in 1 place:"));
  EXPECT_GT(view->end_s(), 49);
  EXPECT_LE(view->end_s(), 50);
  const json frame = json::parse(view->FrameJson(view->end_s()));
  EXPECT_EQ(frame["vehicles"][0]["nav"]["t"], 20);
}

TEST(OpenedLog, NotesThatItHasNoPositions) {
  const TestDirectory directory;
  const auto view =
      OpenTraffic(directory, {{.utime = 5, .channel = "HELLO", .data = Bytes{1, 2, 3}}});
  EXPECT_TRUE(HasNote(*view, "no NAV"));
}

/// Calls everything, at a time that may be anything.
void AskAll(RecordedView& view, double t_s) {
  for (const std::string& answer :
       {view.SetupJson(false), view.FrameJson(t_s), view.TrailsJson(), view.LinksJson(t_s),
        view.FatesJson({}, t_s), view.EventsJson()}) {
    RC_ASSERT(json::accept(answer));
  }
  for (const char* name : {"alpha", "Bravo", "ship", "unknown", ""}) {
    const auto vehicle = view.VehicleJson(name, t_s, t_s);
    const auto link = view.LinkJson("alpha", name, t_s);
    if (vehicle.ok()) RC_ASSERT(json::accept(*vehicle));
    if (link.ok()) RC_ASSERT(json::accept(*link));
  }
}

RC_GTEST_PROP(OpenedLog, OfAnyBytesAndTimesIsAnsweredWithJson, ()) {
  const std::string path =
      ::testing::TempDir() + "shoal_hostile_" + std::to_string(::getpid()) + ".lcm";
  std::vector<TestEvent> events = TrafficMaker(12).Make(*rc::gen::inRange(1, 40));
  for (TestEvent& event : events) {
    const int what = *rc::gen::inRange(0, 12);
    if (what == 0) event.data = *rc::gen::arbitrary<Bytes>();
    if (what == 1 && !event.data.empty()) {
      event.data[*rc::gen::inRange(size_t{0}, event.data.size())] ^= 0xff;
    }
    if (what == 2) event.utime = *rc::gen::arbitrary<int64_t>();
    if (what == 3) {
      event.utime = *rc::gen::element(std::numeric_limits<int64_t>::min(),
                                      std::numeric_limits<int64_t>::max(), int64_t{0});
    }
  }
  WriteLog(path, events);
  auto view = RecordedView::Open(path);
  std::filesystem::remove(path);
  RC_ASSERT(view.ok());
  const double t_s = *rc::gen::arbitrary<double>();
  AskAll(**view, t_s);
  AskAll(**view, (*view)->end_s());
  AskAll(**view, (*view)->begin_s());
  RC_ASSERT((*view)->end_s() >= (*view)->begin_s());
}

}  // namespace shoal::recorded_log_test
