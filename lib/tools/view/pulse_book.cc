#include "lib/tools/view/pulse_book.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/tools/view/fate_facts.h"
#include "lib/tools/view/stable_id.h"
#include "lib/tools/view/view_limits.h"
#include "lib/tools/view/wire_reader.h"
#include "shoal/comms_pulse_columns_t.hpp"
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

/// Reads the pulses of a list one after the other.
class ListedPulses {
 public:
  /// Reads all of them in `wire`, which then shows whether they are whole.
  explicit ListedPulses(WireReader* wire) : count_(wire->Count(kLeastPulseBytes)), wire_(*wire) {
    for (size_t i = 0; i < count_ && wire->ok(); ++i) ReadPulse(wire);
  }

  size_t count() const { return count_; }
  WirePulse Next() { return ReadPulse(&wire_); }

 private:
  size_t count_;
  WireReader wire_;  ///< Of the next one.
};

/// The same of columns: as ListOf (lib/bus/bus/pulse_columns.h), without copies of all texts.
class ColumnsOfPulses {
 public:
  explicit ColumnsOfPulses(WireReader* wire) {
    ends_.resize(wire->Count(kLeastEndBytes));
    for (End& end : ends_) {
      end.vehicle = wire->Text().substr(0, kMaxLabel);
      end.x_m = wire->Double();
      end.y_m = wire->Double();
    }
    styles_.resize(wire->Count(kLeastStyleBytes));
    for (Style& style : styles_) {
      style.duration_s = wire->Double();
      style.fill = wire->Double();
      style.label_end = wire->Text().substr(0, kMaxLabel);
      style.ptype = wire->Text();
      style.color = wire->Text().substr(0, kMaxColor);
      wire->Text();    // The edge's colour,
      wire->Double();  // and its width.
    }
    pulses_.resize(wire->Count(kPulseBytes));
    for (Row& row : pulses_) row.source = wire->Int16();
    for (Row& row : pulses_) row.destination = wire->Int16();
    for (Row& row : pulses_) row.style = wire->Int16();
    for (Row& row : pulses_) row.width_m = wire->Double();
  }

  size_t count() const { return pulses_.size(); }
  /// Returns true where each index is one.
  bool AreSound() const {
    const auto is_in = [](int16_t index, const auto& rows) {
      return index >= 0 && static_cast<size_t>(index) < rows.size();
    };
    return std::ranges::all_of(pulses_, [&](const Row& row) {
      return is_in(row.source, ends_) && is_in(row.destination, ends_) && is_in(row.style, styles_);
    });
  }
  /// The pulse's label lives until the next call. @pre AreSound()
  WirePulse Next() {
    const Row& row = pulses_[next_++];
    const End& source = ends_[static_cast<size_t>(row.source)];
    const End& destination = ends_[static_cast<size_t>(row.destination)];
    const Style& style = styles_[static_cast<size_t>(row.style)];
    label_ = source.vehicle;
    label_ += '2';
    label_ += destination.vehicle;
    label_ += style.label_end;
    return {.sx_m = source.x_m,
            .sy_m = source.y_m,
            .tx_m = destination.x_m,
            .ty_m = destination.y_m,
            .width_m = row.width_m,
            .duration_s = style.duration_s,
            .fill = style.fill,
            .label = std::string_view(label_).substr(0, kMaxLabel),
            .ptype = style.ptype,
            .color = style.color};
  }

 private:
  struct End {
    std::string_view vehicle;
    double x_m = 0;
    double y_m = 0;
  };
  struct Style {
    double duration_s = 0;
    double fill = 0;
    std::string_view label_end;
    std::string_view ptype;
    std::string_view color;
  };
  struct Row {
    int16_t source = 0;
    int16_t destination = 0;
    int16_t style = 0;
    double width_m = 0;
  };
  static constexpr size_t kLeastEndBytes = 5 + 2 * 8;
  static constexpr size_t kLeastStyleBytes = 3 * 8 + 4 * 5;
  static constexpr size_t kPulseBytes = 3 * 2 + 8;

  std::vector<End> ends_;
  std::vector<Style> styles_;
  std::vector<Row> pulses_;
  size_t next_ = 0;
  std::string label_;
};

}  // namespace

bool PulseBook::Add(std::span<const uint8_t> data) {
  WireReader wire(data);
  const int64_t fingerprint = wire.Int64();
  const int64_t utime = PlausibleUtime(wire.Int64());
  const auto take = [&](auto* pulses) {
    last_utime_ = utime;
    for (size_t i = 0; i < pulses->count(); ++i) {
      const WirePulse read = pulses->Next();
      ViewPulse* place =
          CanBeDrawn(read) ? PlaceFor(read.label, read.ptype == "msg", utime) : nullptr;
      if (place == nullptr) {
        ++num_left_out_;
      } else {
        Fill(read, utime, ++last_order_, place);
      }
    }
  };
  if (fingerprint == comms_pulse_columns_t::getHash()) {
    ColumnsOfPulses columns(&wire);
    if (!wire.ok() || !wire.at_end() || !columns.AreSound()) return false;
    take(&columns);
    return true;
  }
  if (fingerprint != comms_pulses_t::getHash()) return false;
  ListedPulses listed(&wire);
  if (!wire.ok() || !wire.at_end()) return false;
  take(&listed);
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
