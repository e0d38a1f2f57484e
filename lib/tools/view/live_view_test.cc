#include "lib/tools/view/live_view.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "lib/tools/view/view_testing.h"

namespace shoal::live_view_test {

using nlohmann::json;

class LiveViewTest : public testing::Test {
 protected:
  template <class T>
  void Handle(const std::string& channel, const T& message) {
    view_.Handle(channel, Encoded(message));
  }
  json Frame() { return json::parse(view_.FrameJson(0)); }
  json StreamFrame() { return json::parse(view_.StreamFrameJson()); }
  json Link(std::string_view from, std::string_view to) {
    const auto answer = view_.LinkJson(from, to, 0);
    EXPECT_TRUE(answer.ok());
    return answer.ok() ? json::parse(*answer) : json();
  }
  static clock_state_t Clock(std::string_view state) {
    clock_state_t clock{};
    clock.utime = 12'300'000;
    clock.step = 123;
    clock.state = state;
    clock.warp = 5;
    clock.factor = 4.98;
    return clock;
  }

  LiveView view_{MissionOf({"alpha", "bravo"}), "b00t"};
};

TEST(LiveViewWithoutMission, Waits) {
  LiveView view("b00t");
  EXPECT_EQ(json::parse(view.FrameJson(0))["clock"]["state"], "waiting");
  EXPECT_EQ(json::parse(view.SetupJson(false))["vehicles"], json::array());
  EXPECT_EQ(json::parse(view.SetupJson(false))["boot"], "b00t");
  EXPECT_FALSE(view.VehicleJson("alpha", 0, 1).ok());
}

TEST_F(LiveViewTest, ShowsTheSetupWithAndWithoutCommands) {
  EXPECT_EQ(json::parse(view_.SetupJson(true))["commands"], true);
  EXPECT_EQ(json::parse(view_.SetupJson(false))["commands"], false);
  EXPECT_EQ(json::parse(view_.SetupJson(false))["mode"], "live");
  EXPECT_EQ(json::parse(view_.SetupJson(false))["end_s"], 600);
}

TEST_F(LiveViewTest, FramesShowAllThatIsKnownOfAVehicle) {
  nav_t nav = NavAt(12'300'000, 1.234, -3.4);
  nav.heading_deg = 87.14;
  nav.speed_mps = 1.5;
  nav.speed_over_ground_mps = 1.52;
  nav.course_over_ground_deg = 88;
  Handle("NAV_ALPHA", nav);
  helm_state_t helm{};
  helm.utime = 12'300'000;
  helm.state = "DRIVE";
  helm.task = "survey";
  helm.task_kind = "waypoints";
  helm.all_stop = "clear";
  helm.waypoint_index = 1;
  helm.waypoint_x_m = 60;
  helm.waypoint_y_m = -160;
  helm.distance_m = 44;
  helm.cross_track_error_m = -0.3;
  Handle("HELM_STATE_ALPHA", helm);
  desired_t desired{};
  desired.utime = 12'300'000;
  desired.heading_deg = 90;
  desired.speed_mps = 1.5;
  Handle("DESIRED_ALPHA", desired);
  node_report_t report = ReportOf("alpha", 12'000'000, 1, -3.3);
  report.index = 24;
  Handle("NODE_REPORT_LOCAL", report);
  const json frame = Frame();
  EXPECT_EQ(frame["t"], 12.3);
  EXPECT_EQ(frame["step"], 123);
  ASSERT_EQ(frame["vehicles"].size(), 2U);
  EXPECT_EQ(frame["vehicles"][0], json::parse(R"({
      "name": "alpha", "type": "kayak", "color": "yellow", "group": "", "length_m": 3,
      "nav": {"t": 12.3, "x": 1.23, "y": -3.4, "depth": 0, "heading": 87.1, "speed": 1.5,
              "course": 88, "sog": 1.52, "pitch": 0, "roll": 0, "altitude": null},
      "report": {"t": 12, "x": 1, "y": -3.3, "depth": 0, "heading": 0, "speed": 0, "index": 24},
      "stale": false,
      "helm": {"t": 12.3, "state": "DRIVE", "task": "survey", "kind": "waypoints",
               "all_stop": "clear", "waypoint": 1, "laps": 0, "to": [60, -160, 0],
               "distance": 44, "cross_track": -0.3},
      "desired": {"heading": 90, "speed": 1.5, "depth": 0}, "modem": null, "decision": null, "guidance": null,
      "navigation": null, "mode": "DRIVE survey", "outside": false})"));
  EXPECT_EQ(frame["vehicles"][1], json::parse(R"({
      "name": "bravo", "type": "kayak", "color": "yellow", "group": "", "length_m": 3,
      "nav": null, "report": null, "stale": false, "helm": null, "desired": null, "decision": null, "guidance": null,
      "modem": null, "navigation": null, "mode": "",
      "outside": false})"));
}

TEST_F(LiveViewTest, FramesShowRulesPulsesPacketsAndCommands) {
  BrokerRules rules = RulesWith(0, 250, 5);
  rules.factors = {{"alpha", {.stealth = 0.5, .earange = 2}}};
  Handle("COMMS_RULES", ToMessage(rules));
  Handle("NAV_ALPHA", NavAt(12 * kSecond_us, 1, -3));
  Handle("VIEW_COMMS_PULSE", PulsesOf(12'100'000, {PulseOf("ALPHA2BRAVO", "nrep", 10)}));
  fate_t packet = Through(FateOf("alpha", "bravo", "delivered"), CalmPath(12 * kSecond_us));
  packet.kind = "packet";
  Handle("COMMS_FATES", FatesOf(12'500'000, {packet}));
  view_.SetCommands(
      {{.id = 3, .t_s = 12, .text = "return to alpha", .state = "taken", .reason = ""}});
  json frame = Frame();
  EXPECT_EQ(frame["rules"], json::parse(R"json({
      "comms_range_m": 250, "critical_range_m": 30, "stale_time_s": 5, "drop_percentage": 0,
      "reports_over": "direct", "messages_over": "direct",
      "factors": {"alpha": {"stealth": 0.5, "earange": 2}},
      "shown": {"comms_range": "250", "critical_range": "30", "stale_time": "5", "groups": "false",
                "msg_groups": "false", "ignore_group": "none", "min_rpt_interval": "off", "min_msg_interval": "30",
                "max_msg_length": "1000", "drop_percentage": "0",
                "shared_node_reports": "false", "pulse_duration": "10",
                "view_node_rpt_pulses": "true"}})json"));
  ASSERT_EQ(frame["pulses"].size(), 1U);
  EXPECT_TRUE(frame["pulses"][0]["id"].is_number_integer());
  frame["pulses"][0].erase("id");
  EXPECT_EQ(frame["pulses"][0], json::parse(R"({
      "t": 12.1, "from": [1, -3], "to": [80, 20], "width": 10, "duration": 10, "fill": 0.35,
      "label": "ALPHA2BRAVO", "kind": "report", "color": "orange"})"));
  EXPECT_EQ(frame["pulses_left_out"], 0);
  ASSERT_EQ(frame["packets"].size(), 1U);
  frame["packets"][0].erase("id");
  EXPECT_EQ(frame["packets"][0], json::parse(R"({
      "source": "alpha", "from": [1, -3], "sent": 12, "air": 0.4, "kind": "packet",
      "to": [{"name": "bravo", "arrives": 12.45, "cause": "delivered"}]})"));
  EXPECT_EQ(frame["commands"], json::parse(R"([
      {"id": 3, "t": 12, "text": "return to alpha", "state": "taken", "reason": ""}])"));
  EXPECT_EQ(frame["sound_mps"], 1500);
  EXPECT_EQ(frame["num_events"], 1) << "first contact";
  EXPECT_EQ(frame["num_fates"], 1);
}

TEST_F(LiveViewTest, StreamsEachPulseOnceAndMessagesFirst) {
  std::vector<comms_pulse_t> pulses;
  for (int i = 0; i < 250; ++i) pulses.push_back(PulseOf("R" + std::to_string(i), "nrep", 10));
  pulses.push_back(PulseOf("M", "msg", 10));
  Handle("VIEW_COMMS_PULSE", PulsesOf(0, pulses));
  json frame = StreamFrame();
  EXPECT_EQ(frame["pulses"].size(), LiveView::kMaxStreamPulses);
  EXPECT_EQ(frame["pulses"][0]["label"], "M");
  EXPECT_EQ(frame["pulses_left_out"], 51);
  frame = StreamFrame();
  EXPECT_TRUE(frame["pulses"].empty());
  EXPECT_EQ(frame["pulses_left_out"], 0);
  EXPECT_EQ(Frame()["pulses"].size(), 251U) << "a frame that is asked for has all";
  Handle("VIEW_COMMS_PULSE", PulsesOf(100'000, {PulseOf("R7", "nrep", 10)}));
  EXPECT_EQ(StreamFrame()["pulses"].size(), 1U);
}

TEST_F(LiveViewTest, ShowsWhatTheClockDoes) {
  EXPECT_EQ(Frame()["clock"]["state"], "gathering");
  clock_state_t clock = Clock("gathering");
  clock.num_awaited = 1;
  clock.awaited = {"helm_alpha"};
  clock.refusal = "no";
  Handle("CLOCK_STATE", clock);
  EXPECT_EQ(Frame()["clock"], json::parse(R"({"state": "gathering", "warp": 5, "factor": 4.98,
                                              "awaited": ["helm_alpha"], "note": "no"})"));
  Handle("CLOCK_STATE", Clock("paused"));
  EXPECT_EQ(Frame()["clock"]["state"], "paused");
  EXPECT_EQ(Frame()["t"], 12.3);
  Handle("CLOCK_STATE", Clock("ending"));
  EXPECT_EQ(Frame()["clock"]["state"], "ended");
  clock_state_t odd = Clock("dreaming");
  odd.warp = std::numeric_limits<double>::quiet_NaN();
  Handle("CLOCK_STATE", odd);
  EXPECT_EQ(Frame()["clock"]["state"], "running");
  EXPECT_TRUE(Frame()["clock"]["warp"].is_null());
  view_.SetClockGone("lost");
  Handle("NAV_ALPHA", NavAt(0, 0, 0));
  EXPECT_EQ(Frame()["clock"]["state"], "lost");
}

TEST_F(LiveViewTest, IsRunningWhereAnOldClockStatesNothing) {
  Handle("NAV_ALPHA", NavAt(kSecond_us, 0, 0));
  EXPECT_EQ(Frame()["clock"]["state"], "running");
  EXPECT_TRUE(Frame()["clock"]["warp"].is_null());
}

TEST_F(LiveViewTest, CountsItsChanges) {
  const int64_t before = view_.num_changes();
  Frame();
  EXPECT_EQ(view_.num_changes(), before);
  Handle("NAV_ALPHA", NavAt(kSecond_us, 0, 0));
  view_.SetCommands({});
  view_.SetClockGone("ended");
  EXPECT_EQ(view_.num_changes(), before + 3);
}

TEST_F(LiveViewTest, LinksShowWhichVehiclesReceiveEachOtherAndWhy) {
  fate_t delivered = FateOf("alpha", "bravo", "delivered");
  delivered.range_m = 18.2;
  delivered.limit_m = 250;
  fate_t far = FateOf("bravo", "alpha", "out_of_range");
  far.range_m = 312.4;
  far.limit_m = 250;
  Handle("COMMS_RULES", ToMessage(RulesWith(0, 250, 5)));
  Handle("COMMS_FATES", FatesOf(12'100'000, {delivered, far}));
  EXPECT_EQ(json::parse(view_.LinksJson(0)), json::parse(R"({
      "t": 12.1, "names": ["alpha", "bravo"],
      "links": [{"from": "alpha", "to": "bravo", "receives": true, "delivered": 1, "offered": 1,
                 "last_received_s": 12.1, "cause": "delivered", "text": "18.2 m of 250.0 m",
                 "t": 12.1},
                {"from": "bravo", "to": "alpha", "receives": false, "delivered": 0, "offered": 1,
                 "last_received_s": null, "cause": "out_of_range", "text": "312.4 m of 250.0 m",
                 "t": 12.1}]})"));
  Handle("NAV_ALPHA", NavAt(17'200'000, 0, 0));
  EXPECT_EQ(json::parse(view_.LinksJson(0))["links"][0]["receives"], false) << "that is long ago";
}

TEST_F(LiveViewTest, ShowsTheMediaOfLinksApart) {
  const fate_t by_radio = FateOf("alpha", "bravo", "delivered");
  fate_t by_sound = FateOf("alpha", "bravo", "packet_loss");
  by_sound.number = 1;
  const fate_t below = FateOf("bravo", "alpha", "submerged");
  const fate_t rule = FateOf("bravo", "alpha", "other_group");
  fate_medium_t depth = MediumOf(below, "vhf");
  depth.depth_m = 12;
  depth.depth_limit_m = 0.5;
  EXPECT_FALSE(json::parse(view_.LinksJson(0)).contains("media")) << "as before there were media";
  EXPECT_FALSE(view_.MediumLinksJson("vhf", 0).ok());
  Handle("COMMS_FATES", FatesOf(12'100'000, {by_radio, rule, below, by_sound}));
  Handle("COMMS_MEDIA",
         MediaOf(12'100'000, {MediumOf(by_radio, "vhf"), depth, MediumOf(by_sound, "acoustic")}));
  const json all = json::parse(view_.LinksJson(0));
  EXPECT_EQ(all["media"], (json{"vhf", "acoustic"}));
  EXPECT_EQ(all["links"][0]["offered"], 2);
  EXPECT_EQ(all["links"][1]["offered"], 2);
  EXPECT_EQ(all["links"][1]["text"], "depth 12.00 m of 0.50 m");
  const json vhf = json::parse(*view_.MediumLinksJson("vhf", 0));
  EXPECT_EQ(vhf["names"], all["names"]);
  ASSERT_EQ(vhf["links"].size(), 2U);
  EXPECT_EQ(vhf["links"][0]["offered"], 1);
  EXPECT_EQ(vhf["links"][0]["receives"], true);
  EXPECT_EQ(vhf["links"][1]["offered"], 1) << "the rule's is of no medium";
  const json acoustic = json::parse(*view_.MediumLinksJson("acoustic", 0));
  ASSERT_EQ(acoustic["links"].size(), 1U);
  EXPECT_EQ(acoustic["links"][0]["cause"], "packet_loss");
  EXPECT_NE(view_.MediumLinksJson("smoke", 0).error().find("vhf, acoustic"), std::string::npos);
}

TEST_F(LiveViewTest, FatesNameTheirMediumAndItsNumbers) {
  fate_t below = FateOf("alpha", "bravo", "submerged");
  fate_medium_t depth = MediumOf(below, "vhf");
  depth.depth_m = 12;
  depth.depth_limit_m = 0.5;
  Handle("COMMS_FATES", FatesOf(12'100'000, {FateOf("alpha", "bravo", "other_group"), below}));
  Handle("COMMS_MEDIA", MediaOf(12'100'000, {depth}));
  // The same transmission's number in a later step, and a fate that is not kept.
  Handle("COMMS_FATES", FatesOf(12'200'000, {below}));
  depth.depth_m = 13;
  Handle("COMMS_MEDIA",
         MediaOf(12'200'000, {MediumOf(FateOf("bravo", "alpha", "delivered"), "vhf"), depth}));
  const json fates = json::parse(view_.FatesJson({}, 0))["fates"];
  ASSERT_EQ(fates.size(), 3U);
  EXPECT_EQ(fates[0]["text"],
            "alpha to bravo: antenna submerged, depth 13.00 m of 0.50 m, over vhf");
  EXPECT_EQ(fates[0]["medium"], "vhf");
  EXPECT_EQ(fates[1]["text"],
            "alpha to bravo: antenna submerged, depth 12.00 m of 0.50 m, over vhf");
  EXPECT_EQ(fates[2]["text"], "alpha to bravo: other group");
  EXPECT_FALSE(fates[2].contains("medium"));
}

TEST_F(LiveViewTest, ShowsALinksHistory) {
  fate_t delivered = FateOf("alpha", "bravo", "delivered");
  delivered.range_m = 18;
  Handle("COMMS_FATES", FatesOf(500'000, {delivered, FateOf("bravo", "alpha", "delivered")}));
  Handle("COMMS_FATES", FatesOf(2'500'000, {FateOf("alpha", "bravo", "dropped")}));
  json link = Link("ALPHA", "bravo");
  EXPECT_EQ(link["from"], "alpha");
  EXPECT_EQ(link["causes"], (json{{"delivered", 1}, {"dropped", 1}}));
  EXPECT_EQ(link["by_kind"], json::parse(R"({"report": {"delivered": 1, "offered": 2}})"));
  EXPECT_EQ(link["ratio"], json::parse(R"({"t": [0, 2], "delivered": [1, 0], "offered": [1, 1]})"));
  EXPECT_EQ(link["range"], json::parse(R"({"t": [0.5], "range_m": [18], "limit_m": [null]})"));
  ASSERT_EQ(link["fates"].size(), 2U);
  EXPECT_EQ(link["fates"][0]["id"], 3);
  EXPECT_EQ(Link("alpha", "alpha")["fates"], json::array()) << "known vehicles without fates";
  Handle("NODE_REPORT", ReportOf("Visitor", 3'000'000, 7, 8));
  EXPECT_EQ(Link("alpha", "visitor")["to"], "Visitor") << "it has reported, but not in a link yet";
  EXPECT_FALSE(view_.LinkJson("alpha", "unknown", 0).ok());
  EXPECT_FALSE(view_.LinkJson(std::string(1'000'000, 'x'), "bravo", 0).ok());
}

TEST_F(LiveViewTest, ShowsFatesWithTheNumbersThatDecided) {
  fate_t far = FateOf("alpha", "bravo", "out_of_range");
  far.range_m = 312.4;
  far.limit_m = 250;
  far.number = 24;
  Handle("COMMS_FATES", FatesOf(12'100'000, {far}));
  EXPECT_EQ(json::parse(view_.FatesJson({}, 0)), json::parse(R"({
      "fates": [{"id": 1, "t": 12.1, "kind": "report", "source": "alpha", "destination": "bravo",
                 "count": 1, "number": 24, "cause": "out_of_range", "rule": "",
                 "text": "alpha to bravo: out of range, 312.4 m of 250.0 m",
                 "range_m": 312.4, "limit_m": 250}],
      "kinds": ["report"], "causes": ["out_of_range"], "forgotten": 0})"));
  EXPECT_TRUE(
      json::parse(view_.FatesJson(Asked([](FateQuery& q) { q.vehicle = "charlie"; }), 0))["fates"]
          .empty());
}

TEST_F(LiveViewTest, ChartsAVehicle) {
  desired_t desired{};
  desired.heading_deg = 90;
  Handle("DESIRED_ALPHA", desired);
  for (int t = 0; t < 10; ++t) {
    nav_t nav = NavAt(t * kSecond_us, 0, 0);
    nav.heading_deg = t;
    Handle("NAV_ALPHA", nav);
  }
  swarm_t swarm{};
  swarm.utime = 9 * kSecond_us;
  swarm.num_said = 14;
  swarm.num_contacts = 2;
  swarm.contacts.resize(2);
  swarm.contacts[0].name = "bravo";
  swarm.contacts[0].is_target = swarm.contacts[0].is_heard = swarm.contacts[0].is_known = 1;
  swarm.contacts[0].x_m = 1;
  swarm.contacts[0].report_utime = 4'800'000;
  swarm.contacts[0].num_recovered = 1;
  swarm.contacts[0].recovered = {"reporter_pos predict"};
  swarm.contacts[1].name = "charlie";
  Handle("SWARM_ALPHA", swarm);
  Handle("COMMS_FATES", FatesOf(9 * kSecond_us, {FateOf("bravo", "alpha", "delivered"),
                                                 FateOf("bravo", "alpha", "dropped")}));
  const auto answer = view_.VehicleJson("Alpha", 0, 3);
  ASSERT_TRUE(answer.ok());
  const json vehicle = json::parse(*answer);
  EXPECT_EQ(vehicle["name"], "alpha");
  EXPECT_EQ(vehicle["t"], json::parse("[6,7,8,9]"));
  EXPECT_EQ(vehicle["heading"], json::parse("[6,7,8,9]"));
  EXPECT_EQ(vehicle["desired_heading"], json::parse("[90,90,90,90]"));
  EXPECT_EQ(vehicle["altitude"], json::parse("[null,null,null,null]"));
  for (const char* column : {"speed", "desired_speed", "depth", "desired_depth"}) {
    EXPECT_EQ(vehicle[column], json::parse("[0,0,0,0]")) << column;
  }
  EXPECT_EQ(vehicle["swarm"], json::parse(R"({"t": 9, "num_sent": 14, "contacts": [
      {"name": "bravo", "target": true, "received": true, "known": true, "age_s": 4.2,
       "position": [1, 0, 0], "silent": false, "recovered": ["reporter_pos predict"]},
      {"name": "charlie", "target": false, "received": false, "known": false, "age_s": null,
       "position": null, "silent": false, "recovered": []}]})"));
  EXPECT_EQ(vehicle["receives_from"], json::parse(R"([{"name": "bravo", "last_received_s": 9}])"));
  const auto bravo = view_.VehicleJson("bravo", 0, 3);
  ASSERT_TRUE(bravo.ok());
  EXPECT_TRUE(json::parse(*bravo)["swarm"].is_null());
}

TEST_F(LiveViewTest, KeepsTrailsOfAllVehicles) {
  for (int t = 0; t < 3; ++t) {
    Handle("NAV_ALPHA", NavAt(t * kSecond_us, t, -1.126 * t));
    Handle("NODE_REPORT", ReportOf("visitor", 0, 7, t));
  }
  EXPECT_EQ(json::parse(view_.TrailsJson()), json::parse(R"({"begin_s": 0, "trails": {
      "alpha": [[0, 0, 0], [1, 1, -1.13], [2, 2, -2.25]], "bravo": [],
      "visitor": [[0, 7, 0], [1, 7, 1], [2, 7, 2]]}})"));
}

TEST_F(LiveViewTest, ShowsEvents) {
  helm_state_t helm{};
  helm.utime = 31'200'000;
  helm.state = "ALL-STOP";
  helm.all_stop = "all_stop command";
  Handle("HELM_STATE_BRAVO", helm);
  Handle("NAV_ALPHA", NavAt(31'300'000, 0, 0));
  Handle("NAV_BRAVO", NavAt(31'300'000, 2.1, 0));
  Handle("COMMS_FATES", FatesOf(31'400'000, {FateOf("visitor", "bravo", "delivered")}));
  EXPECT_EQ(json::parse(view_.EventsJson()), json::parse(R"({"events": [
      {"id": 1, "t": 31.2, "kind": "all_stop", "vehicles": ["bravo"],
       "text": "bravo: by command"},
      {"id": 2, "t": 31.3, "kind": "collision", "vehicles": ["alpha", "bravo"],
       "text": "alpha and bravo: 2.1 m, less than 3.0 m"},
      {"id": 3, "t": 31.4, "kind": "first_contact", "vehicles": ["bravo", "visitor"],
       "text": "bravo and visitor: first contact"}]})"));
  EXPECT_EQ(Frame()["num_events"], 3);
  Handle("COMMS_RULES", ToMessage(RulesWith(31'400'000, 100, 20)));
  Handle("NAV_ALPHA", NavAt(71'300'000, 0, 0));
  EXPECT_EQ(Frame()["num_events"], 3) << "twice the stale time is not over";
  Handle("NAV_ALPHA", NavAt(71'400'000, 0, 0));
  EXPECT_EQ(json::parse(view_.EventsJson())["events"][3]["kind"], "lost_contact");
}

TEST_F(LiveViewTest, AnswersWhileItReceives) {
  std::thread bus([this] {
    for (int i = 0; i < 2000; ++i) {
      Handle("NAV_ALPHA", NavAt(i * 100'000, i, 0));
      Handle("COMMS_FATES",
             FatesOf(i * 100'000, {FateOf("v" + std::to_string(i % 300), "bravo", "delivered")}));
    }
  });
  int64_t last_fates = 0;
  for (int i = 0; i < 200; ++i) {
    const json frame = StreamFrame();
    EXPECT_GE(frame["num_fates"], last_fates);
    last_fates = frame["num_fates"];
    EXPECT_TRUE(json::accept(view_.LinksJson(0)));
    EXPECT_TRUE(json::accept(view_.TrailsJson()));
    EXPECT_TRUE(json::accept(view_.EventsJson()));
  }
  bus.join();
  EXPECT_EQ(Frame()["num_fates"], 2000);
}

}  // namespace shoal::live_view_test
