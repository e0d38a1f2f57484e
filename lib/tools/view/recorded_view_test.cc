#include "lib/tools/view/recorded_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <thread>

#include "lib/tools/view/live_view.h"
#include "lib/tools/view/recorded_testing.h"

namespace shoal::recorded_view_test {

using nlohmann::json;

constexpr int kSteps = 600;

/// Random steps of a log, to and fro.
std::vector<int> DrawSteps(uint32_t seed, int count) {
  std::mt19937 random(seed);
  std::vector<int> steps;
  for (int i = 0; i < count; ++i) {
    // Every third time a little later than before, as when a page plays.
    const bool plays = i % 3 != 0 && steps.back() < kSteps - 1;
    steps.push_back(plays ? steps.back() + 1 : std::uniform_int_distribution(0, kSteps)(random));
  }
  return steps;
}

/// What a running mission's view answers after each of some steps.
template <class Ask>
std::map<int, json> AnswersOfLive(const std::vector<TestEvent>& events, std::vector<int> steps,
                                  Ask ask) {
  std::map<int, json> answers;
  std::sort(steps.begin(), steps.end());
  LiveView live(TrafficMission(), "boot");
  size_t next = 0;
  for (const int step : steps) {
    for (; next < events.size() && events[next].utime <= step * kRecordedStep_us; ++next) {
      live.Handle(events[next].channel, events[next].data);
    }
    answers[step] = ask(live, step * 0.1);
  }
  return answers;
}

template <class Ask>
void ExpectSameAsLive(uint32_t seed, Ask ask) {
  const TestDirectory directory;
  const auto events = TrafficMaker(seed).Make(kSteps);
  const auto steps = DrawSteps(seed, 90);
  const auto expected = AnswersOfLive(events, steps, ask);
  const auto view = OpenTraffic(directory, events);
  for (const int step : steps) {
    ASSERT_EQ(ask(*view, step * 0.1), expected.at(step)) << "seed " << seed << " step " << step;
  }
}

TEST(RecordedView, ShowsTheFrameThatARunningMissionShowed) {
  for (const uint32_t seed : {1, 2, 3}) {
    ExpectSameAsLive(
        seed, [](ViewSource& view, double t_s) { return ComparableFrame(view.FrameJson(t_s)); });
  }
}

TEST(RecordedView, ShowsTheLinksThatARunningMissionShowed) {
  ExpectSameAsLive(4,
                   [](ViewSource& view, double t_s) { return json::parse(view.LinksJson(t_s)); });
}

TEST(RecordedView, ListsTheFatesThatARunningMissionListed) {
  ExpectSameAsLive(5, [](ViewSource& view, double t_s) {
    return json::parse(view.FatesJson({.vehicle = "alpha", .kind = {}, .cause = {}}, t_s));
  });
}

TEST(RecordedView, ShowsALinksHistoryAsARunningMissionDid) {
  ExpectSameAsLive(6, [](ViewSource& view, double t_s) {
    Result<std::string> answer = view.LinkJson("ALPHA", "bravo", t_s);
    EXPECT_TRUE(answer.ok());
    json link = json::parse(*answer);
    // Bins begin elsewhere; what they hold in all is the same.
    for (const char* what : {"delivered", "offered"}) {
      int64_t sum = 0;
      for (const json& each : link["ratio"][what]) sum += each.get<int64_t>();
      link[what] = sum;
    }
    EXPECT_LE(link["ratio"]["t"].size(), LinkHistory::kMaxBins);
    link.erase("ratio");
    return link;
  });
}

TEST(RecordedView, ShowsWhatAVehicleKnowsAsARunningMissionDid) {
  ExpectSameAsLive(7, [](ViewSource& view, double t_s) {
    Result<std::string> answer = view.VehicleJson("bravo", t_s, 60);
    EXPECT_TRUE(answer.ok());
    const json vehicle = json::parse(*answer);
    return json{vehicle["swarm"], vehicle["receives_from"]};
  });
}

TEST(RecordedView, DrawsTheTrailsThatARunningMissionDrew) {
  const TestDirectory directory;
  const auto events = TrafficMaker(8).Make(kSteps);
  const auto view = OpenTraffic(directory, events);
  const auto live = AnswersOfLive(events, {kSteps}, [](ViewSource& source, double) {
    return json::parse(source.TrailsJson());
  });
  const json trails = json::parse(view->TrailsJson());
  EXPECT_EQ(trails, live.at(kSteps));
  EXPECT_GT(trails["trails"]["ship"].size(), 1U);
}

TEST(RecordedView, FindsTheEventsThatARunningMissionFound) {
  const TestDirectory directory;
  const auto events = TrafficMaker(9).Make(kSteps);
  const auto view = OpenTraffic(directory, events);
  const auto sorted = [](const std::string& text) {
    std::vector<std::string> found;
    const json answer = json::parse(text);
    for (json event : answer["events"]) {
      event.erase("id");
      found.push_back(event.dump());
    }
    std::sort(found.begin(), found.end());
    return found;
  };
  const auto live = AnswersOfLive(events, {kSteps}, [&](ViewSource& source, double) {
    return json(sorted(source.EventsJson()));
  });
  EXPECT_EQ(json(sorted(view->EventsJson())), live.at(kSteps));
  const json found = json::parse(view->EventsJson())["events"];
  ASSERT_GT(found.size(), 5U);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                             [](const json& a, const json& b) { return a["t"] < b["t"]; }));
  // A frame counts those that are over.
  const double t_s = found[5]["t"];
  int64_t num_until = 0;
  for (const json& event : found) num_until += event["t"] <= t_s ? 1 : 0;
  EXPECT_EQ(json::parse(view->FrameJson(t_s))["num_events"], num_until);
}

