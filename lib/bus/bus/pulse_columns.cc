#include "lib/bus/bus/pulse_columns.h"

#include <vector>

#include "lib/bus/bus/big_endian.h"

namespace shoal {

namespace {

template <class T>
const T* ElementAt(const std::vector<T>& values, int16_t index) {
  return index >= 0 && static_cast<size_t>(index) < values.size()
             ? &values[static_cast<size_t>(index)]
             : nullptr;
}

bool ArePulseColumns(std::span<const uint8_t> data) {
  constexpr size_t kFingerprint_bytes = 8;
  if (data.size() < kFingerprint_bytes) return false;
  return static_cast<int64_t>(ReadBigEndian(data.first(kFingerprint_bytes))) ==
         comms_pulse_columns_t::getHash();
}

}  // namespace

bool ListOf(const comms_pulse_columns_t& columns, comms_pulses_t* list) {
  const size_t num_pulses = columns.source.size();
  if (columns.destination.size() != num_pulses || columns.style.size() != num_pulses ||
      columns.beam_width_m.size() != num_pulses) {
    return false;
  }
  list->utime = columns.utime;
  list->pulses.resize(num_pulses);
  list->num_pulses = static_cast<int32_t>(num_pulses);
  const size_t max_text_bytes = kMaxPulseTexts_bytes + kMaxTextOfPulse_bytes * num_pulses;
  size_t text_bytes = 0;
  for (size_t i = 0; i < num_pulses; ++i) {
    const pulse_end_t* source = ElementAt(columns.ends, columns.source[i]);
    const pulse_end_t* destination = ElementAt(columns.ends, columns.destination[i]);
    const pulse_style_t* style = ElementAt(columns.styles, columns.style[i]);
    if (source == nullptr || destination == nullptr || style == nullptr) return false;
    text_bytes += source->vehicle.size() + 1 + destination->vehicle.size() +
                  style->label_end.size() + style->ptype.size() + style->fill_color.size() +
                  style->edge_color.size();
    if (text_bytes > max_text_bytes) return false;
    comms_pulse_t& pulse = list->pulses[i];
    pulse.sx_m = source->x_m;
    pulse.sy_m = source->y_m;
    pulse.tx_m = destination->x_m;
    pulse.ty_m = destination->y_m;
    pulse.beam_width_m = columns.beam_width_m[i];
    pulse.duration_s = style->duration_s;
    pulse.fill = style->fill;
    pulse.label = source->vehicle;
    pulse.label += '2';
    pulse.label += destination->vehicle;
    pulse.label += style->label_end;
    pulse.ptype = style->ptype;
    pulse.fill_color = style->fill_color;
    pulse.edge_color = style->edge_color;
    pulse.edge_size = style->edge_size;
  }
  return true;
}

template <>
bool Decode(std::span<const uint8_t> data, comms_pulses_t* message) {
  if (ArePulseColumns(data)) {
    thread_local comms_pulse_columns_t columns;
    columns = {};
    return Decode(data, &columns) && ListOf(columns, message);
  }
  if (!WireLengthsAreSane(comms_pulses_t::getHash(), data)) return false;
  try {
    return message->decode(data.data(), 0, static_cast<int>(data.size())) ==
           static_cast<int>(data.size());
  } catch (const std::exception&) {
    return false;
  }
}

std::span<const uint8_t> WithPulsesAsList(std::span<const uint8_t> message, Bytes* storage) {
  if (!ArePulseColumns(message)) return message;
  thread_local comms_pulses_t list;
  if (!Decode(message, &list)) return message;
  EncodeInto(list, storage);
  return *storage;
}

}  // namespace shoal
