#include "lib/tools/view/pulse_book.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/tools/view/fate_facts.h"
#include "lib/tools/view/stable_id.h"
#include "lib/tools/view/view_limits.h"
#include "lib/tools/view/wire_reader.h"
#include "shoal/comms_pulses_t.hpp"

namespace shoal {

namespace {

/// Of a pulse on the wire, its texts empty.
constexpr size_t kLeastPulseBytes = 8 * 8 + 4 * 5;
constexpr size_t kMaxLabel = 100;
constexpr size_t kMaxColor = 40;
constexpr double kLongest_s = 3600;

/// A pulse as it is on the wire.
struct WirePulse {
  double sx_m, sy_m, tx_m, ty_m, width_m, duration_s, fill;
  std::string_view label, ptype, color;
};

WirePulse ReadPulse(WireReader* wire) {
  WirePulse pulse{};
  pulse.sx_m = wire->Double();
  pulse.sy_m = wire->Double();
  pulse.tx_m = wire->Double();
  pulse.ty_m = wire->Double();
  pulse.width_m = wire->Double();
  pulse.duration_s = wire->Double();
  pulse.fill = wire->Double();
  pulse.label = wire->Text().substr(0, kMaxLabel);
  pulse.ptype = wire->Text();
  pulse.color = wire->Text().substr(0, kMaxColor);
  wire->Text();    // The edge's colour,
  wire->Double();  // and its width.
  return pulse;
}

bool CanBeDrawn(const WirePulse& pulse) {
  return std::isfinite(pulse.sx_m) && std::isfinite(pulse.sy_m) && std::isfinite(pulse.tx_m) &&
         std::isfinite(pulse.ty_m) && std::isfinite(pulse.width_m) && std::isfinite(pulse.fill) &&
         pulse.duration_s > 0;
}

int64_t EndOf(const ViewPulse& pulse) {
  return pulse.utime + static_cast<int64_t>(static_cast<double>(pulse.duration_s) * 1e6);
}

bool IsDrawnAt(const ViewPulse& pulse, int64_t utime) {
  return pulse.utime - kOvertaking_us <= utime && utime < EndOf(pulse);
}

void Fill(const WirePulse& wire, int64_t utime, int64_t order, ViewPulse* pulse) {
  pulse->id = StableId(wire.label, utime);
  pulse->order = order;
  pulse->utime = utime;
  pulse->sx_m = static_cast<float>(wire.sx_m);
  pulse->sy_m = static_cast<float>(wire.sy_m);
  pulse->tx_m = static_cast<float>(wire.tx_m);
  pulse->ty_m = static_cast<float>(wire.ty_m);
  pulse->width_m = static_cast<float>(wire.width_m);
  pulse->duration_s = static_cast<float>(std::min(wire.duration_s, kLongest_s));
  pulse->fill = static_cast<float>(std::clamp(wire.fill, 0.0, 1.0));
  pulse->of_message = wire.ptype == "msg";
  pulse->label = wire.label;
  pulse->color = wire.color;
}

/// Returns the number of pulses of a whole message, or -1.
int64_t CountPulses(WireReader wire) {
  const size_t count = wire.Count(kLeastPulseBytes);
  for (size_t i = 0; i < count && wire.ok(); ++i) ReadPulse(&wire);
  return wire.ok() && wire.at_end() ? static_cast<int64_t>(count) : -1;
}

}  // namespace

bool PulseBook::Add(std::span<const uint8_t> data) {
  WireReader wire(data);
  if (wire.Int64() != comms_pulses_t::getHash()) return false;
  const int64_t utime = PlausibleUtime(wire.Int64());
  const int64_t count = CountPulses(wire);
  if (count < 0) return false;
  last_utime_ = utime;
  wire.Int32();
  for (int64_t i = 0; i < count; ++i) {
    const WirePulse read = ReadPulse(&wire);
    ViewPulse* place =
        CanBeDrawn(read) ? PlaceFor(read.label, read.ptype == "msg", utime) : nullptr;
    if (place == nullptr) {
      ++num_left_out_;
    } else {
      Fill(read, utime, ++last_order_, place);
    }
  }
  return true;
}

std::vector<const ViewPulse*> PulseBook::NotOver(int64_t utime) const {
  std::vector<const ViewPulse*> found;
  for (const ViewPulse& pulse : pulses_) {
    if (IsDrawnAt(pulse, utime)) found.push_back(&pulse);
  }
  std::sort(found.begin(), found.end(),
            [](const ViewPulse* a, const ViewPulse* b) { return a->order < b->order; });
  return found;
}

std::vector<const ViewPulse*> PulseBook::TakeForStream(int64_t order, int64_t utime, size_t most,
                                                       int64_t* num_left_out) {
  std::vector<ViewPulse*> found;
  for (ViewPulse& pulse : pulses_) {
    if (pulse.order > order && IsDrawnAt(pulse, utime)) found.push_back(&pulse);
  }
  std::sort(found.begin(), found.end(), [](const ViewPulse* a, const ViewPulse* b) {
    if (a->of_message != b->of_message) return a->of_message;
    return a->streamed != b->streamed ? a->streamed < b->streamed : a->order > b->order;
  });
  *num_left_out = static_cast<int64_t>(found.size() - std::min(found.size(), most));
  found.resize(std::min(found.size(), most));
  ++num_streamed_;
  for (ViewPulse* pulse : found) pulse->streamed = num_streamed_;
  return {found.begin(), found.end()};
}

ViewPulse* PulseBook::PlaceFor(std::string_view label, bool of_message, int64_t utime) {
  const auto known = places_.find(label);
  if (known != places_.end()) return &pulses_[known->second];
  // A much earlier time means that the pulses started again, or that an earlier message was from
  // far in the future.
  const bool may_be_over = utime >= full_until_utime_ || dropped_utime_ - utime > kOvertaking_us;
  if (pulses_.size() == kMaxPulses && may_be_over) DropOver(utime);
  if (pulses_.size() < kMaxPulses) {
    places_.emplace(label, pulses_.size());
    return &pulses_.emplace_back();
  }
  if (!of_message) return nullptr;
  for (size_t tried = 0; tried < pulses_.size(); ++tried) {
    const size_t place = next_to_replace_;
    next_to_replace_ = (next_to_replace_ + 1) % pulses_.size();
    if (pulses_[place].of_message) continue;
    ++num_left_out_;
    places_.erase(pulses_[place].label);
    places_.emplace(label, place);
    pulses_[place].streamed = 0;
    return &pulses_[place];
  }
  return nullptr;
}

void PulseBook::DropOver(int64_t utime) {
  std::erase_if(pulses_, [&](const ViewPulse& pulse) { return !IsDrawnAt(pulse, utime); });
  places_.clear();
  dropped_utime_ = utime;
  full_until_utime_ = pulses_.empty() ? utime : std::numeric_limits<int64_t>::max();
  for (size_t i = 0; i < pulses_.size(); ++i) {
    places_.emplace(pulses_[i].label, i);
    full_until_utime_ = std::min(full_until_utime_, EndOf(pulses_[i]));
  }
}

}  // namespace shoal
