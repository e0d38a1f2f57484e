#include "lib/tools/rebroker/comms_log.h"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

#include "lib/bus/bus/seal.h"
#include "lib/tools/rebroker/comms_log_survey.h"

namespace shoal {

namespace {

constexpr int64_t kLongestTick_us = 1'000'000'000;

bool IsPossibleTick(int64_t tick_us) { return tick_us > 0 && tick_us <= kLongestTick_us; }

std::optional<size_t> FindChannel(std::string_view name) {
  static const auto* places = [] {
    auto* made = new std::map<std::string, size_t, std::less<>>;
    for (size_t i = 0; i < BrokerChannels().size(); ++i) made->emplace(BrokerChannels()[i], i);
    return made;
  }();
  const auto found = places->find(name);
  if (found == places->end()) return std::nullopt;
  return found->second;
}

}  // namespace

const std::vector<std::string>& BrokerChannels() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> made = {
        channels::NodeReportLocal().name,  channels::NodeReportFromOutside().name,
        channels::NodeMessageLocal().name, channels::NodeMessageFromOutside().name,
        channels::AckMessage().name,       channels::RelayTx().name,
        channels::AcousticTx().name,       channels::AcousticTxOn().name,
        channels::ModemTx().name,          channels::UncControls().name};
    for (const ControlRow& row : ControlTable()) made.push_back(channels::Control(row).name);
    std::sort(made.begin(), made.end());
    made.push_back(channels::CommsFates().name);
    made.push_back(channels::CommsRules().name);
    made.push_back(channels::UncControlsReq().name);
    return made;
  }();
  return names;
}

size_t NumBrokerInputs() { return BrokerChannels().size() - 3; }
size_t FatesChannel() { return NumBrokerInputs(); }
size_t RulesChannel() { return NumBrokerInputs() + 1; }
size_t RequestChannel() { return NumBrokerInputs() + 2; }
size_t ReportChannel() {
  static const size_t place = *FindChannel(channels::NodeReportLocal().name);
  return place;
}

size_t TruthChannel() { return BrokerChannels().size(); }

std::optional<int64_t> StepsLater(int64_t utime, int64_t steps, int64_t tick_us) {
  int64_t later = 0;
  if (__builtin_mul_overflow(steps, tick_us, &later) ||
      __builtin_add_overflow(utime, later, &later) || later < -kLatest_us || later > kLatest_us) {
    return std::nullopt;
  }
  return later;
}

std::optional<BrokerRules> RulesOfItem(const CommsLog& log, const CommsLogItem& item) {
  return ReadBrokerRules(std::span(log.bytes).subspan(item.begin, item.size));
}

void CommsLogBuilder::BeginLog() {
  previous_utime_.reset();
  latest_step_ = 0;
}

void CommsLogBuilder::Add(const LogEvent& event) {
  ++log_.num_events;
  if (event.utime < -kLatest_us || event.utime > kLatest_us) {
    ++log_.num_impossible;
    return;
  }
  const bool is_first = log_.num_events - log_.num_impossible == 1;
  log_.first_utime = is_first ? event.utime : std::min(log_.first_utime, event.utime);
  log_.last_utime = is_first ? event.utime : std::max(log_.last_utime, event.utime);
  if (previous_utime_) {
    const int64_t gap_us = event.utime - *previous_utime_;
    if (gap_us < 0) ++log_.num_backward;
    if (gap_us > 0 && (smallest_gap_us_ == 0 || gap_us < smallest_gap_us_)) {
      smallest_gap_us_ = gap_us;
    }
  }
  previous_utime_ = event.utime;

  const Unsealed unsealed = Unseal(event.data);
  const auto& [message, seal, tagged, tag] = unsealed;
  if (seal) {
    latest_step_ = seal->step;
    auto [last, is_new] = last_steps_.emplace(seal->mission_id, seal->step);
    last->second = std::max(last->second, seal->step);
  }
  std::optional<size_t> channel = FindChannel(event.channel);
  const bool is_truth = !channel && !VehicleOfChannel(event.channel, topics::kNav).empty();
  if (is_truth) channel = TruthChannel();
  if (!channel) return;
  CommsLogItem item{.utime = event.utime,
                    .step = latest_step_,
                    .channel = static_cast<uint8_t>(*channel),
                    .vehicle = is_truth ? TruthPlaceOf(std::string(event.channel)) : 0,
                    .begin = log_.bytes.size(),
                    .size = message.size()};
  if (seal) {
    item.mission_id = seal->mission_id;
    item.sequence = seal->sequence;
    const auto next = static_cast<uint32_t>(publishers_.size() + 1);
    auto found = publishers_.find(seal->publisher);
    if (found == publishers_.end()) found = publishers_.emplace(seal->publisher, next).first;
    item.publisher = found->second;
  }
  log_.bytes.insert(log_.bytes.end(), message.begin(), message.end());
  items_.push_back(item);
}

