#include "lib/sea/modem/raw_modem.h"

#include <algorithm>
#include <utility>

namespace shoal {

void RawModemReader::TakeLengthByte(uint8_t byte) {
  length_ = num_length_bytes_ == 0 ? byte : length_ << 8 | byte;
  if (++num_length_bytes_ < 2) return;
  ++counts_.received;
  num_missing_ = length_;
  is_skipping_ = length_ > options_.max_bytes;
  if (length_ == 0) {
    ++counts_.empty;
    num_length_bytes_ = 0;
  } else if (is_skipping_) {
    ++counts_.too_long;
  } else {
    ++counts_.delivered;
  }
}

std::vector<std::vector<uint8_t>> RawModemReader::Take(std::span<const uint8_t> bytes) {
  std::vector<std::vector<uint8_t>> payloads;
  while (!bytes.empty()) {
    if (num_length_bytes_ < 2) {
      TakeLengthByte(bytes.front());
      bytes = bytes.subspan(1);
      continue;
    }
    const auto part = bytes.first(std::min(num_missing_, bytes.size()));
    if (!is_skipping_) payload_.insert(payload_.end(), part.begin(), part.end());
    bytes = bytes.subspan(part.size());
    num_missing_ -= part.size();
    if (num_missing_ > 0) continue;
    num_length_bytes_ = 0;
    if (!is_skipping_) payloads.push_back(std::exchange(payload_, {}));
  }
  return payloads;
}

void RawModemReader::ForgetPiece() {
  if (num_length_bytes_ == 2 && !is_skipping_) {
    --counts_.delivered;
    ++counts_.cut_off;
  }
  num_length_bytes_ = 0;
  payload_.clear();
}

std::vector<uint8_t> EncodeRawPiece(std::span<const uint8_t> payload) {
  if (payload.empty() || payload.size() > kMaxRawPieceBytes) return {};
  std::vector<uint8_t> piece = {static_cast<uint8_t>(payload.size() >> 8),
                                static_cast<uint8_t>(payload.size() & 0xFF)};
  piece.insert(piece.end(), payload.begin(), payload.end());
  return piece;
}

}  // namespace shoal
