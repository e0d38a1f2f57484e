#include "lib/run/run/read_tick.h"

#include <bit>
#include <cstring>

#include "lib/bus/bus/big_endian.h"

namespace shoal {

namespace {

/// Takes values off the beginning of a message, as LCM encodes them. After the first that is not
/// there, is_sound() is false and all are 0.
class WireReader {
 public:
  explicit WireReader(std::span<const uint8_t> rest) : rest_(rest) {}

  bool is_sound() const { return is_sound_; }
  bool is_at_end() const { return is_sound_ && rest_.empty(); }

  int64_t Int(size_t num_bytes) {
    const auto bytes = Take(num_bytes);
    if (bytes.empty()) return 0;
    const uint64_t value = ReadBigEndian(bytes);
    const auto unused = static_cast<int>(8 * (8 - num_bytes));
    return static_cast<int64_t>(value << unused) >> unused;  // The sign, too.
  }
  double Double() { return std::bit_cast<double>(Int(8)); }

  /// A size, a text without NUL, and the NUL that ends it.
  std::string_view Text() {
    const int64_t size = Int(4);
    if (size < 1) is_sound_ = false;
    const auto bytes = Take(is_sound_ ? static_cast<size_t>(size) : 0);
    if (bytes.empty()) return {};
    const void* end = std::memchr(bytes.data(), 0, bytes.size());
    if (end != &bytes.back()) is_sound_ = false;
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size() - 1};
  }

  /// The number of elements of a list, each of `least_bytes` or more.
  int32_t Count(size_t least_bytes) {
    const int64_t count = Int(4);
    if (count < 0 || static_cast<size_t>(count) > rest_.size() / least_bytes) is_sound_ = false;
    return is_sound_ ? static_cast<int32_t>(count) : 0;
  }

 private:
  std::span<const uint8_t> Take(size_t num_bytes) {
    if (num_bytes > rest_.size()) is_sound_ = false;
    if (!is_sound_) return {};
    const auto taken = rest_.first(num_bytes);
    rest_ = rest_.subspan(num_bytes);
    return taken;
  }

  std::span<const uint8_t> rest_;
  bool is_sound_ = true;
};

constexpr size_t kLeastText = 5;                    ///< Bytes: its size, and a NUL.
constexpr size_t kLeastTotal = 2 * kLeastText + 4;  ///< Two texts and a count.

void ReadTotals(WireReader* reader, const WantsTotal& wants, tick_t* tick) {
  const int32_t num_totals = reader->Count(kLeastTotal);
  for (int32_t i = 0; i < num_totals && reader->is_sound(); ++i) {
    const std::string_view publisher = reader->Text();
    const std::string_view channel = reader->Text();
    const auto count = static_cast<int32_t>(reader->Int(4));
    if (!reader->is_sound() || !wants(publisher, channel)) continue;
    tick->totals.push_back(
        {.publisher = std::string(publisher), .channel = std::string(channel), .count = count});
  }
  tick->num_totals = static_cast<int32_t>(tick->totals.size());
}

}  // namespace

bool ReadTick(std::span<const uint8_t> message, const WantsTotal& wants, tick_t* tick) {
  WireReader reader(message);
  if (reader.Int(8) != tick_t::getHash()) return false;
  *tick = tick_t{};
  tick->utime = reader.Int(8);
  tick->mission_id = reader.Int(8);
  tick->step = reader.Int(8);
  tick->kind = static_cast<int8_t>(reader.Int(1));
  tick->warp = reader.Double();
  ReadTotals(&reader, wants, tick);
  tick->num_joined = reader.Count(kLeastText);
  for (int32_t i = 0; i < tick->num_joined; ++i) tick->joined.emplace_back(reader.Text());
  for (int32_t i = 0; i < tick->num_joined; ++i) {
    tick->joined_pids.push_back(static_cast<int32_t>(reader.Int(4)));
  }
  return reader.is_at_end();
}

}  // namespace shoal