uint32_t CommsLogBuilder::TruthPlaceOf(const std::string& channel) {
  const auto next = static_cast<uint32_t>(log_.truth_channels.size());
  const auto [found, is_new] = truth_places_.try_emplace(channel, next);
  if (is_new) log_.truth_channels.push_back(channel);
  return found->second;
}

/// The message's own time: the step's, of what the broker publishes; of reports the position's,
/// which is a step earlier, or as early as its reporter likes.
std::optional<int64_t> CommsLogBuilder::UtimeOf(const CommsLogItem& item) const {
  if (item.channel == ReportChannel()) {
    if (const auto report = DecodeItem<node_report_t>(log_, item)) return report->utime;
  } else if (item.channel == FatesChannel()) {
    if (const auto fates = DecodeItem<comms_fates_t>(log_, item)) return fates->utime;
  } else if (item.channel == RulesChannel()) {
    if (const auto rules = RulesOfItem(log_, item)) return rules->utime;
  }
  return std::nullopt;
}

/// The time of the message's step, by what the broker publishes; of a log without any by reports,
/// which makes all times a step too early where these are of today's node_reporter.
std::optional<int64_t> CommsLogBuilder::StepUtimeOf(const CommsLogItem& item) const {
  if (has_words_of_broker_ && item.channel < NumBrokerInputs()) return std::nullopt;
  return UtimeOf(item);
}

CommsLog CommsLogBuilder::Build(std::optional<int64_t> tick_us) {
  has_words_of_broker_ = std::ranges::any_of(items_, [](const CommsLogItem& item) {
    return item.channel == FatesChannel() || item.channel == RulesChannel();
  });
  log_.time = KindOfTime();
  TakeTick(tick_us);
  if (log_.time == LogTime::kSeals) {
    RestoreSteps();
  } else {
    std::stable_sort(
        items_.begin(), items_.end(),
        [](const CommsLogItem& a, const CommsLogItem& b) { return a.utime < b.utime; });
  }
  if (log_.time == LogTime::kWall) GatherRounds();
  FindGaps(items_, &log_);
  for (const CommsLogItem& item : items_) {
    LoggedMessage message{
        .utime = item.utime, .channel = item.channel, .begin = item.begin, .size = item.size};
    if (item.channel == FatesChannel()) {
      log_.fates.push_back(message);
    } else if (item.channel < NumBrokerInputs() || item.channel == TruthChannel()) {
      if (log_.time != LogTime::kWall) {
        const auto handled = StepsLater(item.utime, 1, log_.tick_us);
        if (!handled) {
          ++log_.num_impossible;
          continue;
        }
        message.utime = *handled;
      }
      if (item.channel == TruthChannel()) {
        log_.truths.push_back({.utime = message.utime,
                               .vehicle = item.vehicle,
                               .begin = item.begin,
                               .size = item.size});
      } else {
        log_.inputs.push_back(message);
      }
    }
  }
  FindStarts(items_, &log_);
  return std::move(log_);
}

/// A live broker handles what has arrived together, and publishes its fates in one go: what came
/// shortly before COMMS_FATES was handled then.
void CommsLogBuilder::GatherRounds() {
  std::optional<int64_t> word_utime;
  for (auto item = items_.rbegin(); item != items_.rend(); ++item) {
    if (item->channel == FatesChannel()) {
      word_utime = item->utime;
    } else if (item->channel < NumBrokerInputs() && word_utime &&
               *word_utime - item->utime <= log_.tick_us) {
      item->utime = *word_utime;
    }
  }
}

LogTime CommsLogBuilder::KindOfTime() const {
  struct Count {
    int64_t all = 0;
    int64_t on_time = 0;
  };
  constexpr int64_t kEnough = 1000;
  int64_t num_sealed = 0;
  Count published_by_broker;
  Count published_by_others;
  std::optional<int64_t> report_age_us;
  for (const CommsLogItem& item : items_) {
    if (item.publisher != 0) ++num_sealed;
    const bool is_of_broker = item.channel >= NumBrokerInputs();
    Count& count = is_of_broker ? published_by_broker : published_by_others;
    if (count.all == kEnough) continue;
    const auto utime = UtimeOf(item);
    if (!utime) continue;
    ++count.all;
    // In a mission all reports have the same age when they are received. With wall clocks ages
    // differ.
    const int64_t age_us = item.utime - *utime;
    if (!is_of_broker && !report_age_us && (age_us == 0 || IsPossibleTick(age_us))) {
      report_age_us = age_us;
    }
    if (age_us == (is_of_broker ? 0 : report_age_us.value_or(0))) ++count.on_time;
  }
  if (2 * num_sealed > static_cast<int64_t>(items_.size())) return LogTime::kSeals;
  // Reports may have been made long before they were published; the broker's messages have its
  // time.
  const Count& count = published_by_broker.all > 0 ? published_by_broker : published_by_others;
  return 2 * count.on_time >= count.all ? LogTime::kMission : LogTime::kWall;
}

