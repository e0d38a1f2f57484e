#include "lib/tools/view/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/contact.h"
#include "lib/comms/routing/decide.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/run/broker/broker_rules.h"
#include "lib/tools/view/view_limits.h"

namespace shoal {

namespace {

constexpr double kLongestVehicle_m = 1000;
constexpr size_t kMaxRecovered = 20;

/// Decodes into a message whose memory is used again; nullptr: the bytes do not decode.
template <class T>
T* DecodeAgain(std::span<const uint8_t> data) {
  thread_local T message;
  return Decode(data, &message) ? &message : nullptr;
}

void Cut(std::string* text) {
  if (text->size() > Scene::kMaxText) text->resize(Scene::kMaxText);
}

/// An empty text leaves the known one unchanged.
void Learn(const std::string& text, std::string* known) {
  if (!text.empty()) known->assign(text, 0, Scene::kMaxText);
}

bool AllNumbersMakeSense(const node_report_t& report) {
  const std::array<double, 10> numbers = {report.x_m,
                                          report.y_m,
                                          report.depth_m,
                                          report.altitude_m,
                                          report.lat_deg,
                                          report.lon_deg,
                                          report.speed_mps,
                                          report.heading_deg,
                                          report.speed_over_ground_mps,
                                          report.course_over_ground_deg};
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }) &&
         std::isfinite(report.length_m);
}

RulesInForce RulesOfMission(const Mission& mission) {
  RulesInForce rules{mission.comms, {}, {}};
  for (const Vehicle& vehicle : mission.vehicles) {
    if (vehicle.link_factors == LinkFactors{}) continue;
    rules.factors.emplace_back(vehicle.name, vehicle.link_factors);
  }
  return rules;
}

std::vector<std::string> NamesOf(const Mission& mission) {
  std::vector<std::string> names;
  for (const Vehicle& vehicle : mission.vehicles) names.push_back(vehicle.name);
  return names;
}

}  // namespace

Scene::Scene(const Mission& mission)
    : start_utime_(PlausibleUtime(mission.start_utime)),
      tick_us_(std::max<int64_t>(mission.tick_us, 1)),
      now_utime_(start_utime_),
      sound_mps_(mission.acoustics.options.sound_speed_mps),
      num_of_mission_(mission.vehicles.size()),
      rules_(RulesOfMission(mission)),
      links_(NamesOf(mission)),
      media_links_(MediaNamesOf(mission), NamesOf(mission)) {
  for (const Vehicle& vehicle : mission.vehicles) {
    const size_t place = vehicles_.size();
    channels_[channels::Nav(vehicle.name).name] = {Topic::kNav, place};
    channels_[channels::HelmState(vehicle.name).name] = {Topic::kHelm, place};
    channels_[channels::HelmCommand(vehicle.name).name] = {Topic::kCommand, place};
    channels_[channels::Swarm(vehicle.name).name] = {Topic::kSwarm, place};
    ForEachShownChannel([&]<class Row, size_t kRow>() {
      channels_[Row::ChannelOf(vehicle.name).name] = {Topic::kShown, place, kRow};
    });
    names_.Add(vehicle.name);
    vehicles_.push_back({.name = vehicle.name,
                         .type = vehicle.type,
                         .color = vehicle.color,
                         .group = vehicle.group,
                         .length_m = vehicle.length_m});
  }
  channels_[channels::NodeReportLocal().name] = {Topic::kReport, 0};
  channels_[channels::NodeReportFromOutside().name] = {Topic::kReport, 0};
  channels_[channels::CommsFates().name] = {Topic::kFates, 0};
  channels_[channels::CommsMedia().name] = {Topic::kMedia, 0};
  channels_[channels::CommsRules().name] = {Topic::kRules, 0};
  channels_[channels::ViewCommsPulse().name] = {Topic::kPulses, 0};
  for (const std::string_view topic : DrawingBook::Topics()) {
    channels_[std::string(topic)] = {Topic::kDrawings, 0};
  }
}

