#include "lib/tools/view/fate_facts.h"

#include <algorithm>
#include <cstddef>

#include "lib/tools/view/wire_reader.h"
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
  for (size_t i = 0; i < num_paths && wire->ok(); ++i) {
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
  return is_known;
}

}  // namespace

bool ReadFates(std::span<const uint8_t> data, FatesView* message) {
  message->num_fates = 0;
  message->num_strange = 0;
  WireReader wire(data);
  if (wire.Int64() != comms_fates_t::getHash()) return false;
  message->utime = PlausibleUtime(wire.Int64());
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
