#include "lib/sea/modem/micromodem_host.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "lib/base/time/utc_time.h"
#include "lib/sea/modem/sentence_reader.h"
#include "lib/sea/modem/sentence_text.h"

namespace shoal {
namespace {

constexpr int64_t kBootTime_us = 200'000;

/// Returns "CACFG,SRC,1" of CCCFG, SRC, 1: the first `count` fields, or all.
std::string Echo(std::string_view address, const NmeaFields& sentence, size_t count = 99) {
  std::vector<std::string> fields = {std::string(address)};
  const size_t num_fields = std::min(count, sentence.fields.size());
  fields.insert(fields.end(), sentence.fields.begin(),
                sentence.fields.begin() + static_cast<std::ptrdiff_t>(num_fields));
  return JoinFields(fields);
}

}  // namespace

const std::array<MicroModemHost::SentenceRow, 13> MicroModemHost::kSentences = {{
    {"CCCFG", &MicroModemHost::SetConfiguration},
    {"CCCFQ", &MicroModemHost::ShowConfiguration},
    {"CCMSC", &MicroModemHost::Reboot},
    {"CCCLK", &MicroModemHost::SetCalendarClock},
    {"CCTMS", &MicroModemHost::SetIsoClock},
    {"CCTMQ", &MicroModemHost::ShowClock},
    {"CCCYC", &MicroModemHost::BeginCycle},
    {"CCTXD", &MicroModemHost::TakeData},
    {"CCMPC", &MicroModemHost::Ping},
    {"CCMUC", &MicroModemHost::SendMini},
    {"CCTDP", &MicroModemHost::SendFlexible, 2},
    {"CCPDT", &MicroModemHost::RangeRemus},
    {"CCPNT", &MicroModemHost::RangeNarrowband},
}};

void MicroModemHost::ForgetLine() {
  line_.clear();
  is_skipping_line_ = false;
}

void MicroModemHost::TakeBytes(std::string_view bytes) {
  for (const char letter : bytes) {
    if (letter == '\r' || letter == '\n') {
      if (!line_.empty() && !is_skipping_line_) TakeLine(line_);
      line_.clear();
      is_skipping_line_ = false;
    } else if (line_.size() < kMaxLineBytes) {
      line_ += letter;
    } else if (!is_skipping_line_) {
      is_skipping_line_ = true;
      ++unit_.counts.lines_dropped;
    }
  }
}

void MicroModemHost::TakeLine(std::string_view line) {
  const auto sentence = line.size() <= kMaxLineBytes ? ParseNmea(line) : std::nullopt;
  if (!sentence) {
    ++unit_.counts.lines_dropped;
    return;
  }
  is_refused_ = false;
  Answer(*sentence);
  ++(is_refused_ ? unit_.counts.sentences_refused : unit_.counts.sentences_answered);
}

void MicroModemHost::Answer(const NmeaFields& sentence) {
  for (const SentenceRow& row : kSentences) {
    if (row.address == sentence.address && row.since_version <= unit_.options.version) {
      (this->*row.answer)(sentence);
      return;
    }
  }
  is_refused_ = true;
  unit_.WriteError("NMEA", MicroModemError::kUnknown, "unknown sentence");
}

void MicroModemHost::Refuse(std::string_view reason) {
  is_refused_ = true;
  unit_.WriteError("NMEA", MicroModemError::kBadField, reason);
}

void MicroModemHost::RefuseBusy(std::string_view reason) {
  is_refused_ = true;
  unit_.WriteError("BUSY", MicroModemError::kBusy, reason);
}

bool MicroModemHost::RefusesWhatIsWrong(const SentenceReader& reader) {
  if (!reader.problem().empty()) Refuse(reader.problem());
  return is_refused_;
}

void MicroModemHost::SetConfiguration(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const std::string_view key = reader.Text(1);
  const std::string_view value = reader.Text(2);
  if (RefusesWhatIsWrong(reader)) return;
  const std::string problem = SetMicroModemKey(key, value, unit_.options.address, &unit_.settings);
  if (!problem.empty()) return Refuse(problem);
  unit_.Write(Echo("CACFG", sentence, 2));
}

void MicroModemHost::ShowConfiguration(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const auto found = FindMicroModemKeys(reader.Text(1), unit_.settings);
  if (found.empty()) reader.Reject(1, "ALL or TOP or a key that is set");
  if (RefusesWhatIsWrong(reader)) return;
  for (const auto& [key, value] : found) {
    std::string answer = "CACFG,";
    answer.append(key).append(",").append(value);
    unit_.Write(answer);
  }
}

void MicroModemHost::Reboot(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  reader.Number(1, 0, kMaxMicroModemAddress);
  reader.Number(2, unit_.address(), unit_.address());
  reader.Number(3, 0, 999'999'999);
  if (RefusesWhatIsWrong(reader)) return;
  unit_.Write(Echo("CAMSC", sentence, 3));
  cycle_.Reboot();
  air_.DropWaiting();
  receiver_.Reboot();
  transponders_us_.reset();
  boot_us_ = unit_.now_us + kBootTime_us;
}

void MicroModemHost::SetCalendarClock(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const CalendarTime asked = {.year = reader.Number(1, 1970, kLastClockYear),
                              .month = reader.Number(2, 1, 12),
                              .day = reader.Number(3, 1, 31),
                              .hour = reader.Number(4, 0, 23),
                              .minute = reader.Number(5, 0, 59),
                              .second = reader.Number(6, 0, 60)};
  const auto utc_us = ToUtc(asked);
  if (!utc_us) reader.Reject(3, "a day of that month");
  if (RefusesWhatIsWrong(reader)) return;
  unit_.SetClock(*utc_us, unit_.now_us);
  const CalendarTime time = ToCalendar(unit_.Utc_us());
  unit_.Write("CACLK," + std::to_string(time.year) + "," + std::to_string(time.month) + "," +
              std::to_string(time.day) + "," + std::to_string(time.hour) + "," +
              std::to_string(time.minute) + "," + std::to_string(time.second));
}

void MicroModemHost::SetIsoClock(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const auto utc_us = ParseIsoTime(reader.Text(1));
  if (!utc_us) {
    reader.Reject(1, "a time as 2026-11-21T02:25:24Z, 1970 to " + std::to_string(kLastClockYear));
  }
  reader.Number(2, 0, 1);
  if (RefusesWhatIsWrong(reader)) return;
  unit_.SetClock(*utc_us, unit_.now_us);
  unit_.Write("CATMS,0," + IsoTimeText(unit_.Utc_us()));
}

void MicroModemHost::ShowClock(const NmeaFields&) {
  unit_.Write("CATMQ," + IsoTimeText(unit_.Utc_us()) + ",RTC,RTC");
}

void MicroModemHost::BeginCycle(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  reader.Number(1, 0, 999);
  const int source = reader.Number(2, unit_.address(), unit_.address());
  const int destination = reader.Number(3, 0, kMaxMicroModemAddress);
  const int rate = reader.Number(4, 0, static_cast<int>(kMicroModemRates.size()) - 1);
  const bool wants_ack = reader.Number(5, 0, 1) == 1;
  const int num_wanted =
      reader.Number(6, 1, kMicroModemRates[static_cast<size_t>(rate)].max_frames);
  if (RefusesWhatIsWrong(reader)) return;
  if (cycle_.is_under_way() && !cycle_.is_asking()) {
    return RefuseBusy("a cycle is under way: wait for CATXF");
  }
  if (cycle_.is_under_way()) cycle_.Abandon("given up for another CCCYC");
  cycle_.DropOldFrames();
  unit_.Write(Echo("CACYC", sentence, 6));
  cycle_.Start({.kind = MicroModemKind::kData,
                .source = source,
                .destination = destination,
                .rate = rate,
                .wants_ack = wants_ack},
               num_wanted);
}

void MicroModemHost::TakeData(const NmeaFields& sentence) {
  const bool is_asked = cycle_.is_asking();
  SentenceReader reader(sentence);
  reader.Number(1, unit_.address(), unit_.address());
  const int only = is_asked ? cycle_.packet().destination : -1;
  const int destination =
      reader.Number(2, std::max(only, 0), is_asked ? only : kMaxMicroModemAddress);
  const bool wants_ack = reader.Number(3, 0, 1) == 1;
  auto bytes = ParseHex(reader.Text(4));
  const int max_bytes =
      is_asked ? kMicroModemRates[static_cast<size_t>(cycle_.packet().rate)].max_frame_bytes
               : kMaxMicroModemFrameBytes;
  if (!bytes || std::ssize(*bytes) > max_bytes) {
    reader.Reject(4, "hex digits of at most " + std::to_string(max_bytes) + " bytes");
  }
  if (RefusesWhatIsWrong(reader)) return;

  cycle_.DropOldFrames();
  if (!is_asked && !cycle_.HasRoomForEarlyFrame()) {
    return RefuseBusy("frames without a cycle: send CCCYC");
  }
  unit_.Write(Echo("CATXD", sentence, 3) + "," + std::to_string(bytes->size()));
  cycle_.Give(destination, {.wants_ack = wants_ack, .bytes = std::move(*bytes)});
}

void MicroModemHost::Ping(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const int source = reader.Number(1, unit_.address(), unit_.address());
  const int destination = reader.Number(2, 1, kMaxMicroModemAddress);
  if (RefusesWhatIsWrong(reader)) return;
  if (!air_.HasRoom()) return RefuseBusy("too much is waiting for the air");
  unit_.Write(Echo("CAMPC", sentence, 2));
  air_.Send({.kind = MicroModemKind::kPing, .source = source, .destination = destination}, {},
            false);
}

void MicroModemHost::SendMini(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const int source = reader.Number(1, unit_.address(), unit_.address());
  const int destination = reader.Number(2, 0, kMaxMicroModemAddress);
  const auto bytes = ParseHex(reader.Text(3));
  const int value = bytes && bytes->size() == 2 ? (*bytes)[0] << 8 | (*bytes)[1] : -1;
  if (value < 0 || value > kMaxMiniPacket) reader.Reject(3, "0000 to 1fff");
  if (RefusesWhatIsWrong(reader)) return;
  if (!air_.HasRoom()) return RefuseBusy("too much is waiting for the air");
  unit_.Write(Echo("CAMUC", sentence, 3));
  air_.Send(
      {.kind = MicroModemKind::kMini, .source = source, .destination = destination, .value = value},
      {}, false);
}

void MicroModemHost::SendFlexible(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const int destination = reader.Number(1, 0, kMaxMicroModemAddress);
  const int rate = reader.Number(2, 0, static_cast<int>(kMicroModemRates.size()) - 1);
  const bool wants_ack = reader.Number(3, 0, 1) == 1;
  reader.Number(4, 0, 0);
  auto bytes = ParseHex(reader.Text(5));
  if (!bytes || bytes->empty() || std::ssize(*bytes) > kMaxFlexibleBytes) {
    reader.Reject(5, "hex digits of 1 to " + std::to_string(kMaxFlexibleBytes) + " bytes");
  }
  if (RefusesWhatIsWrong(reader)) return;
  if (!air_.HasRoom()) return RefuseBusy("too much is waiting for the air");
  const auto num_bytes = static_cast<int>(bytes->size());
  unit_.Write("CATDP,0,1," + Echo("", sentence, 4).substr(1) + "," + std::to_string(num_bytes));
  air_.Send({.kind = MicroModemKind::kFlexible,
             .source = unit_.address(),
             .destination = destination,
             .rate = rate,
             .wants_ack = wants_ack,
             .num_frames = 1,
             .frames = {{.wants_ack = wants_ack, .bytes = std::move(*bytes)}}},
            num_bytes, false);
}

void MicroModemHost::RangeRemus(const NmeaFields& sentence) {
  RangeTransponders(sentence, 5);
  if (!is_refused_) unit_.Write(Echo("SNPDT", sentence));
}

void MicroModemHost::RangeNarrowband(const NmeaFields& sentence) {
  RangeTransponders(sentence, 4);
  if (!is_refused_) unit_.Write(Echo("SNPNT", sentence));
}

void MicroModemHost::RangeTransponders(const NmeaFields& sentence, size_t timeout_field) {
  SentenceReader reader(sentence);
  const int timeout_ms = reader.Number(timeout_field, 1, 60'000);
  if (RefusesWhatIsWrong(reader)) return;
  transponder_timeout_s_ = timeout_ms / 1e3;
  transponders_us_ = unit_.now_us + timeout_ms * int64_t{1000};
}

void MicroModemHost::WriteTransponderTimes() {
  std::string body = "SNTTA,";
  for (const std::optional<double>& travel_s : unit_.options.transponder_travel_s) {
    const bool is_in_time = travel_s && *travel_s > 0 && 2 * *travel_s <= transponder_timeout_s_;
    body += (is_in_time ? FixedText(*travel_s, 4) : "0.0") + ",";
  }
  unit_.Write(body + ClockText(unit_.Utc_us(), 2));
}

void MicroModemHost::OnTime() {
  if (boot_us_ && *boot_us_ <= unit_.now_us) {
    boot_us_.reset();
    unit_.WriteRevision();
  }
  if (transponders_us_ && *transponders_us_ <= unit_.now_us) {
    transponders_us_.reset();
    WriteTransponderTimes();
  }
}

std::optional<int64_t> MicroModemHost::NextEvent_us() const {
  if (!boot_us_) return transponders_us_;
  return std::min(*boot_us_, transponders_us_.value_or(*boot_us_));
}

}  // namespace shoal
