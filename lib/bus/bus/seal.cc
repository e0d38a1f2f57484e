#include "lib/bus/bus/seal.h"

#include <sodium.h>

#include <array>

#include "lib/base/check/check.h"
#include "lib/bus/bus/big_endian.h"

namespace shoal {

namespace {

constexpr uint32_t kSealMagic = 0x53484f32;
constexpr size_t kTagSize = 16;
constexpr size_t kMagicSize = 4;
constexpr size_t kNumbersSize = 1 + 8 + 8 + 4;
constexpr size_t kFixedSize = kNumbersSize + kTagSize + kMagicSize;
constexpr size_t kMaxNameSize = 100;

using Tag = std::array<uint8_t, kTagSize>;

Tag TagOf(std::span<const uint8_t> tagged, const MissionSecret& secret, std::string_view channel) {
  // Chooses the fastest implementation for this processor, once.
  static const int is_ready = sodium_init();
  SHOAL_CHECK(is_ready >= 0, "libsodium works on this machine");
  constexpr uint8_t kEnd = 0;
  Tag tag{};
  crypto_generichash_state state;
  crypto_generichash_init(&state, secret.bytes.data(), secret.bytes.size(), kTagSize);
  crypto_generichash_update(&state, reinterpret_cast<const uint8_t*>(channel.data()),
                            channel.size());
  crypto_generichash_update(&state, &kEnd, 1);
  crypto_generichash_update(&state, tagged.data(), tagged.size());
  crypto_generichash_final(&state, tag.data(), kTagSize);
  return tag;
}

}  // namespace

void AppendSeal(const Seal& seal, const MissionSecret& secret, std::string_view channel,
                std::vector<uint8_t>* message) {
  SHOAL_CHECK(!seal.publisher.empty() && seal.publisher.size() <= kMaxNameSize,
              "a publisher's name has 1 to 100 bytes");
  message->insert(message->end(), seal.publisher.begin(), seal.publisher.end());
  message->push_back(static_cast<uint8_t>(seal.publisher.size()));
  AppendBigEndian(static_cast<uint64_t>(seal.mission_id), 8, message);
  AppendBigEndian(static_cast<uint64_t>(seal.step), 8, message);
  AppendBigEndian(seal.sequence, 4, message);
  const Tag tag = TagOf(*message, secret, channel);
  message->insert(message->end(), tag.begin(), tag.end());
  AppendBigEndian(kSealMagic, kMagicSize, message);
}

Unsealed Unseal(std::span<const uint8_t> datagram) {
  const Unsealed outside{.message = datagram, .seal = std::nullopt, .tagged = {}, .tag = {}};
  if (datagram.size() < kFixedSize) return outside;
  if (ReadBigEndian(datagram.last(kMagicSize)) != kSealMagic) return outside;
  const auto tagged = datagram.first(datagram.size() - kTagSize - kMagicSize);
  const auto numbers = tagged.last(kNumbersSize);
  const size_t name_size = numbers[0];
  if (name_size == 0 || name_size > kMaxNameSize || tagged.size() < kNumbersSize + name_size) {
    return outside;
  }
  const size_t size = tagged.size() - kNumbersSize - name_size;
  const auto name = tagged.subspan(size, name_size);
  return {.message = datagram.first(size),
          .seal = Seal{.publisher = {reinterpret_cast<const char*>(name.data()), name.size()},
                       .mission_id = static_cast<int64_t>(ReadBigEndian(numbers.subspan(1, 8))),
                       .step = static_cast<int64_t>(ReadBigEndian(numbers.subspan(9, 8))),
                       .sequence = static_cast<uint32_t>(ReadBigEndian(numbers.subspan(17, 4)))},
          .tagged = tagged,
          .tag = datagram.subspan(tagged.size(), kTagSize)};
}

bool IsGenuine(const Unsealed& unsealed, const MissionSecret& secret, std::string_view channel) {
  if (!unsealed.seal || unsealed.tag.size() != kTagSize) return false;
  const Tag expected = TagOf(unsealed.tagged, secret, channel);
  return sodium_memcmp(expected.data(), unsealed.tag.data(), kTagSize) == 0;
}

}  // namespace shoal
