#include "lib/tools/view/fate_facts.h"

#include <algorithm>
#include <cstddef>

#include "lib/tools/view/wire_reader.h"
#include "shoal/comms_fate_columns_t.hpp"
#include "shoal/comms_fates_t.hpp"

namespace shoal {

namespace {

/// Size of an empty text on the wire: its length and a zero.
constexpr size_t kLeastTextBytes = 5;
/// Of a fate without path, its texts empty.
constexpr size_t kLeastFateBytes = 5 * kLeastTextBytes + 4 + 8 + size_t{6} * 8 + size_t{3} * 4;

template <class T>
std::vector<std::string_view> TextsOf(std::string_view (*text_of)(T), int count) {
  std::vector<std::string_view> texts;
  texts.reserve(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) texts.push_back(text_of(static_cast<T>(i)));
  return texts;
}

/// Sets `value` to what a text stands for, or returns false. The previous value is tried first,
/// since neighbours are alike.
template <class T>
bool FindText(const std::vector<std::string_view>& texts, std::string_view text, T* value) {
  if (texts[static_cast<size_t>(*value)] == text) return true;
  const auto found = std::find(texts.begin(), texts.end(), text);
  if (found == texts.end()) return false;
  *value = static_cast<T>(found - texts.begin());
  return true;
}

bool FindKind(std::string_view text, Kind* kind) {
  static const auto texts = TextsOf<Kind>(KindText, kNumKinds);
  return FindText(texts, text, kind);
}

bool FindCause(std::string_view text, Cause* cause) {
  static const auto texts = TextsOf<Cause>(CauseText, kNumCauses);
  return FindText(texts, text, cause);
}

OverrideRule FindOverride(std::string_view text) {
  static const auto texts = TextsOf<OverrideRule>(OverrideText, 3);
  OverrideRule rule = OverrideRule::kNone;
  FindText(texts, text, &rule);
  return rule;
}

void ReadPath(WireReader* wire, FateView* fate) {
  FateFacts& facts = fate->facts;
  wire->Int64();  // The packet's own count.
  facts.channel = wire->Int32();
  facts.sent_utime = PlausibleUtime(wire->Int64());
  wire->Int32();  // Bytes on the air.
  facts.air_s = static_cast<float>(wire->Double());
  facts.travel_s = static_cast<float>(wire->Double());
  facts.jitter_s = static_cast<float>(wire->Double());
  facts.snr_db = static_cast<float>(wire->Double());
  facts.loss_probability = static_cast<float>(wire->Double());
  facts.bit_error_probability = static_cast<float>(wire->Double());
  facts.bits_flipped = wire->Int64();
  facts.num_colliders = wire->Int32();
  facts.own_packet = wire->Int64();
  fate->colliders.clear();
  const size_t num_named = wire->Count(kLeastTextBytes);
  for (size_t k = 0; k < num_named && wire->ok(); ++k) fate->colliders.push_back(wire->Text());
}

/// Reads one fate. Returns false where its kind or cause is unknown, after reading to its end.
bool ReadFate(WireReader* wire, FateView* fate) {
  FateFacts& facts = fate->facts;
  facts = {.utime = facts.utime, .kind = facts.kind, .cause = facts.cause};
  bool is_known = FindKind(wire->Text(), &facts.kind);
  fate->source = wire->Text();
  fate->destination = wire->Text();
  facts.count = std::max(wire->Int32(), 0);
  facts.number = wire->Int64();
  is_known = FindCause(wire->Text(), &facts.cause) && is_known;
  facts.override_rule = FindOverride(wire->Text());
  facts.range_m = static_cast<float>(wire->Double());
  facts.limit_m = static_cast<float>(wire->Double());
  facts.age_s = static_cast<float>(wire->Double());
  facts.age_limit_s = static_cast<float>(wire->Double());
  facts.wait_s = static_cast<float>(wire->Double());
  facts.loss_pct = static_cast<float>(wire->Double());
  facts.length_bytes = wire->Int32();
  facts.length_limit_bytes = wire->Int32();
  const size_t num_paths = wire->Count(1);
  facts.has_path = num_paths > 0;
  fate->colliders.clear();
  for (size_t i = 0; i < num_paths && wire->ok(); ++i) ReadPath(wire, fate);
  return is_known;
}

/// A column of numbers on the wire, read one by one.
template <class T>
std::vector<T> ColumnOf(WireReader* wire, T (WireReader::*next)()) {
  std::vector<T> column(wire->Count(sizeof(T)));
  for (T& each : column) each = (wire->*next)();
  return column;
}

/// Reads columns in place: what ListOf (lib/bus/bus/fate_columns.h) does, without copies of texts.
class ColumnsReader {
 public:
  explicit ColumnsReader(WireReader* wire) : wire_(*wire) {}

