#include "lib/bus/record/log_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/codec/little_endian.h"
#include "lib/base/time/seconds.h"
#include "lib/base/time/time_units.h"

namespace shoal {

namespace {

/// Names the format of the part: it must change when the format does.
constexpr std::string_view kTimesKey = "1";
constexpr int64_t kEventsBetweenProgress = 4096;
/// If the clock jumps within as many events, it was wrong before and is right from then on.
constexpr int64_t kFirstEvents = 64;
constexpr size_t kLeastPlace_bytes = 80;

class TimesReader {
 public:
  explicit TimesReader(uint64_t log_size)
      : gap_bytes_(std::max(LogTimes::kLeastGap_bytes, log_size / LogTimes::kMaxPlaces)) {}

  void Take(const LogEvent& event) {
    if (times_.num_events == 0) {
      times_.zero_utime = PlausibleUtime(event.utime);
      next_.line = RecordedTimeline(event.utime);
      next_.offset = event.offset;
      times_.places.push_back(next_);
    } else if (event.offset - times_.places.back().offset >= gap_bytes_ &&
               times_.places.size() < LogTimes::kMaxPlaces) {
      next_.offset = event.offset;
      times_.places.push_back(next_);
    }
    ++times_.num_events;
    if (times_.channels.size() < LogTimes::kMaxChannels &&
        !times_.channels.contains(event.channel)) {
      times_.channels.emplace(event.channel);
    }
    for (size_t i = 0; i < kHoldingChannels.size(); ++i) {
      if (event.channel == kHoldingChannels[i]) next_.holding[i] = event.offset;
    }
    TakeTime(event);
  }

  LogTimes Finish() {
    times_.end_us = next_.line.now_us();
    NoteStrays();
    return std::move(times_);
  }

 private:
  void TakeTime(const LogEvent& event) {
    const RecordedTimeline before = next_.line;
    next_.line.Advance(event.utime);
    const RecordedTimeline& line = next_.line;
    if (line.num_odd() == before.num_odd()) {
      NoteStrays();
      last_utime_ = event.utime;
      return;
    }
    if (doubted_.empty() || !Agree(doubted_.back().utime, event.utime)) NoteStrays();
    doubted_.push_back({.number = event.number,
                        .offset = event.offset,
                        .utime = event.utime,
                        .before_utime = last_utime_.value_or(event.utime)});
    const bool is_jump = line.num_shifts() > before.num_shifts();
    if (!is_jump && line.now_us() == before.now_us()) return;
    // Enough events agree: the times that were doubted were right.
    const TimeTrouble first = doubted_.front();
    if (is_jump) {
      if (times_.num_jumps++ == 0) times_.first_jump = first;
      if (times_.num_events <= kFirstEvents) times_.zero_utime = line.UtimeOf(0);
    } else if (!times_.longest_gap || Gap_us(first) > Gap_us(*times_.longest_gap)) {
      times_.longest_gap = first;
    }
    last_utime_ = event.utime;
    doubted_.clear();
  }

  static int64_t Gap_us(const TimeTrouble& trouble) {
    return PlausibleUtime(trouble.utime) - PlausibleUtime(trouble.before_utime);
  }

  static bool Agree(int64_t before_utime, int64_t utime) {
    const int64_t step_us = PlausibleUtime(utime) - PlausibleUtime(before_utime);
    return step_us >= -RecordedTimeline::kBack_us && step_us <= RecordedTimeline::kAhead_us;
  }

  void NoteStrays() {
    if (doubted_.empty()) return;
    if (times_.num_strays == 0) times_.first_stray = doubted_.front();
    times_.num_strays += static_cast<int64_t>(doubted_.size());
    doubted_.clear();
  }

