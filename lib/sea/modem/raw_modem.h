// Bytes in pieces over a stream, for hosts that want a modem and no protocol: what a client sends
// in one piece is one acoustic transmission, and what is received comes back in pieces.
//
//   2 bytes   length, the most significant byte first, 1 to 65535
//   n bytes   the payload
//
//   RawModemReader reader({.max_bytes = 512});
//   for (const std::vector<uint8_t>& payload : reader.Take(received)) Transmit(payload);
//   socket.Write(EncodeRawPiece(received));
//
// A piece that is longer than the limit is skipped as a whole, so that the next one is understood.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace shoal {

inline constexpr size_t kMaxRawPieceBytes = 65'535;

struct RawModemOptions {
  size_t max_bytes = kMaxRawPieceBytes;  ///< Of a payload; what the modem's packets hold.
};

/// What clients have sent. received = delivered + empty + too_long + cut_off.
struct RawModemCounts {
  int64_t received = 0;   ///< Pieces, once their length is known.
  int64_t delivered = 0;  ///< Of these, to the caller, or on their way.
  int64_t empty = 0;      ///< Of length 0: nothing to send.
  int64_t too_long = 0;
  int64_t cut_off = 0;  ///< The client went in the midst of it.

  bool operator==(const RawModemCounts&) const = default;
};

/// Finds the pieces in a stream, however it is cut. Holds at most one payload and two bytes.
class RawModemReader {
 public:
  explicit RawModemReader(const RawModemOptions& options) : options_(options) {}

  /// Takes what came next and returns the payloads that are complete with it.
  [[nodiscard]] std::vector<std::vector<uint8_t>> Take(std::span<const uint8_t> bytes);

  /// Forgets the piece that has begun, and keeps the counts: what comes next is another client's.
  void ForgetPiece();

  const RawModemCounts& counts() const { return counts_; }
  /// True at the beginning and behind a whole piece: a client that leaves now has lost nothing.
  bool is_between_pieces() const { return num_length_bytes_ == 0; }

 private:
  void TakeLengthByte(uint8_t byte);

  RawModemOptions options_;
  RawModemCounts counts_;
  int num_length_bytes_ = 0;  ///< Of the piece under way; 2 once it is known.
  size_t length_ = 0;
  size_t num_missing_ = 0;  ///< Bytes of the payload that are still to come.
  bool is_skipping_ = false;
  std::vector<uint8_t> payload_;
};

/// Returns the piece for a client; empty for a payload that no piece can hold, and for an empty
/// one.
[[nodiscard]] std::vector<uint8_t> EncodeRawPiece(std::span<const uint8_t> payload);

}  // namespace shoal