  /// Returns false where the columns do not fit one another, or the bytes end too early.
  bool Read(FatesView* message) {
    ReadSenders();
    ReadCases();
    names_.resize(wire_.Count(kLeastTextBytes));
    for (std::string_view& name : names_) name = wire_.Text();
    const size_t num_fates = wire_.Count(2 * sizeof(int16_t));
    destinations_.resize(num_fates);
    which_.resize(num_fates);
    for (int16_t& each : destinations_) each = wire_.Int16();
    for (int16_t& each : which_) each = wire_.Int16();
    ranges_ = ColumnOf(&wire_, &WireReader::Double);
    waits_ = ColumnOf(&wire_, &WireReader::Double);
    counts_ = ColumnOf(&wire_, &WireReader::Int32);
    paths_left_ = wire_.Count(kLeastPathBytes);
    if (message->fates.size() < num_fates) message->fates.resize(num_fates);
    for (size_t i = 0; i < num_fates && wire_.ok(); ++i) {
      FateView& fate = message->fates[message->num_fates];
      bool is_known = false;
      if (!ReadFate(i, message->utime, &fate, &is_known)) return false;
      if (is_known) {
        ++message->num_fates;
      } else {
        ++message->num_strange;
      }
    }
    return num_left_ == 0 && sender_ == senders_.size() && range_ == ranges_.size() &&
           wait_ == waits_.size() && count_ == counts_.size() && paths_left_ == 0;
  }

 private:
  struct Sender {
    FateFacts facts;
    std::string_view source;
    int32_t num_fates;
    bool is_known;
  };
  struct Case {
    FateFacts facts;
    bool has_range;
    bool has_wait;
    bool has_count;
    bool is_known;
  };
  static constexpr size_t kLeastSenderBytes = 2 * kLeastTextBytes + 8 + 4;
  static constexpr size_t kLeastCaseBytes = 2 * kLeastTextBytes + size_t{4} * 8 + size_t{2} * 4 + 4;
  static constexpr size_t kLeastPathBytes = size_t{10} * 8 + size_t{4} * 4;

  void ReadSenders() {
    senders_.resize(wire_.Count(kLeastSenderBytes));
    Kind kind = Kind::kReport;
    for (Sender& sender : senders_) {
      sender.facts = {};
      sender.is_known = FindKind(wire_.Text(), &kind);
      sender.facts.kind = kind;
      sender.source = wire_.Text();
      sender.facts.number = wire_.Int64();
      sender.num_fates = wire_.Int32();
    }
  }

  void ReadCases() {
    cases_.resize(wire_.Count(kLeastCaseBytes));
    Cause cause = Cause::kDelivered;
    for (Case& each : cases_) {
      FateFacts& facts = each.facts = {};
      each.is_known = FindCause(wire_.Text(), &cause);
      facts.cause = cause;
      facts.override_rule = FindOverride(wire_.Text());
      facts.limit_m = static_cast<float>(wire_.Double());
      facts.age_s = static_cast<float>(wire_.Double());
      facts.age_limit_s = static_cast<float>(wire_.Double());
      facts.loss_pct = static_cast<float>(wire_.Double());
      facts.length_bytes = wire_.Int32();
      facts.length_limit_bytes = wire_.Int32();
      each.has_range = wire_.Boolean();
      each.has_wait = wire_.Boolean();
      each.has_count = wire_.Boolean();
      facts.has_path = wire_.Boolean();
    }
  }

