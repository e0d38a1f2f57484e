#include "apps/viewer/mission_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/mission/file/load.h"
#include "lib/run/broker/broker_rules.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

constexpr int64_t kRulesRequestInterval_us = 500'000;
/// A broker that is not shoal's own may not answer.
constexpr int64_t kMaxRulesRequests = 20;
/// Messages that have waited for longer than this are dropped, but for a few of each channel: on a
/// machine that is too slow, the page shows fewer messages, not old ones.
constexpr int64_t kLongestQueue_us = 1'000'000;
constexpr int64_t kMaxMessagesAtOnce = 20'000;
/// The launcher publishes CLOCK_STATE twice per second, unless it is stopped or starved.
constexpr int64_t kClockSilence_us = 3'000'000;
/// What the vehicles' processes publish for each other is most of a mission's traffic, and is
/// needed only once per frame: it is read in large batches.
constexpr int64_t kCommunitiesInterval_us = 50'000;

/// Loads the mission as it runs; or makes one of what the registry holds of it.
Mission MissionOf(const RunningMission& running, std::vector<std::string>* notes) {
  LoadedMission loaded;
  if (running.file == running.playback_of) {
    loaded.errors.emplace_back("there is no mission.toml beside the recording");
  } else {
    loaded = LoadMission(running.file, running.overrides);
  }
  if (loaded.errors.empty()) {
    if (!running.playback_of.empty()) loaded.mission.name = running.name;
    return std::move(loaded.mission);
  }
  notes->push_back(fmt::format(
      "the mission file cannot be read, so that only names are known of the vehicles: {}",
      loaded.errors.front()));
  Mission mission;
  mission.file = running.file;
  mission.name = running.name;
  for (const std::string& name : running.vehicles) {
    Vehicle vehicle;
    vehicle.name = name;
    mission.vehicles.push_back(std::move(vehicle));
  }
  return mission;
}

bool AreEqual(const CommandRecord& a, const CommandRecord& b) {
  return a.id == b.id && a.state == b.state && a.reason == b.reason;
}

}  // namespace

MissionSession::MissionSession(const std::string& boot)
    : view_(std::make_unique<LiveView>(boot)), board_(0) {}

MissionSession::MissionSession(const RunningMission& running, const std::string& boot,
                               bool allow_commands)
    : running_(running),
      mission_(MissionOf(running, &notes_)),
      view_(std::make_unique<LiveView>(mission_, boot, notes_)),
      board_(mission_.start_utime),
      joined_(true),
      utime_(mission_.start_utime) {
  Join(allow_commands);
}

void MissionSession::Join(bool allow_commands) {
  const PortPlan ports = running_.Ports();
  bus_ = std::make_unique<LcmBus>(ports);
  bus_->set_mission_id(running_.mission_id);
  // A viewer of the same user can verify seals; `shore_broker --live` has no secret, and none.
  if (const auto secret = ReadSecretFile(SecretPath(running_.port_base)); secret.ok()) {
    secret_ = *secret;
    bus_->set_secret(*secret);
  }
  const std::vector<std::string> channel_names = Scene::Channels(mission_);
  for (const std::string& channel : channel_names) {
    if (ports.PortOf(channel) > ports.shore_port()) {
      if (!communities_) communities_ = std::make_unique<LcmReceiver>();
      communities_->Listen(ports.PortOf(channel), channel);
      continue;
    }
    bus_->SubscribeBytes(
        channel, [this](const Message& message) { view_->Handle(message.channel, message.data); });
  }
  bus_->SubscribeBytes(channels::ClockState().name,
                       [this](const Message& message) { TakeClock(message); });
  Subscribe(*bus_, channels::CommsRules(), [this](const broker_rules_t&) { has_rules_ = true; });
  bus_->SubscribeBytes(channels::CommsRulesNow().name,
                       [this](const Message& message) { TakeRules(message); });
  Subscribe(*bus_, channels::Appcast(),
            [this](const appcast_t& page) { board_.Take(page, now_us_); });
  if (!allow_commands) return;
  desk_ =
      std::make_unique<CommandDesk>(*bus_, OrderScope{.mission = running_.name,
                                                      .vehicles = running_.vehicles,
                                                      .mission_id = running_.mission_id,
                                                      .groups = running_.groups,
                                                      .is_playback = !running_.playback_of.empty(),
                                                      .orders = running_.orders});
}