std::vector<std::string> Scene::Channels(const Mission& mission) {
  std::vector<std::string> names;
  for (const auto& [name, channel] : Scene(mission).channels_) names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

void Scene::Handle(std::string_view channel, std::span<const uint8_t> data,
                   SceneObserver* observer) {
  const auto known = channels_.find(channel);
  if (known == channels_.end()) return;
  const size_t place = known->second.vehicle;
  const bool is_understood = [&] {
    switch (known->second.topic) {
      case Topic::kNav:
        return HandleNav(place, data, observer);
      case Topic::kHelm:
        return HandleHelm(place, data, observer);
      case Topic::kCommand:
        return HandleCommand(place, data, observer);
      case Topic::kSwarm:
        return HandleSwarm(place, data);
      case Topic::kShown:
        return HandleShown(place, known->second.shown, data, observer);
      case Topic::kReport:
        return HandleReport(data, observer);
      case Topic::kFates:
        return HandleFates(data, observer);
      case Topic::kMedia:
        return HandleMedia(data, observer);
      case Topic::kRules:
        return HandleRules(data);
      case Topic::kPulses:
        return HandlePulses(data);
      case Topic::kDrawings:
        return drawings_.Take(channel, data, now_utime_);
    }
    return false;
  }();
  if (!is_understood) ++num_undecodable_;
}

void Scene::HandleClock(const clock_state_t& clock) {
  if (clock.step >= 0) MoveNow(PlausibleUtime(clock.utime));
}

const SceneVehicle* Scene::Find(std::string_view name) const {
  const int32_t place = names_.Find(name);
  return place < 0 ? nullptr : &vehicles_[static_cast<size_t>(place)];
}

const std::string* Scene::NameOf(std::string_view name) const {
  const int32_t number = links_.names().Find(name);
  if (number >= 0) return &links_.names().at(number);
  const SceneVehicle* vehicle = Find(name);
  return vehicle == nullptr ? nullptr : &vehicle->name;
}

bool Scene::IsStale(const SceneVehicle& vehicle) const {
  if (!vehicle.report || !rules_) return false;
  return shoal::IsStale(*rules_, vehicle.report->received_utime, now_utime_);
}

bool Scene::HandleCommand(size_t vehicle, std::span<const uint8_t> data, SceneObserver* observer) {
  const helm_command_t* command = DecodeAgain<helm_command_t>(data);
  if (command == nullptr) return false;
  if (observer != nullptr) observer->OnCommand(vehicle, *command);
  return true;
}

bool Scene::HandleNav(size_t vehicle, std::span<const uint8_t> data, SceneObserver* observer) {
  nav_t* nav = DecodeAgain<nav_t>(data);
  if (nav == nullptr) return false;
  nav->utime = PlausibleUtime(nav->utime);
  MoveNow(nav->utime);
  vehicles_[vehicle].nav = *nav;
  if (observer != nullptr) observer->OnNav(vehicle, *nav);
  return true;
}

bool Scene::HandleHelm(size_t vehicle, std::span<const uint8_t> data, SceneObserver* observer) {
  helm_state_t* helm = DecodeAgain<helm_state_t>(data);
  if (helm == nullptr) return false;
  helm->utime = PlausibleUtime(helm->utime);
  MoveNow(helm->utime);
  for (std::string* text :
       {&helm->vehicle, &helm->state, &helm->task, &helm->task_kind, &helm->all_stop}) {
    Cut(text);
  }
  vehicles_[vehicle].helm = *helm;
  if (observer != nullptr) observer->OnHelm(vehicle, *helm);
  return true;
}

bool Scene::HandleSwarm(size_t vehicle, std::span<const uint8_t> data) {
  swarm_t* swarm = DecodeAgain<swarm_t>(data);
  if (swarm == nullptr) return false;
  swarm->utime = PlausibleUtime(swarm->utime);
  MoveNow(swarm->utime);
  Cut(&swarm->vehicle);
  if (swarm->contacts.size() > kMaxContacts) swarm->contacts.resize(kMaxContacts);
  swarm->num_contacts = static_cast<int32_t>(swarm->contacts.size());
  for (swarm_contact_t& contact : swarm->contacts) {
    Cut(&contact.name);
    if (contact.recovered.size() > kMaxRecovered) contact.recovered.resize(kMaxRecovered);
    contact.num_recovered = static_cast<int32_t>(contact.recovered.size());
    for (std::string& field : contact.recovered) Cut(&field);
  }
  swarm->sources.clear();
  swarm->counts.clear();
  swarm->num_sources = swarm->num_counts = 0;
  vehicles_[vehicle].swarm = *swarm;
  return true;
}

bool Scene::HandleShown(size_t vehicle, size_t row, std::span<const uint8_t> data,
                        SceneObserver* observer) {
  bool is_understood = false;
  ForEachShownChannel([&]<class Row, size_t kRow>() {
    if (kRow != row) return;
    auto* message = DecodeAgain<typename Row::Message>(data);
    if (message == nullptr) return;
    is_understood = true;
    MoveNow(PlausibleUtime(message->utime));
    Row::Bound(message);
    size_t place = vehicle;
    if constexpr (requires { Row::VehicleOf(*message); }) {
      const int32_t found = names_.Find(Row::VehicleOf(*message));
      if (found < 0) return;
      place = static_cast<size_t>(found);
    }
    std::get<kRow>(vehicles_[place].shown) = *message;
    if (observer == nullptr) return;
    if constexpr (std::is_same_v<Row, ShownDecision>) observer->OnDecision(place, *message);
    if constexpr (std::is_same_v<Row, ShownNavigation>) observer->OnNavigation(place, *message);
  });
  return is_understood;
}

bool Scene::HandleReport(std::span<const uint8_t> data, SceneObserver* observer) {
  const node_report_t* report = DecodeAgain<node_report_t>(data);
  if (report == nullptr || !IsLegalVehicleName(report->name) || !AllNumbersMakeSense(*report)) {
    return false;
  }
  int32_t place = names_.Find(report->name);
  if (place < 0) {
    if (vehicles_.size() >= num_of_mission_ + kMaxOutside) {
      ++num_left_out_;
      return true;
    }
    place = names_.Add(report->name);
    vehicles_.push_back({.name = report->name, .outside = true});
  }
  SceneVehicle& vehicle = vehicles_[static_cast<size_t>(place)];
  Learn(report->type, &vehicle.type);
  Learn(report->color, &vehicle.color);
  Learn(report->group, &vehicle.group);
  if (report->length_m > 0) vehicle.length_m = std::min(report->length_m, kLongestVehicle_m);
  if (!vehicle.report) vehicle.report.emplace();
  vehicle.report->utime = PlausibleUtime(report->utime);
  vehicle.report->received_utime = now_utime_;
  vehicle.report->x_m = report->x_m;
  vehicle.report->y_m = report->y_m;
  vehicle.report->depth_m = report->depth_m;
  vehicle.report->heading_deg = report->heading_deg;
  vehicle.report->speed_mps = report->speed_mps;
  vehicle.report->index = report->index;
  vehicle.report->mode.assign(report->mode, 0, kMaxText);
  if (observer != nullptr) observer->OnReport(static_cast<size_t>(place), *vehicle.report);
  return true;
}

bool Scene::HandleFates(std::span<const uint8_t> data, SceneObserver* observer) {
  thread_local FatesView message;
  if (!ReadFates(data, &message)) return false;
  MoveNow(message.utime);
  links_.AddStrange(message.num_strange);
  for (const FateView& fate : message.all()) {
    const LinkPlace place = links_.Add(fate);
    if (fate.facts.has_path) packets_.Add(fate, PositionOf(fate.source));
    if (observer != nullptr) observer->OnFate(fate, place);
  }
  return true;
}

bool Scene::HandleMedia(std::span<const uint8_t> data, SceneObserver* observer) {
  const comms_media_t* media = DecodeAgain<comms_media_t>(data);
  if (media == nullptr) return false;
  MoveNow(PlausibleUtime(media->utime));
  FateView medium;
  for (const fate_medium_t& fate : media->media) {
    if (!ViewOf(fate, media->utime, &medium)) continue;
    media_links_.Add(medium);
    links_.AddMedium(medium);
    if (observer != nullptr) observer->OnMedium(medium);
  }
  return true;
}

bool Scene::HandleRules(std::span<const uint8_t> data) {
  const std::optional<BrokerRules> rules = ReadBrokerRules(data);
  if (!rules) return false;
  MoveNow(PlausibleUtime(rules->utime));
  rules_ = RulesInForce{rules->rules, {}, StrangeRules(*rules)};
  for (const RuleRow& row : kRuleTable) {
    const auto* text = std::get_if<std::string RoutingRules::*>(&row.member);
    if (text != nullptr) Cut(&((*rules_).**text));
  }
  for (const auto& [vehicle, factors] : rules->factors) {
    if (rules_->factors.size() == num_of_mission_ + kMaxOutside) break;
    rules_->factors.emplace_back(vehicle.substr(0, kMaxText), factors);
  }
  return true;
}

bool Scene::HandlePulses(std::span<const uint8_t> data) {
  if (!pulses_.Add(data)) return false;
  MoveNow(pulses_.last_utime());
  return true;
}

std::optional<std::pair<double, double>> Scene::PositionOf(std::string_view name) const {
  const SceneVehicle* vehicle = Find(name);
  if (vehicle == nullptr) return std::nullopt;
  if (vehicle->nav) return std::pair(vehicle->nav->x_m, vehicle->nav->y_m);
  if (vehicle->report) return std::pair(vehicle->report->x_m, vehicle->report->y_m);
  return std::nullopt;
}

void Scene::MoveNow(int64_t utime) {
  if (utime > now_utime_ || now_utime_ - utime > kOvertaking_us) now_utime_ = utime;
}

}  // namespace shoal