  template <class T>
  static bool Take(bool is_there, const std::vector<T>& column, size_t* next, T* value) {
    if (!is_there) return true;
    if (*next == column.size()) return false;
    *value = column[(*next)++];
    return true;
  }

  bool ReadFate(size_t i, int64_t utime, FateView* fate, bool* is_known) {
    for (; num_left_ <= 0; num_left_ = senders_[sender_++].num_fates) {
      if (sender_ == senders_.size()) return false;
    }
    --num_left_;
    const Sender& sender = senders_[sender_ - 1];
    const auto which = static_cast<size_t>(which_[i]);
    const auto destination = static_cast<size_t>(destinations_[i]);
    if (which >= cases_.size() || destination >= names_.size()) return false;
    const Case& of = cases_[which];
    double range_m = -1;
    double wait_s = -1;
    int32_t count = 1;
    if (!Take(of.has_range, ranges_, &range_, &range_m) ||
        !Take(of.has_wait, waits_, &wait_, &wait_s) ||
        !Take(of.has_count, counts_, &count_, &count)) {
      return false;
    }
    FateFacts& facts = fate->facts = of.facts;
    facts.utime = utime;
    facts.kind = sender.facts.kind;
    facts.number = sender.facts.number;
    facts.count = std::max(count, 0);
    facts.range_m = static_cast<float>(range_m);
    facts.wait_s = static_cast<float>(wait_s);
    fate->source = sender.source;
    fate->destination = names_[destination];
    fate->colliders.clear();
    if (facts.has_path) {
      if (paths_left_-- == 0) return false;
      ReadPath(&wire_, fate);
    }
    *is_known = sender.is_known && of.is_known;
    return true;
  }

