#include "lib/tools/view/kept_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "lib/base/codec/little_endian.h"
#include "lib/base/time/time_units.h"
#include "lib/bus/record/file_window.h"
#include "lib/mission/file/load.h"

namespace shoal {

namespace {

/// Another one wherever IndexArchive, or what is worked out of a log, changes.
constexpr int kViewIndexFormat = 3;
constexpr size_t kMaxIndexText_bytes = 10'000;
constexpr size_t kMaxIndexVehicles = 5000;
constexpr size_t kMaxTroubles = 100;
constexpr size_t kMaxStanding = 1'000'000;
constexpr int64_t kLongestLine_us = 4 * kFarthest_us;

}  // namespace

/// Writes all of an index, or reads it: the same members in the same order.
class IndexArchive {
 public:
  IndexArchive() = default;
  IndexArchive(std::span<const uint8_t> bytes, const Scene& blank, uint64_t log_size)
      : reader_(bytes), blank_(&blank), log_size_(log_size) {}

  /// False: what was read is no index.
  bool ok() const { return ok_; }
  bool is_at_end() const { return reader_->num_left() == 0; }
  std::vector<uint8_t> Take() { return std::move(bytes_); }

  void All(KeptIndex& kept) {
    LogIndex& index = kept.index;
    Within(index.begin_us, -kLongestLine_us, kLongestLine_us);
    Within(index.end_us, -kLongestLine_us, kLongestLine_us);
    Require(index.begin_us <= index.end_us);
    Within(index.longest_pulse_us, 0, 60 * kSecond_us);
    Counts(index.num_events, index.num_undecodable, index.num_odd_times, index.num_shifts);
    Flag(index.has_nav);
    Each(index.strange_rules, kMaxTroubles, 4, [&](std::string& text) { Text(text); });
    Each(kept.vehicles, kMaxIndexVehicles, 4, [&](std::string& text) { Text(text); });
    Each(kept.troubles, kMaxTroubles, 4, [&](std::string& text) { Text(text); });
    Each(index.trails, kMaxIndexVehicles, 4, [&](Trail& trail) { One(trail); });
    Each(index.charts, kMaxIndexVehicles, 4, [&](RecordedChart& chart) { One(chart); });
    Each(index.events, EventWatch::kMaxEvents, 10, [&](ViewEvent& event) { One(event); });
    size_t count = index.keyframes.size();
    Count(count, LogIndex::kMaxKeyframes + 1, 100);
    Require(count > 0);
    for (size_t i = 0; i < count && ok_; ++i) {
      if (reader_) {
        index.keyframes.push_back(
            {.timeline = RecordedTimeline(0), .links = {}, .media_links = {}, .standing = {}});
      }
      One(index.keyframes[i]);
      Require(i == 0 || index.keyframes[i - 1].offset <= index.keyframes[i].offset);
    }
    names_.reset();
  }

 private:
  void Require(bool is_right) { ok_ = ok_ && is_right; }

