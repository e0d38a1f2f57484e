#include "sim/mission_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "apps/recorder/recorder_app.h"
#include "lib/base/check/check.h"
#include "lib/bus/bus/channels.h"
#include "sim/app_factory.h"
#include "sim/director_app.h"

namespace shoal {

namespace {

constexpr int kMaxRestarts = 5;  ///< Of one participant, as in `shoal run`.

/// Asks for the first lines of an object, where apps and buses keep what every step needs: a step
/// meets each of thousands of participants once, after the caches have forgotten it.
void Prefetch(const void* object) {
  constexpr uintptr_t kLine_bytes = 64;
  constexpr uintptr_t kLines = 10;
  const auto begin = reinterpret_cast<uintptr_t>(object);
  for (uintptr_t i = 0; i < kLines; ++i) {
    // An address, since the object may be smaller: a pointer may not leave it.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    __builtin_prefetch(reinterpret_cast<const void*>(begin + i * kLine_bytes));
  }
}

/// Of Interests(): the first byte, then each channel, ended by '\n'.
constexpr uint8_t kReadsAll = '*';
constexpr uint8_t kReadsThese = ':';

}  // namespace

MissionPart::MissionPart(const Mission& mission, const Placement& placement, size_t part,
                         const std::string& log_path, const ChannelChoice& log_channels)
    : mission_(mission),
      placement_(placement),
      part_(part),
      tally_(is_shared() ? VehicleNames(mission) : std::vector<std::string>()),
      others_(placement.num_parts) {
  SHOAL_CHECK(part < placement.num_parts, "the part is one of its placement");
  // The same order in all parts: it numbers the participants.
  if (!log_path.empty()) {
    if (Bus* bus = Join("recorder", 0)) {
      Add(bus, std::make_unique<RecorderApp>(RecorderOptions{.path = log_path,
                                                             .start_utime = mission.start_utime,
                                                             .channels = log_channels},
                                             *bus));
    }
  }
  for (const RosterEntry& entry : MakeRoster(mission, false)) {
    Bus* bus = entry.vehicle.empty()
                   ? JoinBroker(entry.name)
                   : Join(entry.name, placement.part_of_vehicle[entry.vehicle_place]);
    if (bus != nullptr) Add(bus, Make(entry, *bus), entry);
  }
  if (Bus* bus = Join("shoal", 0)) {
    auto director = std::make_unique<DirectorApp>(
        mission, *bus,
        is_shared() ? DirectorApp::Fates::kAddedAtTheEnd : DirectorApp::Fates::kFromBus);
    director_ = director.get();
    Add(bus, std::move(director));
  }
  embedder_ = Join("embedder", 0);
  if (embedder_ != nullptr) Add(embedder_, nullptr);
}

MissionPart::~MissionPart() = default;

/// Returns nullptr for a participant of another part.
Bus* MissionPart::Join(const std::string& name, size_t part) {
  ++num_participants_;
  if (part == part_) return &hub_.Join(name);
  hub_.JoinElsewhere(name);
  return nullptr;
}

/// Of the broker: its bus in each part that routes a block of reports.
Bus* MissionPart::JoinBroker(const std::string& name) {
  if (placement_.part_of_block.empty()) return Join(name, placement_.broker_part);
  const bool is_here =
      part_ == placement_.broker_part || std::ranges::count(placement_.part_of_block, part_) > 0;
  if (!is_here) return Join(name, placement_.broker_part);
  ++num_participants_;
  return &hub_.JoinShared(name);
}

std::unique_ptr<App> MissionPart::Make(const RosterEntry& entry, Bus& bus) {
  if (!entry.vehicle.empty() || !is_shared()) return MakeApp(entry, mission_, bus);
  BrokerShare share = {.has_block = {},
                       .has_rest = part_ == placement_.broker_part,
                       .on_fates = [this](std::span<const fate_t> fates) { tally_.Take(fates); }};
  for (const size_t part : placement_.part_of_block) share.has_block.push_back(part == part_);
  return MakeSharedBroker(mission_, bus, std::move(share));
}

void MissionPart::Add(Bus* bus, std::unique_ptr<App> app, std::optional<RosterEntry> entry) {
  members_.push_back({.participant = num_participants_ - 1,
                      .bus = bus,
                      .app = std::move(app),
                      .entry = std::move(entry)});
}

Bytes MissionPart::Interests() const {
  Bytes interests = {hub_.has_listener() ? kReadsAll : kReadsThese};
  for (const std::string_view channel : hub_.SubscribedChannels()) {
    interests.insert(interests.end(), channel.begin(), channel.end());
    interests.push_back('\n');
  }
  return interests;
}

bool MissionPart::TakeInterests(size_t from, std::span<const uint8_t> interests) {
  if (interests.empty() || (interests[0] != kReadsAll && interests[0] != kReadsThese)) return false;
  Other& other = others_.at(from);
  other.reads_all = interests[0] == kReadsAll;
  std::string_view rest(reinterpret_cast<const char*>(interests.data()) + 1, interests.size() - 1);
  while (!rest.empty()) {
    const size_t end = rest.find('\n');
    if (end == std::string_view::npos) return false;
    other.channels.emplace(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  if (++num_interests_ + 1 == others_.size()) {
    hub_.KeepFor([this](std::string_view channel) {
      return std::ranges::any_of(others_, [&](const Other& each) { return Reads(each, channel); });
    });
  }
  return true;
}

bool MissionPart::Reads(const Other& other, std::string_view channel) {
  return other.channels.contains(channel) || (other.reads_all && IsLogged(channel));
}

void MissionPart::Step() {
  SHOAL_CHECK(!MustEnd(), "a mission that must end takes no step");
  SHOAL_CHECK(num_interests_ + 1 == others_.size(), "each part knows what the others read");
  ++step_;
  news_ = {};
  hub_.NextStep();
  TickMembers();
  news_.is_interrupted = is_interrupted_;
  news_.ends_mission = director_ != nullptr && director_->EndsMission();
  if (step_ % kStepsBetweenFaultChecks == 0) news_.fault = FindFault();
  if (placement_.num_parts > 1) WriteBatches();
}

void MissionPart::TickMembers() {
  constexpr size_t kAhead = 2;
  for (size_t i = 0; i < members_.size(); ++i) {
    if (i + kAhead < members_.size()) {
      Prefetch(members_[i + kAhead].bus);
      Prefetch(members_[i + kAhead].app.get());
    }
    Member& member = members_[i];
    hub_.Handle(*member.bus);
    if (!member.app) continue;
    member.app->Tick(utime());
    if (const std::string how = member.app->Crash(); !how.empty()) Lose(&member, how);
  }
}

/// As the supervision of `shoal run` does with a process that died.
void MissionPart::Lose(Member* member, const std::string& how) {
  const std::string name = member->entry ? member->entry->name : "a participant";
  const auto event = [member](std::string text) {
    return PartEvent{.participant = member->participant, .text = std::move(text)};
  };
  hub_.EndSubscriptions(*member->bus);
  member->app.reset();
  if (mission_.on_loss == OnLoss::kEnd) {
    news_.end_of_all = event(fmt::format("LOST: {}: {}; the mission ends without it", name, how));
  } else if (mission_.on_loss == OnLoss::kContinue || !member->entry) {
    news_.losses.push_back(
        event(fmt::format("LOST: {}: {}; the mission goes on without it", name, how)));
  } else if (++member->num_restarts > kMaxRestarts) {
    news_.end_of_all =
        event(fmt::format("{}: {}; it was restarted {} times already", name, how, kMaxRestarts));
  } else {
    member->app = Make(*member->entry, *member->bus);
    news_.losses.push_back(event(fmt::format("LOST: {}: {}; it starts again", name, how)));
  }
}

void MissionPart::WriteBatches() {
  for (Other& other : others_) other.writer.Begin(news_);
  hub_.VisitPublished([this](const MemoryBus::Published& each) {
    for (const size_t part : ReadersOf(each)) {
      others_[part].writer.Add({.participant = each.participant,
                                .channel = each.channel_number,
                                .sequence = each.sequence,
                                .data = each.data},
                               each.channel);
    }
  });
}

/// Returns the other parts that read a message's channel.
const std::vector<size_t>& MissionPart::ReadersOf(const MemoryBus::Published& message) {
  if (message.channel_number >= readers_.size()) readers_.resize(message.channel_number + 1);
  std::optional<std::vector<size_t>>& readers = readers_[message.channel_number];
  if (!readers) {
    readers.emplace();
    for (size_t part = 0; part < others_.size(); ++part) {
      if (Reads(others_[part], message.channel)) readers->push_back(part);
    }
  }
  return *readers;
}

std::span<const uint8_t> MissionPart::BatchFor(size_t part) const {
  return others_.at(part).writer.bytes();
}

bool MissionPart::TakeBatch(size_t from, std::span<const uint8_t> batch) {
  constexpr uint32_t kUnknown = 0xffffffff;
  Other& other = others_.at(from);
  PartNews news;
  if (!other.reader.Open(batch, &news)) return false;
  Merge(news, &news_);
  BatchMessage message;
  while (other.reader.Next(&message)) {
    if (message.participant >= num_participants_) return false;
    if (message.channel >= other.channel_numbers.size()) {
      other.channel_numbers.resize(message.channel + 1, kUnknown);
    }
    uint32_t& channel = other.channel_numbers[message.channel];
    if (channel == kUnknown) {
      channel = hub_.ChannelNumber(other.reader.ChannelName(message.channel));
    }
    hub_.Insert(message.participant, channel, message.sequence, message.data);
  }
  return other.reader.IsWhole();
}

void MissionPart::Decide() {
  for (const PartEvent& loss : news_.losses) losses_.push_back(loss.text);
}

bool MissionPart::MustEnd() const {
  return step_ == mission_.LastStep() || news_.ends_mission || news_.is_interrupted ||
         news_.end_of_all || news_.fault;
}

void MissionPart::End() {
  hub_.NextStep();
  for (const Member& member : members_) {
    hub_.Handle(*member.bus);
    if (member.app) member.app->End();
  }
  if (is_shared() && director_ != nullptr) {
    SHOAL_CHECK(director_->AddFates(FatesForFirst()), "a part's own counts are whole");
  }
}

Bytes MissionPart::FatesForFirst() const {
  Bytes fates;
  tally_.AppendTo(&fates);
  return fates;
}

bool MissionPart::TakeFates(std::span<const uint8_t> fates) { return director_->AddFates(fates); }

void MissionPart::Abandon() {
  for (const Member& member : members_) {
    if (member.app) member.app->End();
  }
}

std::optional<PartEvent> MissionPart::FindFault() const {
  for (const Member& member : members_) {
    if (!member.app) continue;
    if (std::string fault = member.app->Fault(); !fault.empty()) {
      return PartEvent{.participant = member.participant, .text = std::move(fault)};
    }
  }
  return std::nullopt;
}

std::string MissionPart::Fault() const {
  if (news_.end_of_all) return news_.end_of_all->text;
  if (news_.fault) return news_.fault->text;
  const std::optional<PartEvent> fault = FindFault();
  return fault ? fault->text : std::string();
}

}  // namespace shoal