TEST(RecordedView, ChartsTheWindowBeforeTheMoment) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(10).Make(kSteps));
  const json chart = json::parse(*view->VehicleJson("alpha", 30, 10));
  ASSERT_EQ(chart["t"].size(), 101U);
  EXPECT_EQ(chart["t"].front(), 20);
  EXPECT_EQ(chart["t"].back(), 30);
  EXPECT_EQ(chart["desired_heading"].size(), 101U);
  EXPECT_EQ(json::parse(*view->VehicleJson("alpha", 60, 3600))["t"].size(), 301U);
}

TEST(RecordedView, ShowsAMomentBetweenTwoStepsAsItIsThen) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(11).Make(kSteps));
  const json frame = json::parse(view->FrameJson(12.345));
  EXPECT_EQ(frame["t"], 12.345);
  EXPECT_EQ(frame["clock"]["state"], "recorded");
  EXPECT_EQ(frame["vehicles"][0]["nav"]["t"], 12.3);
}

TEST(RecordedView, ClampsAnyTimeToTheLog) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(12).Make(kSteps));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double t_s : {-1.0, -1e300, -kInfinity, std::nan("")}) {
    EXPECT_EQ(json::parse(view->FrameJson(t_s))["t"], 0) << t_s;
  }
  for (const double t_s : {61.0, 1e300, kInfinity}) {
    EXPECT_EQ(json::parse(view->FrameJson(t_s))["t"], 60) << t_s;
  }
  EXPECT_TRUE(view->VehicleJson("alpha", kInfinity, std::nan("")).ok());
  EXPECT_TRUE(view->VehicleJson("alpha", 3, -kInfinity).ok());
}

TEST(RecordedView, NamesTheVehicleThatTheLogDoesNotHave) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(13).Make(20));
  const std::string error = "no vehicle 'delta' in the log; there are: alpha, Bravo, c3";
  EXPECT_EQ(view->VehicleJson("delta", 1, 60).error(), error);
  EXPECT_EQ(view->LinkJson("alpha", "delta", 1).error(), error);
  EXPECT_EQ(view->LinkJson("delta", "alpha", 1).error(), error);
  EXPECT_LT(view->VehicleJson(std::string(1 << 20, 'x'), 1, 60).error().size(), 300U);
}

TEST(RecordedView, LetsTenPagesScrubAtOnce) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(14).Make(kSteps));
  std::vector<std::string> alone;
  for (int step = 0; step <= kSteps; ++step) alone.push_back(view->FrameJson(0.1 * step));
  std::vector<std::thread> pages;
  std::vector<int> num_wrong(10);
  for (uint32_t page = 0; page < num_wrong.size(); ++page) {
    pages.emplace_back([&, page] {
      for (const int step : DrawSteps(page, 60)) {
        num_wrong[page] += view->FrameJson(0.1 * step) == alone[static_cast<size_t>(step)] ? 0 : 1;
        (void)view->LinkJson("alpha", "bravo", 0.1 * step);
      }
    });
  }
  for (std::thread& page : pages) page.join();
  EXPECT_EQ(num_wrong, std::vector<int>(10));
}

TEST(RecordedView, ShowsTheSetupOfTheWholeLog) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, TrafficMaker(15).Make(kSteps));
  const json setup = json::parse(view->SetupJson(true));
  EXPECT_EQ(setup["mode"], "recorded");
  EXPECT_EQ(setup["commands"], false);
  EXPECT_EQ(setup["begin_s"], 0);
  EXPECT_EQ(setup["end_s"], 60);
  EXPECT_EQ(setup["vehicles"].size(), 3U);
  EXPECT_EQ(setup["notes"], json::array());
}

}  // namespace shoal::recorded_view_test