  uint64_t gap_bytes_;
  LogPlace next_{.line = RecordedTimeline(0)};
  std::optional<int64_t> last_utime_;  ///< Of the last event whose time fits.
  std::vector<TimeTrouble> doubted_;   ///< The last events, fewer than kWitnesses of the line.
  LogTimes times_;
};

void AppendTrouble(const std::optional<TimeTrouble>& trouble, std::vector<uint8_t>* bytes) {
  AppendLittleEndian(static_cast<uint8_t>(trouble.has_value()), bytes);
  if (!trouble) return;
  AppendLittleEndian(trouble->number, bytes);
  AppendLittleEndian(trouble->offset, bytes);
  AppendLittleEndian(trouble->utime, bytes);
  AppendLittleEndian(trouble->before_utime, bytes);
}

bool TakeTrouble(LittleEndianReader* reader, std::optional<TimeTrouble>* trouble) {
  uint8_t is_there = 0;
  if (!reader->Take(&is_there) || is_there > 1) return false;
  if (is_there == 0) return true;
  TimeTrouble& taken = trouble->emplace();
  return reader->Take(&taken.number) && reader->Take(&taken.offset) && reader->Take(&taken.utime) &&
         reader->Take(&taken.before_utime);
}

std::vector<uint8_t> BytesOf(const LogTimes& times) {
  std::vector<uint8_t> bytes;
  AppendLittleEndian(times.num_events, &bytes);
  AppendLittleEndian(times.zero_utime, &bytes);
  AppendLittleEndian(times.end_us, &bytes);
  AppendLittleEndian(times.num_strays, &bytes);
  AppendLittleEndian(times.num_jumps, &bytes);
  AppendTrouble(times.first_stray, &bytes);
  AppendTrouble(times.first_jump, &bytes);
  AppendTrouble(times.longest_gap, &bytes);
  AppendLittleEndian(static_cast<uint32_t>(times.places.size()), &bytes);
  for (const LogPlace& place : times.places) {
    AppendLittleEndian(place.offset, &bytes);
    place.line.AppendTo(&bytes);
    for (const uint64_t offset : place.holding) AppendLittleEndian(offset, &bytes);
  }
  AppendLittleEndian(static_cast<uint32_t>(times.channels.size()), &bytes);
  for (const std::string& channel : times.channels) AppendSizedText(channel, &bytes);
  return bytes;
}

/// Returns true for a time on a line with which arithmetic here cannot overflow.
bool IsOnLine(int64_t time_us) { return std::abs(time_us / 4) <= kFarthest_us; }

std::optional<LogTimes> TimesFrom(std::span<const uint8_t> bytes, uint64_t log_size) {
  LittleEndianReader reader(bytes);
  LogTimes times;
  uint32_t count = 0;
  if (!reader.Take(&times.num_events) || !reader.Take(&times.zero_utime) ||
      !reader.Take(&times.end_us) || !reader.Take(&times.num_strays) ||
      !reader.Take(&times.num_jumps) || !TakeTrouble(&reader, &times.first_stray) ||
      !TakeTrouble(&reader, &times.first_jump) || !TakeTrouble(&reader, &times.longest_gap) ||
      !reader.Take(&count) || count == 0 || count > LogTimes::kMaxPlaces ||
      reader.num_left() / kLeastPlace_bytes < count || !IsOnLine(times.end_us) ||
      !IsOnLine(times.zero_utime) || times.num_events < 1 || times.num_strays < 0 ||
      times.num_jumps < 0 || (times.num_strays > 0) != times.first_stray.has_value() ||
      (times.num_jumps > 0) != times.first_jump.has_value()) {
    return std::nullopt;
  }
  for (uint32_t i = 0; i < count; ++i) {
    LogPlace& place = times.places.emplace_back(LogPlace{.line = RecordedTimeline(0)});
    bool is_sound = reader.Take(&place.offset) && place.line.TakeFrom(&reader) &&
                    place.offset <= log_size &&
                    (i == 0 || place.offset > times.places[i - 1].offset);
    for (uint64_t& offset : place.holding) {
      is_sound =
          is_sound && reader.Take(&offset) && (offset == LogPlace::kNone || offset < place.offset);
    }
    if (!is_sound) return std::nullopt;
  }
  if (!reader.Take(&count) || count > LogTimes::kMaxChannels) return std::nullopt;
  for (uint32_t i = 0; i < count; ++i) {
    std::string channel;
    if (!reader.TakeSizedText(&channel) || channel.size() > kMaxLogChannelLength) {
      return std::nullopt;
    }
    times.channels.insert(std::move(channel));
  }
  return reader.num_left() == 0 ? std::optional(std::move(times)) : std::nullopt;
}

}  // namespace

const LogPlace& LogTimes::PlaceBefore(int64_t line_us) const {
  const auto later =
      std::partition_point(places.begin() + 1, places.end(),
                           [&](const LogPlace& place) { return place.line.now_us() <= line_us; });
  return *(later - 1);
}

LogTimes TimesOf(const LogReader& log, const ReadingProgress& progress, uint64_t least_bytes) {
  if (const auto kept = ReadIndexPart(log, IndexPart::kTimes, kTimesKey, least_bytes)) {
    if (std::optional<LogTimes> times = TimesFrom(*kept, log.size())) return *std::move(times);
  }
  LogReader reader = log.Another();
  TimesReader times(reader.size());
  int64_t num_events = 0;
  while (const auto event = reader.Next()) {
    times.Take(*event);
    if (progress && ++num_events % kEventsBetweenProgress == 0) {
      progress(static_cast<double>(event->offset) / static_cast<double>(reader.size()));
    }
  }
  if (progress) progress(1);
  LogTimes read = times.Finish();
  if (read.num_events > 0) {
    KeepIndexPart(log, IndexPart::kTimes, kTimesKey, BytesOf(read), least_bytes);
  }
  return read;
}

std::vector<std::string> TimeWarnings(const LogTimes& times, const std::string& path) {
  std::vector<std::string> lines;
  const auto more = [](int64_t num, const char* what) {
    return num > 1 ? fmt::format(" ({} more {})", num - 1, what) : std::string();
  };
  if (const auto& stray = times.first_stray) {
    // If the clock jumps, no one span has all of the rest.
    const std::string remedy =
        times.num_jumps > 0
            ? ""
            : fmt::format(
                  "; `shoal log copy {} part.lcm --from {:.0f} --to {:.0f}` leaves out "
                  "what lies outside",
                  path, std::floor(Seconds(times.zero_utime)),
                  std::ceil(Seconds(times.zero_utime + times.end_us)));
    lines.push_back(fmt::format(
        "{}: event {} (byte {}) has the time {:.6f} s, which does not fit the one before it, "
        "{:.6f} s{}: it counts as of the time of its neighbours{}",
        path, stray->number, stray->offset, Seconds(stray->utime), Seconds(stray->before_utime),
        more(times.num_strays, "events do not fit"), remedy));
  }
  if (const auto& jump = times.first_jump) {
    lines.push_back(fmt::format(
        "{}: the clock jumps from {:.6f} s to {:.6f} s at event {} (byte {}){}: what follows comes "
        "right behind what came before; `shoal log copy --from --to` takes one part alone",
        path, Seconds(jump->before_utime), Seconds(jump->utime), jump->number, jump->offset,
        more(times.num_jumps, "jumps")));
  }
  if (const auto& gap = times.longest_gap) {
    lines.push_back(
        fmt::format("{}: nothing was recorded for {:.0f} s before event {} (byte {})", path,
                    Seconds(PlausibleUtime(gap->utime) - PlausibleUtime(gap->before_utime)),
                    gap->number, gap->offset));
  }
  return lines;
}

}  // namespace shoal
