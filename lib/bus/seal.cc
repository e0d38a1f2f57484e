#include "lib/bus/seal.h"

#include "lib/check/check.h"

namespace shoal {

namespace {

constexpr uint32_t kSealMagic = 0x53484f4c;
constexpr size_t kFixedSize = 1 + 8 + 8 + 4 + 4;
constexpr size_t kMaxNameSize = 100;

void Append(uint64_t value, int num_bytes, std::vector<uint8_t>* out) {
  for (int shift = 8 * (num_bytes - 1); shift >= 0; shift -= 8) {
    out->push_back(static_cast<uint8_t>(value >> shift));
  }
}

uint64_t ReadBigEndian(std::span<const uint8_t> bytes) {
  uint64_t value = 0;
  for (const uint8_t byte : bytes) value = value << 8 | byte;
  return value;
}

}  // namespace

void AppendSeal(const Seal& seal, std::vector<uint8_t>* message) {
  SHOAL_CHECK(!seal.publisher.empty() && seal.publisher.size() <= kMaxNameSize,
              "a publisher's name has 1 to 100 bytes");
  message->insert(message->end(), seal.publisher.begin(), seal.publisher.end());
  message->push_back(static_cast<uint8_t>(seal.publisher.size()));
  Append(static_cast<uint64_t>(seal.mission_id), 8, message);
  Append(static_cast<uint64_t>(seal.step), 8, message);
  Append(seal.sequence, 4, message);
  Append(kSealMagic, 4, message);
}

Unsealed Unseal(std::span<const uint8_t> datagram) {
  const Unsealed outside{.message = datagram, .seal = std::nullopt};
  if (datagram.size() < kFixedSize) return outside;
  const auto fixed = datagram.last(kFixedSize);
  if (ReadBigEndian(fixed.subspan(21, 4)) != kSealMagic) return outside;
  const size_t name_size = fixed[0];
  if (name_size == 0 || name_size > kMaxNameSize || datagram.size() < kFixedSize + name_size) {
    return outside;
  }
  const auto name = datagram.subspan(datagram.size() - kFixedSize - name_size, name_size);
  return {.message = datagram.first(datagram.size() - kFixedSize - name_size),
          .seal = Seal{.publisher = {reinterpret_cast<const char*>(name.data()), name.size()},
                       .mission_id = static_cast<int64_t>(ReadBigEndian(fixed.subspan(1, 8))),
                       .step = static_cast<int64_t>(ReadBigEndian(fixed.subspan(9, 8))),
                       .sequence = static_cast<uint32_t>(ReadBigEndian(fixed.subspan(17, 4)))}};
}

}  // namespace shoal