  template <class T>
  void Number(T& number) {
    static_assert(std::is_arithmetic_v<T>);
    if (!reader_) {
      AppendLittleEndian(number, &bytes_);
    } else if (!ok_ || !reader_->Take(&number)) {
      ok_ = false;
      number = T();
    }
  }
  template <class... T>
  void Numbers(T&... numbers) {
    (Number(numbers), ...);
  }
  template <class T>
  void Within(T& number, std::type_identity_t<T> least, std::type_identity_t<T> most) {
    Number(number);
    Require(number >= least && number <= most);
    if (!ok_) number = least;
  }
  template <class... T>
  void Counts(T&... counts) {
    (Within(counts, 0, std::numeric_limits<T>::max() / 4), ...);
  }
  void Flag(bool& flag) {
    auto number = static_cast<uint8_t>(flag);
    Within(number, 0, 1);
    flag = number != 0;
  }
  /// An enumerator below `num`.
  template <class Enum>
  void Choice(Enum& choice, int num) {
    auto number = static_cast<uint8_t>(choice);
    Within(number, 0, static_cast<uint8_t>(num - 1));
    choice = static_cast<Enum>(number);
  }
  void Text(std::string& text) {
    if (!reader_) {
      AppendSizedText(std::string_view(text).substr(0, kMaxIndexText_bytes), &bytes_);
    } else if (!ok_ || !reader_->TakeSizedText(&text) || text.size() > kMaxIndexText_bytes) {
      ok_ = false;
      text.clear();
    }
  }
  /// Of elements that have `least_bytes` each.
  void Count(size_t& count, size_t most, size_t least_bytes) {
    auto number = static_cast<uint32_t>(count);
    Number(number);
    Require(number <= most && (!reader_ || number <= reader_->num_left() / least_bytes));
    count = ok_ ? number : 0;
  }
  template <class T, class Visit>
  void Each(std::vector<T>& all, size_t most, size_t least_bytes, Visit visit) {
    size_t count = all.size();
    Count(count, most, least_bytes);
    if (reader_) all.resize(count);
    for (size_t i = 0; i < count && ok_; ++i) visit(all[i]);
  }
  void Flags(std::vector<bool>& flags) {
    for (size_t i = 0; i < flags.size(); ++i) {
      bool flag = flags[i];
      Flag(flag);
      flags[i] = flag;
    }
  }

  void One(Trail& trail) {
    Numbers(trail.step_s_, trail.next_s_);
    Each(trail.points_, Trail::kMaxPoints, sizeof(double) + 2 * sizeof(float),
         [&](TrailPoint& point) { Numbers(point.t_s, point.x_m, point.y_m); });
  }

  void One(RecordedChart& chart) {
    Number(chart.step_s_);
    Each(chart.points_, RecordedChart::kMaxPoints, sizeof(double) + 7 * sizeof(float),
         [&](ChartPoint& point) {
           Numbers(point.t_s, point.heading_deg, point.desired_heading_deg, point.speed_mps,
                   point.desired_speed_mps, point.depth_m, point.desired_depth_m, point.altitude_m);
           Require(std::isfinite(point.t_s));
         });
  }

  void One(ViewEvent& event) {
    Within(event.utime, -kLongestLine_us, kLongestLine_us);
    Choice(event.kind, static_cast<int>(EventKind::kMissed) + 1);
    Each(event.vehicles, 10, 4, [&](std::string& name) { Text(name); });
    Text(event.text);
    Text(event.plan);
    // It goes into an answer as it is.
    if (reader_) Require(event.plan.empty() || nlohmann::json::accept(event.plan));
  }

  void One(Keyframe& keyframe) {
    Within(keyframe.offset, 0, log_size_);
    if (!reader_) {
      keyframe.timeline.AppendTo(&bytes_);
    } else {
      Require(ok_ && keyframe.timeline.TakeFrom(&*reader_));
    }
    Within(keyframe.scene_utime, -kLongestLine_us, kLongestLine_us);
    Counts(keyframe.num_fates);
    Flags(keyframe.kinds_seen);
    Flags(keyframe.causes_seen);
    Each(keyframe.standing, kMaxStanding, 16, [&](StandingMessage& message) {
      Within(message.offset, 0, log_size_);
      Within(message.scene_utime, -kLongestLine_us, kLongestLine_us);
    });
    One(keyframe.links);
    One(keyframe.media_links);
  }

  void One(MediaLinks& media) {
    if (reader_) media.vehicles_ = blank_->media_links().vehicles_;
    Each(media.books_, MediaLinks::kMaxMedia, 20, [&](std::pair<std::string, LinkBook>& each) {
      Text(each.first);
      One(each.second);
    });
  }

  void One(LinkBook& book) {
    std::vector<std::string> names = book.names_->all();
    const size_t num_first = reader_ ? blank_->links().num_first_ : book.num_first_;
    Each(names, num_first + LinkBook::kMaxUnregistered, 4, [&](std::string& name) { Text(name); });
    if (reader_) SetNames(names, num_first, &book);
    Counts(book.num_fates_, book.num_elsewhere_, book.num_strange_);
    const auto num_names = static_cast<int32_t>(names.size());
    Each(book.links_, LinkBook::kMaxLinks, 200, [&](LinkCounts& link) {
      Within(link.from, 0, num_names - 1);
      Within(link.to, 0, num_names - 1);
      for (uint32_t& count : link.offered) Number(count);
      for (uint32_t& count : link.received) Number(count);
      for (uint32_t& count : link.by_cause) Number(count);
      Within(link.last_received_utime, LinkCounts::kNeverReceived, kFarthest_us);
      One(link.last);
    });
    if (reader_ && ok_) book.GrowTable();
  }

