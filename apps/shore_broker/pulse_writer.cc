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

/// Easy to distinguish, and none that messages have by default.
constexpr std::array<std::string_view, 12> kReportColors = {
    "orange", "dodger_blue", "red",    "green",  "yellow", "magenta",
    "cyan",   "brown",       "purple", "salmon", "khaki",  "turquoise"};

}  // namespace

PulseWriter::PulseWriter(Bus& bus) : bus_(bus) {
  message_.num_pulses = 0;
  message_.pulses.resize(kMaxPulsesPerMessage);
}

void PulseWriter::Add(int64_t utime, const Pulse& pulse, double duration_s) {
  if (duration_s <= 0 || pulse.color == "off" || pulse.color == "invisible") return;
  if (message_.num_pulses == kMaxPulsesPerMessage) Flush(utime);
  comms_pulse_t& out = message_.pulses[static_cast<size_t>(message_.num_pulses++)];
  out.sx_m = pulse.from_m.x();
  out.sy_m = pulse.from_m.y();
  out.tx_m = pulse.to_m.x();
  out.ty_m = pulse.to_m.y();
  out.beam_width_m = std::max(kLeastWidth_m, kWidthPerRange * pulse.range_m);
  out.duration_s = duration_s;
  out.fill = pulse.of_message ? kMessageFill : kReportFill;
  out.label = UpperCase(pulse.source);
  out.label += '2';
  out.label += UpperCase(pulse.destination);
  if (pulse.of_message) out.label += "_MSG";
  out.ptype = pulse.of_message ? "msg" : "nrep";
  out.fill_color = pulse.color;
  out.edge_color = pulse.color;
  out.edge_size = 1;
}

void PulseWriter::Flush(int64_t utime) {
  if (message_.num_pulses == 0) return;
  message_.utime = utime;
  Publish(bus_, channel_, message_);
  message_.num_pulses = 0;
}

std::string_view ReportColor(int32_t index) {
  return kReportColors.at(static_cast<size_t>(index) % kReportColors.size());
}

}  // namespace shoal
