#include "lib/run/verdict/fate_tally.h"

#include "lib/base/codec/little_endian.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

void FateTally::Take(std::span<const fate_t> fates) {
  for (const fate_t& fate : fates) {
    for (const Kind kind : kEnumerators<Kind>) {
      if (fate.kind != KindText(kind)) continue;
      this->fates(kind).Add(fate.source, fate.destination, fate.cause, fate.count);
      if (kind == Kind::kPacket) acoustic_.AddFate(VehicleKey(fate.source), fate.number);
    }
    for (const acoustic_path_t& path : fate.path) {
      acoustic_.Add({.cause = fate.cause,
                     .bits_flipped = path.bits_flipped,
                     .num_colliders = path.num_colliders});
    }
  }
}

void FateTally::AppendTo(std::vector<uint8_t>* bytes) const {
  for (const FateCounts& counts : fates_) counts.AppendTo(bytes);
  acoustic_.AppendTo(bytes);
}

bool FateTally::Add(std::span<const uint8_t> bytes) {
  LittleEndianReader reader(bytes);
  for (FateCounts& counts : fates_) {
    if (!counts.AddFrom(&reader)) return false;
  }
  return acoustic_.AddFrom(&reader) && reader.num_left() == 0;
}

}  // namespace shoal
