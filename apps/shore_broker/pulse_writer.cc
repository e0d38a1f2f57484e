#include "apps/shore_broker/pulse_writer.h"

#include <algorithm>
#include <array>

#include "lib/base/text/letters.h"

namespace shoal {

namespace {

/// The manual's figures; a viewer shows messages less transparent than reports.
constexpr double kLeastWidth_m = 5;
constexpr double kWidthPerRange = 0.1;
constexpr double kReportFill = 0.35;
constexpr double kMessageFill = 0.6;

/// Colors that are easy to distinguish. Messages have none of them by default.
constexpr std::array<std::string_view, 12> kReportColors = {
    "orange", "dodger_blue", "red",    "green",  "yellow", "magenta",
    "cyan",   "brown",       "purple", "salmon", "khaki",  "turquoise"};

}  // namespace

PulseWriter::PulseWriter(Bus& bus) : bus_(bus), message_{} {}

bool PulseWriter::IsEnd(size_t index, std::string_view vehicle,
                        const Eigen::Vector3d& place_m) const {
  if (index >= names_.size() || names_[index] != vehicle) return false;
  const pulse_end_t& end = message_.ends[index];
  return end.x_m == place_m.x() && end.y_m == place_m.y();
}

size_t PulseWriter::EndOf(std::string_view vehicle, const Eigen::Vector3d& place_m) {
  auto known = ends_of_name_.find(vehicle);
  if (known == ends_of_name_.end()) known = ends_of_name_.try_emplace(std::string(vehicle)).first;
  for (const size_t index : known->second) {
    if (IsEnd(index, vehicle, place_m)) return index;
  }
  const size_t index = names_.size();
  known->second.push_back(index);
  names_.emplace_back(vehicle);
  pulse_end_t& end = message_.ends.emplace_back();
  end.vehicle = UpperCase(vehicle);
  end.x_m = place_m.x();
  end.y_m = place_m.y();
  return index;
}

size_t PulseWriter::DestinationOf(const Pulse& pulse) {
  if (pulse.contact < 0) return EndOf(pulse.destination, pulse.to_m);
  const auto contact = static_cast<size_t>(pulse.contact);
  if (contact >= end_of_contact_.size()) end_of_contact_.resize(contact + 1);
  size_t& end = end_of_contact_[contact];
  if (!IsEnd(end, pulse.destination, pulse.to_m)) end = EndOf(pulse.destination, pulse.to_m);
  return end;
}

int16_t PulseWriter::StyleOf(const Pulse& pulse, double duration_s) {
  const std::string_view ptype = pulse.of_message ? "msg" : "nrep";
  const auto is_it = [&](const pulse_style_t& style) {
    return style.fill_color == pulse.color && style.ptype == ptype &&
           style.duration_s == duration_s;
  };
  auto& styles = message_.styles;
  // The pulses of one transmission, which come together, have one style.
  if (styles.empty() || !is_it(styles[style_])) {
    style_ = static_cast<size_t>(std::ranges::find_if(styles, is_it) - styles.begin());
  }
  if (style_ == styles.size()) {
    pulse_style_t& style = styles.emplace_back();
    style.duration_s = duration_s;
    style.fill = pulse.of_message ? kMessageFill : kReportFill;
    if (pulse.of_message) style.label_end = "_MSG";
    style.ptype = ptype;
    style.fill_color = pulse.color;
    style.edge_color = pulse.color;
    style.edge_size = 1;
  }
  return static_cast<int16_t>(style_);
}

void PulseWriter::Add(int64_t utime, const Pulse& pulse, double duration_s) {
  if (duration_s <= 0 || pulse.color == "off" || pulse.color == "invisible") return;
  if (message_.source.size() == kMaxPulsesPerMessage) Flush(utime);
  // A transmission has the same source for all receivers.
  if (!IsEnd(source_, pulse.source, pulse.from_m)) source_ = EndOf(pulse.source, pulse.from_m);
  message_.source.push_back(static_cast<int16_t>(source_));
  message_.destination.push_back(static_cast<int16_t>(DestinationOf(pulse)));
  message_.style.push_back(StyleOf(pulse, duration_s));
  message_.beam_width_m.push_back(std::max(kLeastWidth_m, kWidthPerRange * pulse.range_m));
}

void PulseWriter::Flush(int64_t utime) {
  if (message_.source.empty()) return;
  message_.utime = utime;
  message_.num_ends = static_cast<int32_t>(message_.ends.size());
  message_.num_styles = static_cast<int32_t>(message_.styles.size());
  message_.num_pulses = static_cast<int32_t>(message_.source.size());
  Publish(bus_, channel_, message_);
  message_.ends.clear();
  message_.styles.clear();
  message_.source.clear();
  message_.destination.clear();
  message_.style.clear();
  message_.beam_width_m.clear();
  names_.clear();
  ends_of_name_.clear();
  source_ = style_ = 0;
}

std::string_view ReportColor(int32_t index) {
  return kReportColors.at(static_cast<size_t>(index) % kReportColors.size());
}

}  // namespace shoal
