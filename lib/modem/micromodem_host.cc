// What a Micro-Modem answers its host.
#include <algorithm>
#include <utility>

#include "lib/check/time_units.h"
#include "lib/modem/micromodem.h"
#include "lib/modem/sentence_reader.h"
#include "lib/modem/sentence_text.h"
#include "lib/modem/utc_time.h"

namespace shoal {
namespace {

constexpr int64_t kBootTime_us = 200'000;
constexpr size_t kMaxEarlyFrames = 8;

/// Returns "CACFG,SRC,1" of CCCFG, SRC, 1: the first `count` fields, or all.
std::string Echo(std::string_view address, const NmeaFields& sentence, size_t count = 99) {
  std::vector<std::string> fields = {std::string(address)};
  const size_t num_fields = std::min(count, sentence.fields.size());
  fields.insert(fields.end(), sentence.fields.begin(),
                sentence.fields.begin() + static_cast<std::ptrdiff_t>(num_fields));
  return JoinFields(fields);
}

}  // namespace

const std::array<MicroModem::SentenceRow, 12> MicroModem::kSentences = {{
    {"CCCFG", &MicroModem::SetConfiguration},
    {"CCCFQ", &MicroModem::TellConfiguration},
    {"CCMSC", &MicroModem::Reboot},
    {"CCCLK", &MicroModem::SetCalendarClock},
    {"CCTMS", &MicroModem::SetIsoClock},
    {"CCTMQ", &MicroModem::TellClock},
    {"CCCYC", &MicroModem::BeginCycle},
    {"CCTXD", &MicroModem::TakeData},
    {"CCMPC", &MicroModem::Ping},
    {"CCMUC", &MicroModem::SendMini},
    {"CCPDT", &MicroModem::RangeRemus},
    {"CCPNT", &MicroModem::RangeNarrowband},
}};

MicroModemOutput MicroModem::Take(std::string_view line, int64_t now_us) {
  CatchUp(now_us);
  TakeLine(line);
  return Finish();
}

void MicroModem::ForgetLine() {
  line_.clear();
  is_skipping_line_ = false;
}

MicroModemOutput MicroModem::TakeBytes(std::string_view bytes, int64_t now_us) {
  CatchUp(now_us);
  for (const char letter : bytes) {
    if (letter == '\r' || letter == '\n') {
      if (!line_.empty() && !is_skipping_line_) TakeLine(line_);
      line_.clear();
      is_skipping_line_ = false;
    } else if (line_.size() < kMaxLineBytes) {
      line_ += letter;
    } else if (!is_skipping_line_) {
      is_skipping_line_ = true;
      ++counts_.lines_dropped;
    }
  }
  return Finish();
}

void MicroModem::TakeLine(std::string_view line) {
  const auto sentence = line.size() <= kMaxLineBytes ? ParseNmea(line) : std::nullopt;
  if (!sentence) {
    ++counts_.lines_dropped;
    return;
  }
  is_refused_ = false;
  Answer(*sentence);
  ++(is_refused_ ? counts_.sentences_refused : counts_.sentences_answered);
}

void MicroModem::Answer(const NmeaFields& sentence) {
  for (const SentenceRow& row : kSentences) {
    if (row.address == sentence.address) {
      (this->*row.answer)(sentence);
      return;
    }
  }
  is_refused_ = true;
  SayError("NMEA", ErrorCode::kUnknown, "unknown sentence");
}

void MicroModem::Refuse(std::string_view reason) {
  is_refused_ = true;
  SayError("NMEA", ErrorCode::kBadField, reason);
}

void MicroModem::RefuseBusy(std::string_view reason) {
  is_refused_ = true;
  SayError("BUSY", ErrorCode::kBusy, reason);
}

bool MicroModem::RefusesWhatIsWrong(const SentenceReader& reader) {
  if (!reader.problem().empty()) Refuse(reader.problem());
  return is_refused_;
}

void MicroModem::SetConfiguration(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const std::string_view key = reader.Text(1);
  const std::string_view value = reader.Text(2);
  if (RefusesWhatIsWrong(reader)) return;
  const std::string problem = SetMicroModemKey(key, value, options_.address, &settings_);
  if (!problem.empty()) return Refuse(problem);
  Say(Echo("CACFG", sentence, 2));
}

void MicroModem::TellConfiguration(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const auto found = FindMicroModemKeys(reader.Text(1), settings_);
  if (found.empty()) reader.Reject(1, "ALL or TOP or a key that is set");
  if (RefusesWhatIsWrong(reader)) return;
  for (const auto& [key, value] : found) Say("CACFG," + key + "," + value);
}

void MicroModem::Reboot(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  reader.Number(1, 0, kMaxMicroModemAddress);
  reader.Number(2, address(), address());
  reader.Number(3, 0, 999'999'999);
  if (RefusesWhatIsWrong(reader)) return;
  Say(Echo("CAMSC", sentence, 3));
  const bool is_leaving =
      cycle_ && on_air_ && on_air_->is_of_cycle && cycle_->state == CycleState::kSending;
  if (cycle_ && !is_leaving) EndCycle(ErrorCode::kAbandoned, "CYCLE", "given up for CCMSC");
  cycle_.reset();  // CATXF will tell of what is leaving.
  waiting_.clear();
  early_.clear();
  awaited_.reset();
  transponders_us_.reset();
  if (on_air_) on_air_->is_of_cycle = false;
  boot_us_ = now_us_ + kBootTime_us;
}

void MicroModem::SetCalendarClock(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const CalendarTime asked = {.year = reader.Number(1, 1970, 2200),
                              .month = reader.Number(2, 1, 12),
                              .day = reader.Number(3, 1, 31),
                              .hour = reader.Number(4, 0, 23),
                              .minute = reader.Number(5, 0, 59),
                              .second = reader.Number(6, 0, 60)};
  const auto utc_us = ToUtc(asked);
  if (!utc_us) reader.Reject(3, "a day of that month");
  if (RefusesWhatIsWrong(reader)) return;
  SetClock(*utc_us, now_us_);
  const CalendarTime time = ToCalendar(Utc_us());
  Say("CACLK," + std::to_string(time.year) + "," + std::to_string(time.month) + "," +
      std::to_string(time.day) + "," + std::to_string(time.hour) + "," +
      std::to_string(time.minute) + "," + std::to_string(time.second));
}

void MicroModem::SetIsoClock(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const auto utc_us = ParseIsoTime(reader.Text(1));
  if (!utc_us) reader.Reject(1, "a time as 2026-11-21T02:25:24Z");
  reader.Number(2, 0, 1);
  if (RefusesWhatIsWrong(reader)) return;
  SetClock(*utc_us, now_us_);
  Say("CATMS,0," + IsoTimeText(Utc_us()));
}

void MicroModem::TellClock(const NmeaFields&) {
  Say("CATMQ," + IsoTimeText(Utc_us()) + ",RTC,RTC");
}

void MicroModem::BeginCycle(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  reader.Number(1, 0, 999);
  const int source = reader.Number(2, address(), address());
  const int destination = reader.Number(3, 0, kMaxMicroModemAddress);
  const int rate = reader.Number(4, 0, static_cast<int>(kMicroModemRates.size()) - 1);
  const bool wants_ack = reader.Number(5, 0, 1) == 1;
  const int num_wanted =
      reader.Number(6, 1, kMicroModemRates[static_cast<size_t>(rate)].max_frames);
  if (RefusesWhatIsWrong(reader)) return;
  if (cycle_ && cycle_->state != CycleState::kAsking) {
    return RefuseBusy("a cycle is under way: wait for CATXF");
  }
  if (cycle_) EndCycle(ErrorCode::kAbandoned, "CYCLE", "given up for another CCCYC");
  std::erase_if(early_, [this](const EarlyFrame& early) {
    return now_us_ - early.given_us > settings_.dto * kSecond_us;
  });
  Say(Echo("CACYC", sentence, 6));
  StartCycle({.kind = MicroModemKind::kData,
              .source = source,
              .destination = destination,
              .rate = rate,
              .wants_ack = wants_ack},
             num_wanted);
}

void MicroModem::TakeData(const NmeaFields& sentence) {
  const bool is_asked = cycle_ && cycle_->state == CycleState::kAsking;
  SentenceReader reader(sentence);
  reader.Number(1, address(), address());
  const int only = is_asked ? cycle_->packet.destination : -1;
  const int destination =
      reader.Number(2, std::max(only, 0), is_asked ? only : kMaxMicroModemAddress);
  const bool wants_ack = reader.Number(3, 0, 1) == 1;
  auto bytes = ParseHex(reader.Text(4));
  const int max_bytes =
      is_asked ? kMicroModemRates[static_cast<size_t>(cycle_->packet.rate)].max_frame_bytes
               : kMaxMicroModemFrameBytes;
  if (!bytes || std::ssize(*bytes) > max_bytes) {
    reader.Reject(4, "hex digits of at most " + std::to_string(max_bytes) + " bytes");
  }
  if (RefusesWhatIsWrong(reader)) return;

  std::erase_if(early_, [this](const EarlyFrame& early) {
    return now_us_ - early.given_us > settings_.dto * kSecond_us;
  });
  if (!is_asked && early_.size() >= kMaxEarlyFrames) {
    return RefuseBusy("frames without a cycle: send CCCYC");
  }
  Say(Echo("CATXD", sentence, 3) + "," + std::to_string(bytes->size()));
  const bool is_empty = bytes->empty();
  MicroModemFrame frame = {.wants_ack = wants_ack, .bytes = std::move(*bytes)};
  if (is_asked && is_empty) {
    SendData();
  } else if (is_asked) {
    cycle_->packet.frames.push_back(std::move(frame));
    AskForFrame();
  } else if (!is_empty) {
    early_.push_back({.destination = destination, .frame = std::move(frame), .given_us = now_us_});
  }
}

void MicroModem::Ping(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const int source = reader.Number(1, address(), address());
  const int destination = reader.Number(2, 1, kMaxMicroModemAddress);
  if (RefusesWhatIsWrong(reader)) return;
  if (!HasRoom()) return RefuseBusy("too much is waiting for the air");
  Say(Echo("CAMPC", sentence, 2));
  Send({.kind = MicroModemKind::kPing, .source = source, .destination = destination}, {}, false);
}

void MicroModem::SendMini(const NmeaFields& sentence) {
  SentenceReader reader(sentence);
  const int source = reader.Number(1, address(), address());
  const int destination = reader.Number(2, 0, kMaxMicroModemAddress);
  const auto bytes = ParseHex(reader.Text(3));
  const int value = bytes && bytes->size() == 2 ? (*bytes)[0] << 8 | (*bytes)[1] : -1;
  if (value < 0 || value > kMaxMiniPacket) reader.Reject(3, "0000 to 1fff");
  if (RefusesWhatIsWrong(reader)) return;
  if (!HasRoom()) return RefuseBusy("too much is waiting for the air");
  Say(Echo("CAMUC", sentence, 3));
  Send(
      {.kind = MicroModemKind::kMini, .source = source, .destination = destination, .value = value},
      {}, false);
}

void MicroModem::RangeRemus(const NmeaFields& sentence) {
  RangeTransponders(sentence, 5);
  if (!is_refused_) Say(Echo("SNPDT", sentence));
}

void MicroModem::RangeNarrowband(const NmeaFields& sentence) {
  RangeTransponders(sentence, 4);
  if (!is_refused_) Say(Echo("SNPNT", sentence));
}

void MicroModem::RangeTransponders(const NmeaFields& sentence, size_t timeout_field) {
  SentenceReader reader(sentence);
  const int timeout_ms = reader.Number(timeout_field, 1, 60'000);
  if (RefusesWhatIsWrong(reader)) return;
  transponder_timeout_s_ = timeout_ms / 1e3;
  transponders_us_ = now_us_ + timeout_ms * int64_t{1000};
}

void MicroModem::SayTransponderTimes() {
  std::string body = "SNTTA,";
  for (const std::optional<double>& travel_s : options_.transponder_travel_s) {
    const bool is_heard = travel_s && *travel_s > 0 && 2 * *travel_s <= transponder_timeout_s_;
    body += (is_heard ? FixedText(*travel_s, 4) : "0.0") + ",";
  }
  Say(body + ClockText(Utc_us(), 2));
}

}  // namespace shoal