std::string MissionSession::error() const {
  if (communities_ && !communities_->error().empty()) {
    return communities_->error();
  }
  return bus_ ? bus_->error() : "";
}

void MissionSession::TakeClock(const Message& message) {
  clock_state_t clock{};
  if (!Decode(message.data, &clock) || clock.mission_id != running_.mission_id) return;
  utime_ = clock.utime;
  is_ending_ = clock.state == "ending";
  clock_received_us_ = now_us_;
  view_->Handle(message.channel, message.data);
}

/// A viewer that joins late has missed COMMS_RULES; the answer to its request replaces it.
void MissionSession::TakeRules(const Message& message) {
  if (has_rules_ || !ReadBrokerRules(message.data)) return;
  has_rules_ = true;
  view_->Handle(channels::CommsRules().name, message.data);
}

void MissionSession::Work(int64_t now_us) {
  now_us_ = now_us;
  bus_->set_limits(
      {.most = kMaxMessagesAtOnce, .oldest_utime = UnixMicroseconds() - kLongestQueue_us});
  bus_->Poll(0);
  if (communities_ && now_us >= next_communities_us_) {
    next_communities_us_ = now_us + kCommunitiesInterval_us;
    const auto handle = [this](int, std::string_view channel, std::span<const uint8_t> datagram) {
      if (const auto message = MessageIn(channel, datagram)) view_->Handle(channel, *message);
    };
    communities_->Poll(0, -1, handle);
  }
  FollowAllChannels();
  if (clock_received_us_ != 0 && now_us - clock_received_us_ > kClockSilence_us) {
    clock_received_us_ = 0;
    view_->SetClockGone("silent");
  }
  if (!has_rules_ && rules_requests_ < kMaxRulesRequests && now_us >= next_rules_request_us_) {
    next_rules_request_us_ = now_us + kRulesRequestInterval_us;
    ++rules_requests_;
    comms_rules_req_t request{};
    request.asked_by = "viewer";
    Publish(*bus_, channels::CommsRulesReq(), request);
  }
  if (board_.WantsPages(now_us)) {
    appcast_req_t request{};
    request.app = "all";
    Publish(*bus_, channels::AppcastReq(), request);
  }
  if (desk_ == nullptr) return;
  desk_->OnTime(now_us);
  ShowCommands();
}

std::optional<std::span<const uint8_t>> MissionSession::MessageIn(
    std::string_view channel, std::span<const uint8_t> datagram) const {
  const Unsealed unsealed = Unseal(datagram);
  if (unsealed.seal && unsealed.seal->mission_id != running_.mission_id) return std::nullopt;
  if (secret_ && unsealed.seal && !IsGenuine(unsealed, *secret_, channel)) return std::nullopt;
  return unsealed.message;
}

void MissionSession::FollowAllChannels() {
  if (!channels_.Wants()) {
    all_channels_.reset();
    return;
  }
  if (!all_channels_) {
    all_channels_ = std::make_unique<LcmReceiver>();
    for (const int port : running_.Ports().DataPorts()) all_channels_->ListenToAll(port);
  }
  const double t_s = Seconds(utime_ - mission_.start_utime);
  all_channels_->Poll(0, -1, [&](int, std::string_view channel, std::span<const uint8_t> datagram) {
    const auto message = MessageIn(channel, datagram);
    if (message) channels_.Take(channel, *message, t_s);
  });
}

void MissionSession::ShowCommands() {
  std::vector<CommandRecord> records = desk_->records();
  if (std::equal(records.begin(), records.end(), shown_.begin(), shown_.end(), AreEqual)) return;
  shown_ = records;
  view_->SetCommands(std::move(records));
}

void MissionSession::Leave(std::string_view state) {
  {
    const std::lock_guard lock(desk_mutex_);
    desk_.reset();
  }
  bus_.reset();
  communities_.reset();
  all_channels_.reset();
  joined_ = false;
  view_->SetClockGone(state);
}

WebAnswer MissionSession::Command(const CommandWords& words) {
  const std::lock_guard lock(desk_mutex_);
  if (desk_ == nullptr) return ErrorAnswer(503, "no mission is running");
  const double t_s = Seconds(utime_ - mission_.start_utime);
  const Result<CommandRecord> record = desk_->Send(words.target, words.words, t_s);
  if (!record.ok()) return ErrorAnswer(400, record.error());
  const nlohmann::json json = {{"id", record->id}, {"text", record->text}};
  return {.body = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

}  // namespace shoal