  /// Those of a mission come first, as its scene has them.
  void SetNames(const std::vector<std::string>& names, size_t num_first, LinkBook* book) {
    const std::vector<std::string>& first = blank_->links().names().all();
    Require(names.size() >= num_first && first.size() >= num_first &&
            std::equal(first.begin(), first.begin() + static_cast<ptrdiff_t>(num_first),
                       names.begin()));
    if (!ok_) return;
    if (names_ == nullptr || names_->all() != names) {
      names_ = std::make_shared<const NameTable>(names);
    }
    Require(names_->size() == names.size());
    book->names_ = names_;
    book->num_first_ = num_first;
    book->table_width_ = 0;
  }

  void One(FateFacts& facts) {
    Within(facts.utime, -kFarthest_us, kFarthest_us);
    Number(facts.number);
    Within(facts.count, 0, std::numeric_limits<int32_t>::max());
    Choice(facts.kind, kNumKinds);
    Choice(facts.cause, kNumCauses);
    Choice(facts.override_rule, static_cast<int>(OverrideRule::kFullReport) + 1);
    Flag(facts.has_path);
    Numbers(facts.range_m, facts.limit_m, facts.age_s, facts.age_limit_s, facts.wait_s,
            facts.loss_pct, facts.length_bytes, facts.length_limit_bytes);
    Within(facts.sent_utime, -kFarthest_us, kFarthest_us);
    Numbers(facts.own_packet, facts.bits_flipped, facts.air_s, facts.travel_s, facts.jitter_s,
            facts.snr_db, facts.loss_probability, facts.bit_error_probability, facts.channel,
            facts.num_colliders, facts.depth_m, facts.depth_limit_m, facts.horizon_m,
            facts.path_loss_db, facts.path_loss_limit_db, facts.radio_delay_s, facts.hop);
  }

  std::optional<LittleEndianReader> reader_;  ///< Absent: it is written.
  std::vector<uint8_t> bytes_;
  const Scene* blank_ = nullptr;
  uint64_t log_size_ = std::numeric_limits<uint64_t>::max();
  bool ok_ = true;
  std::shared_ptr<const NameTable> names_;  ///< Of the book before: most share theirs.
};

std::string IndexKey(const Scene& blank, const Mission& mission, LogStamps stamps) {
  std::string text =
      fmt::format("{}|{}|{}|{}", static_cast<int>(stamps), blank.start_utime(),
                  blank.rules() ? blank.rules()->stale_time_s : -1, mission.comms.pulse_duration_s);
  for (const WatchedVehicle& vehicle : WatchedVehiclesOf(mission)) {
    text +=
        fmt::format("|{}|{}|{}", vehicle.name, vehicle.length_m, vehicle.draught_m.value_or(-1));
  }
  for (const std::string_view medium : blank.media_links().Names())
    text += fmt::format("|{}", medium);
  text += Explain(mission);  // What PlanWatch knows of it.
  return fmt::format("{} {:016x}", kViewIndexFormat,
                     DigestOf({reinterpret_cast<const uint8_t*>(text.data()), text.size()}));
}

std::vector<uint8_t> IndexBytes(KeptIndex* kept) {
  IndexArchive archive;
  archive.All(*kept);
  return archive.ok() ? archive.Take() : std::vector<uint8_t>();
}

std::optional<KeptIndex> IndexFrom(std::span<const uint8_t> bytes, const Scene& blank,
                                   uint64_t log_size) {
  IndexArchive archive(bytes, blank, log_size);
  KeptIndex kept;
  archive.All(kept);
  if (!archive.ok() || !archive.is_at_end()) return std::nullopt;
  return kept;
}

}  // namespace shoal