/// The tick is that of COMMS_RULES; else the user's; else what the times look like.
void CommsLogBuilder::TakeTick(std::optional<int64_t> tick_us) {
  for (const CommsLogItem& item : items_) {
    if (item.channel != RulesChannel()) continue;
    const auto rules = RulesOfItem(log_, item);
    if (!rules || !IsPossibleTick(rules->tick_us)) continue;
    log_.tick_us = rules->tick_us;
    return;
  }
  if (tick_us) {
    log_.tick_us = *tick_us;
    return;
  }
  log_.tick_is_guessed = true;
  if (log_.time == LogTime::kMission && IsPossibleTick(smallest_gap_us_)) {
    log_.tick_us = smallest_gap_us_;
  }
  if (log_.time != LogTime::kSeals) return;
  std::optional<std::pair<int64_t, int64_t>> first;  // Step and time.
  for (const CommsLogItem& item : items_) {
    const auto utime = StepUtimeOf(item);
    if (!utime || item.publisher == 0 || *utime < -kLatest_us || *utime > kLatest_us) continue;
    if (!first) first = {item.step, *utime};
    int64_t num_steps = 0;
    if (__builtin_sub_overflow(item.step, first->first, &num_steps) || num_steps == 0) continue;
    const int64_t guess = (*utime - first->second) / num_steps;
    if (!IsPossibleTick(guess)) continue;
    log_.tick_us = guess;
    return;
  }
}

/// Gives what has a seal the time of its step, and puts all into the fixed order.
void CommsLogBuilder::RestoreSteps() {
  // The mission is that of the first broker in the log, or of the first message.
  const CommsLogItem* of_mission = nullptr;
  for (const CommsLogItem& item : items_) {
    if (item.publisher == 0) continue;
    if (of_mission == nullptr) of_mission = &item;
    if (item.channel != RulesChannel()) continue;
    of_mission = &item;
    break;
  }
  const int64_t mission_id = of_mission->mission_id;
  int64_t zero_utime = 0;  // Of step 0.
  for (const CommsLogItem& item : items_) {
    if (item.publisher == 0 || item.mission_id != mission_id) continue;
    const auto utime = StepUtimeOf(item);
    if (!utime || item.step == std::numeric_limits<int64_t>::min()) continue;
    const auto zero = StepsLater(*utime, -item.step, log_.tick_us);
    if (!zero) continue;
    zero_utime = *zero;
    break;
  }
  std::erase_if(items_, [&](CommsLogItem& item) {
    if (item.publisher != 0 && item.mission_id != mission_id) {
      ++log_.num_foreign;
      return true;
    }
    const auto utime = StepsLater(zero_utime, item.step, log_.tick_us);
    if (!utime) {
      ++log_.num_impossible;
      return true;
    }
    item.utime = *utime;
    if (item.publisher == 0) ++log_.num_unsealed;
    return false;
  });
  log_.first_utime = zero_utime;
  log_.last_utime =
      StepsLater(zero_utime, last_steps_[mission_id], log_.tick_us).value_or(kLatest_us);
  DropRepeated();
}

void CommsLogBuilder::DropRepeated() {
  std::vector<uint32_t> ranks(publishers_.size() + 1);
  uint32_t rank = 0;
  for (const auto& [name, place] : publishers_) ranks[place] = ++rank;
  // Channels that the broker subscribes to are in order of their names, and the order of the others
  // among these does not matter.
  const auto key = [&](const CommsLogItem& item) {
    return std::tuple(item.step, item.channel, item.vehicle, ranks[item.publisher], item.sequence);
  };
  std::stable_sort(items_.begin(), items_.end(),
                   [&](const CommsLogItem& a, const CommsLogItem& b) { return key(a) < key(b); });
  const auto kept =
      std::unique(items_.begin(), items_.end(), [&](const CommsLogItem& a, const CommsLogItem& b) {
        return a.publisher != 0 && key(a) == key(b);
      });
  log_.num_repeated = items_.end() - kept;
  items_.erase(kept, items_.end());
}

}  // namespace shoal
