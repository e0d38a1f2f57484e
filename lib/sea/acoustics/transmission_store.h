// The transmissions of the acoustic network, each with its bytes, for as long as they are used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lib/base/random/stream.h"
#include "lib/sea/acoustics/places.h"
#include "lib/sea/acoustics/reception.h"

namespace shoal {

struct AcousticTransmission {
  PacketId packet;
  StreamKey key = StreamKey(0, {});
  int64_t turn = 0;  ///< It is the network's transmission of this number.
  double sent_s = 0;
  double air_s = 0;
  std::optional<double> data_rate_bps;  ///< Its own; absent: the network's.
  int32_t channel = 0;
  int32_t num_users = 0;
  std::vector<uint8_t> bytes;
};

class TransmissionStore {
 public:
  /// Returns the index of a transmission of these bytes; its caller fills in the rest.
  int32_t Take(std::span<const uint8_t> bytes) {
    const int32_t index = places_.Take();
    places_[index].bytes.assign(bytes.begin(), bytes.end());
    return index;
  }

  AcousticTransmission& operator[](int32_t index) { return places_[index]; }
  const AcousticTransmission& operator[](int32_t index) const { return places_[index]; }

  /// Counts one user less. The bytes of a transmission without users stay until Recycle.
  void Release(int32_t index) {
    if (--places_[index].num_users == 0) unused_.push_back(index);
  }

  /// Gives the places of transmissions without users to new ones.
  void Recycle();

  size_t num_places() const { return places_.num_places(); }

 private:
  Places<AcousticTransmission> places_;
  std::vector<int32_t> unused_;
};

}  // namespace shoal