  WireReader& wire_;
  std::vector<Sender> senders_;
  std::vector<Case> cases_;
  std::vector<std::string_view> names_;
  std::vector<int16_t> destinations_;
  std::vector<int16_t> which_;
  std::vector<double> ranges_;
  std::vector<double> waits_;
  std::vector<int32_t> counts_;
  size_t paths_left_ = 0;
  size_t sender_ = 0;  ///< The next one.
  int32_t num_left_ = 0;
  size_t range_ = 0;
  size_t wait_ = 0;
  size_t count_ = 0;
};

}  // namespace

bool ReadFates(std::span<const uint8_t> data, FatesView* message) {
  message->num_fates = 0;
  message->num_strange = 0;
  WireReader wire(data);
  const int64_t fingerprint = wire.Int64();
  const bool is_columns = fingerprint == comms_fate_columns_t::getHash();
  if (!is_columns && fingerprint != comms_fates_t::getHash()) return false;
  message->utime = PlausibleUtime(wire.Int64());
  if (is_columns) {
    if (ColumnsReader(&wire).Read(message) && wire.ok() && wire.at_end()) return true;
    message->num_fates = 0;
    message->num_strange = 0;
    return false;
  }
  const size_t count = wire.Count(kLeastFateBytes);
  if (message->fates.size() < count) message->fates.resize(count);
  for (size_t i = 0; i < count && wire.ok(); ++i) {
    FateView& fate = message->fates[message->num_fates];
    fate.facts.utime = message->utime;
    if (ReadFate(&wire, &fate)) {
      ++message->num_fates;
    } else {
      ++message->num_strange;
    }
  }
  if (wire.ok() && wire.at_end()) return true;
  message->num_fates = 0;
  message->num_strange = 0;
  return false;
}

bool ViewOf(const fate_t& fate, int64_t utime, FateView* view) {
  FateFacts& facts = view->facts;
  facts = {};
  facts.utime = PlausibleUtime(utime);
  view->source = fate.source;
  view->destination = fate.destination;
  view->colliders.clear();
  facts.count = std::max(fate.count, 0);
  facts.number = fate.number;
  facts.override_rule = FindOverride(fate.override_rule);
  facts.range_m = static_cast<float>(fate.range_m);
  facts.limit_m = static_cast<float>(fate.limit_m);
  facts.age_s = static_cast<float>(fate.age_s);
  facts.age_limit_s = static_cast<float>(fate.age_limit_s);
  facts.wait_s = static_cast<float>(fate.wait_s);
  facts.loss_pct = static_cast<float>(fate.loss_pct);
  facts.length_bytes = fate.length_bytes;
  facts.length_limit_bytes = fate.length_limit_bytes;
  facts.has_path = !fate.path.empty();
  for (const acoustic_path_t& path : fate.path) {
    facts.channel = path.channel;
    facts.sent_utime = PlausibleUtime(path.sent_utime);
    facts.air_s = static_cast<float>(path.air_s);
    facts.travel_s = static_cast<float>(path.travel_s);
    facts.jitter_s = static_cast<float>(path.jitter_s);
    facts.snr_db = static_cast<float>(path.snr_db);
    facts.loss_probability = static_cast<float>(path.loss_probability);
    facts.bit_error_probability = static_cast<float>(path.bit_error_probability);
    facts.bits_flipped = path.bits_flipped;
    facts.num_colliders = path.num_colliders;
    facts.own_packet = path.own_packet;
    view->colliders.assign(path.colliders.begin(), path.colliders.end());
  }
  const bool has_kind = FindKind(fate.kind, &facts.kind);
  return FindCause(fate.cause, &facts.cause) && has_kind;
}

bool ViewOf(const fate_medium_t& fate, int64_t utime, FateView* view) {
  FateFacts& facts = view->facts;
  facts = {};
  facts.utime = PlausibleUtime(utime);
  view->source = fate.source;
  view->destination = fate.destination;
  view->medium = fate.medium;
  view->colliders.clear();
  facts.number = fate.number;
  facts.hop = fate.hop;
  facts.range_m = static_cast<float>(fate.range_m);
  facts.limit_m = static_cast<float>(fate.limit_m);
  facts.depth_m = static_cast<float>(fate.depth_m);
  facts.depth_limit_m = static_cast<float>(fate.depth_limit_m);
  facts.horizon_m = static_cast<float>(fate.horizon_m);
  facts.path_loss_db = static_cast<float>(fate.path_loss_db);
  facts.path_loss_limit_db = static_cast<float>(fate.path_loss_limit_db);
  // Of what goes by radio; an acoustic network has its own numbers in the fate's path.
  if (fate.depth_limit_m >= 0) {
    facts.loss_probability = static_cast<float>(fate.loss_probability);
    facts.radio_delay_s = static_cast<float>(fate.delay_s);
  }
  const bool has_kind = FindKind(fate.kind, &facts.kind);
  return FindCause(fate.cause, &facts.cause) && has_kind;
}

void AddMediumNumbers(const FateFacts& medium, FateFacts* facts) {
  if (medium.range_m >= 0) facts->range_m = medium.range_m;
  if (medium.limit_m >= 0) facts->limit_m = medium.limit_m;
  facts->depth_m = medium.depth_m;
  facts->depth_limit_m = medium.depth_limit_m;
  facts->horizon_m = medium.horizon_m;
  facts->path_loss_db = medium.path_loss_db;
  facts->path_loss_limit_db = medium.path_loss_limit_db;
  facts->radio_delay_s = medium.radio_delay_s;
  facts->hop = medium.hop;
  if (!facts->has_path) facts->loss_probability = medium.loss_probability;
}

}  // namespace shoal
