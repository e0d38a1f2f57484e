// A view answers valid JSON of bounded size for any message on the bus.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "lib/tools/view/live_view.h"
#include "lib/tools/view/view_testing.h"

namespace shoal::hostile_test {

using nlohmann::json;

/// Returns whether all answers are JSON.
bool AnswersAreJson(LiveView* view) {
  const auto vehicle = view->VehicleJson("alpha", 0, 3600);
  const auto link = view->LinkJson("alpha", "bravo", 0);
  return json::accept(view->StreamFrameJson()) && json::accept(view->FrameJson(0)) &&
         json::accept(view->TrailsJson()) && json::accept(view->LinksJson(0)) &&
         json::accept(view->FatesJson(Asked([](FateQuery& q) { q.limit = 500; }), 0)) &&
         json::accept(view->EventsJson()) && vehicle.ok() && json::accept(*vehicle) && link.ok() &&
         json::accept(*link);
}

std::vector<std::string> AllChannels(const Mission& mission) {
  std::vector<std::string> channels = Scene::Channels(mission);
  channels.push_back("CLOCK_STATE");
  return channels;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double DrawDouble() {
  return *rc::gen::element(0.0, -0.0, 1.5, -1e300, 1e300, kNan, kInfinity, -kInfinity, 5e-324);
}

int64_t DrawUtime() {
  return *rc::gen::element<int64_t>(0, 1, -1, 100'000, 10'000'000, 60'000'000,
                                    std::numeric_limits<int64_t>::max(),
                                    std::numeric_limits<int64_t>::min());
}

/// Returns any text that LCM can encode: one without a zero.
std::string DrawText() {
  std::string text = *rc::gen::oneOf(
      rc::gen::element<std::string>("", "alpha", "bravo", "*", "ALL-STOP", "delivered", "damaged",
                                    "collision", "report", "packet", "msg", "\xff\xfe\"\\\n\x01",
                                    std::string(5000, '\x80')),
      rc::gen::container<std::string>(rc::gen::arbitrary<char>()));
  std::erase(text, '\0');
  return text;
}

/// Returns an encoded message of the channel's type with hostile members.
Bytes DrawMessage(const std::string& channel) {
  if (channel.starts_with("NAV_")) {
    nav_t nav = NavAt(DrawUtime(), DrawDouble(), DrawDouble());
    nav.z_m = DrawDouble();
    nav.heading_deg = DrawDouble();
    nav.altitude_m = DrawDouble();
    return Encoded(nav);
  }
  if (channel.starts_with("HELM_STATE_")) {
    helm_state_t helm{};
    helm.utime = DrawUtime();
    helm.state = DrawText();
    helm.all_stop = DrawText();
    helm.waypoint_x_m = DrawDouble();
    helm.distance_m = DrawDouble();
    return Encoded(helm);
  }
  if (channel.starts_with("NODE_REPORT")) {
    node_report_t report = ReportOf(DrawText(), DrawUtime(), DrawDouble(), DrawDouble());
    report.mode = DrawText();
    report.color = DrawText();
    report.length_m = DrawDouble();
    return Encoded(report);
  }
  if (channel == "COMMS_FATES") {
    fate_t fate = FateOf(DrawText(), DrawText(), DrawText());
    fate.kind = *rc::gen::element<std::string>("report", "packet", "odd");
    fate.cause = *rc::gen::oneOf(rc::gen::just(fate.cause),
                                 rc::gen::map(rc::gen::inRange(0, kNumCauses), [](int cause) {
                                   return std::string(CauseText(static_cast<Cause>(cause)));
                                 }));
    fate.count = *rc::gen::arbitrary<int32_t>();
    fate.range_m = DrawDouble();
    fate.limit_m = DrawDouble();
    fate.age_s = DrawDouble();
    if (*rc::gen::arbitrary<bool>()) {
      acoustic_path_t path = CalmPath(DrawUtime());
      path.travel_s = DrawDouble();
      path.loss_probability = DrawDouble();
      path.num_colliders = *rc::gen::arbitrary<int32_t>();
      path.num_named = 1;
      path.colliders = {DrawText()};
      fate = Through(fate, path);
    }
    return Encoded(FatesOf(DrawUtime(), {fate, fate}));
  }
  if (channel == "COMMS_MEDIA") {
    fate_medium_t fate = MediumOf(FateOf(DrawText(), DrawText(), DrawText()), DrawText());
    fate.kind = *rc::gen::element<std::string>("report", "packet", "odd");
    fate.cause = *rc::gen::element<std::string>("delivered", "submerged", "weak_signal", "odd");
    fate.number = *rc::gen::arbitrary<int64_t>();
    fate.hop = *rc::gen::arbitrary<int32_t>();
    fate.depth_m = DrawDouble();
    fate.depth_limit_m = DrawDouble();
    fate.path_loss_db = DrawDouble();
    fate.delay_s = DrawDouble();
    return Encoded(MediaOf(DrawUtime(), {fate, fate}));
  }
  if (channel == "VIEW_COMMS_PULSE") {
    comms_pulse_t pulse = PulseOf(DrawText(), DrawText(), DrawDouble());
    pulse.fill_color = DrawText();
    pulse.sx_m = DrawDouble();
    pulse.fill = DrawDouble();
    return Encoded(PulsesOf(DrawUtime(), {pulse}));
  }
  if (channel == "VIEW_POLYGON") {
    view_polygon_t polygon{};
    polygon.owner = DrawText();
    polygon.label = DrawText();
    polygon.color = DrawText();
    polygon.life_s = DrawDouble();
    polygon.fill = DrawDouble();
    polygon.num_points = 2;
    polygon.x_m = {DrawDouble(), 1};
    polygon.y_m = {DrawDouble(), 2};
    return Encoded(polygon);
  }
  if (channel == "COMMS_RULES") {
    BrokerRules rules = RulesWith(DrawUtime(), DrawDouble(), DrawDouble());
    rules.factors = {{DrawText(), {.stealth = DrawDouble()}}};
    broker_rules_t message = ToMessage(rules);
    const size_t place = *rc::gen::inRange<size_t>(0, message.rules.size());
    message.rules[place].key = DrawText();
    message.rules[place].number = DrawDouble();
    return Encoded(message);
  }
  if (channel.starts_with("SWARM_")) {
    swarm_t swarm{};
    swarm.utime = DrawUtime();
    swarm.num_contacts = 1;
    swarm.contacts.resize(1);
    swarm.contacts[0].name = DrawText();
    swarm.contacts[0].is_heard = 1;
    swarm.contacts[0].is_known = 1;
    swarm.contacts[0].x_m = DrawDouble();
    swarm.contacts[0].report_utime = DrawUtime();
    return Encoded(swarm);
  }
  if (channel == "CLOCK_STATE") {
    clock_state_t clock{};
    clock.utime = DrawUtime();
    clock.step = *rc::gen::element<int64_t>(-1, 0, 5);
    clock.state = DrawText();
    clock.warp = DrawDouble();
    clock.refusal = DrawText();
    return Encoded(clock);
  }
  desired_t desired{};
  desired.utime = DrawUtime();
  desired.heading_deg = DrawDouble();
  return Encoded(desired);
}

RC_GTEST_PROP(HostileBus, AnswersWithJsonForAnyMessages, ()) {
  const Mission mission = MissionOf({"alpha", "bravo"});
  LiveView view(mission, "boot");
  const std::vector<std::string> channels = AllChannels(mission);
  const int num_messages = *rc::gen::inRange(0, 60);
  for (int i = 0; i < num_messages; ++i) {
    const std::string channel = *rc::gen::elementOf(channels);
    view.Handle(channel, DrawMessage(channel));
  }
  RC_ASSERT(AnswersAreJson(&view));
}

RC_GTEST_PROP(HostileBus, AnswersWithJsonForAnyBytes, ()) {
  const Mission mission = MissionOf({"alpha", "bravo"});
  LiveView view(mission, "boot");
  for (const std::string& channel : AllChannels(mission)) {
    Bytes bytes = DrawMessage(channel);
    const int num_changes = *rc::gen::inRange(0, 4);
    for (int i = 0; i < num_changes; ++i) {
      bytes[*rc::gen::inRange<size_t>(0, bytes.size())] = *rc::gen::arbitrary<uint8_t>();
    }
    bytes.resize(*rc::gen::inRange<size_t>(bytes.size() / 2, bytes.size() + 2));
    view.Handle(channel, bytes);
    view.Handle(channel, *rc::gen::arbitrary<Bytes>());
  }
  RC_ASSERT(AnswersAreJson(&view));
}

TEST(HostileBus, CannotMakeFramesGrowWithoutEnd) {
  LiveView view(MissionOf({"alpha", "bravo"}), "boot");
  const std::string long_text(100'000, 'x');
  std::vector<comms_pulse_t> pulses;
  for (int i = 0; i < 5000; ++i) {
    pulses.push_back(PulseOf("P" + std::to_string(i), "nrep", 1e300));
    pulses.back().fill_color = std::string(200, 'c');
  }
  view.Handle("VIEW_COMMS_PULSE", Encoded(PulsesOf(0, pulses)));
  for (int i = 0; i < 1000; ++i) {
    node_report_t report = ReportOf("v" + std::to_string(i), 0, 0, 0);
    report.mode = report.color = report.type = report.group = long_text;
    view.Handle("NODE_REPORT", Encoded(report));
    fate_t fate = Through(FateOf("v" + std::to_string(i), long_text, "collision"), CalmPath(0));
    fate.number = i;
    view.Handle("COMMS_FATES", Encoded(FatesOf(0, {fate})));
  }
  BrokerRules rules = RulesWith(0, 1, 1);
  for (int i = 0; i < 2000; ++i) {
    rules.factors.emplace_back(std::string(300, 'f') + std::to_string(i), LinkFactors());
  }
  broker_rules_t message = ToMessage(rules);
  for (int i = 0; i < 2000; ++i) {
    message.rules.push_back(message.rules.front());
    message.rules.back().key = std::string(300, 'k') + std::to_string(i);
  }
  message.num_rules = static_cast<int32_t>(message.rules.size());
  view.Handle("COMMS_RULES", Encoded(message));
  view.SetCommands(std::vector<CommandRecord>(1000));
  const std::string frame = view.FrameJson(0);
  EXPECT_LT(frame.size(), 2'500'000U);
  const json read = json::parse(frame);
  EXPECT_EQ(read["vehicles"].size(), 2 + Scene::kMaxOutside);
  EXPECT_EQ(read["pulses"].size(), PulseBook::kMaxPulses);
  EXPECT_EQ(read["packets"].size(), PacketBook::kMaxPackets);
  EXPECT_EQ(read["commands"].size(), 20U);
  EXPECT_LT(view.StreamFrameJson().size(), 800'000U);
}

}  // namespace shoal::hostile_test
