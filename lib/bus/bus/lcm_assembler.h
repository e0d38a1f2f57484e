// LCM's UDP datagrams, checked and put together to messages. (liblcm 1.3.1 trusts what they state:
// a channel name without its end, or a fragment beyond its message, ends the process.)
//
//   LC02: magic | sequence 4 | channel name, 0 | the message
//   LC03: magic | sequence 4 | message size 4 | offset 4 | fragment 2 | number of fragments 2 |
//         in fragment 0 the channel name, 0 | a part of the message
//
// All numbers are big-endian. Pure: no socket, no clock.
//
//   LcmAssembler assembler;
//   if (const auto message = assembler.Add(sender, datagram)) handle(message->channel, ...);
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace shoal {

inline constexpr uint32_t kLcmWholeMagic = 0x4c433032;     ///< "LC02"
inline constexpr uint32_t kLcmFragmentMagic = 0x4c433033;  ///< "LC03"

/// A whole message. The views live until the assembler is given the next datagram.
struct LcmMessage {
  std::string_view channel;  ///< 1 to 63 bytes.
  std::span<const uint8_t> data;
};

class LcmAssembler {
 public:
  static constexpr size_t kMaxChannel = 63;  ///< Bytes; LCM's own limit.
  /// Fragments that wait for others of their message take at most this many bytes; LCM's own limit.
  static constexpr size_t kMaxPendingBytes = size_t{16} * 1024 * 1024;
  static constexpr size_t kMaxPending = 64;  ///< Messages that wait for fragments.
  /// Of these, of one sender: threads that share a socket interleave theirs.
  static constexpr size_t kMaxPendingOfSender = 4;

  /// Takes a datagram as it came. `sender` distinguishes the senders of fragments: any number.
  /// Returns the message that it completes, if it completes one.
  std::optional<LcmMessage> Add(uint64_t sender, std::span<const uint8_t> datagram);

  /// Datagrams that LCM cannot have sent: refused.
  int64_t num_malformed() const { return num_malformed_; }
  /// Messages given up: a fragment did not come, or too many waited for theirs.
  int64_t num_abandoned() const { return num_abandoned_; }
  size_t num_pending() const { return pending_.size(); }
  size_t pending_bytes() const { return pending_bytes_; }

 private:
  struct Header;
  struct Piece {
    uint32_t offset = 0;
    uint32_t size = 0;
  };
  struct Pending {
    uint32_t size = 0;
    uint16_t num_fragments = 0;
    int64_t order = 0;                 ///< In which it began: the oldest goes first.
    std::string channel;               ///< Empty until fragment 0 is there.
    std::map<uint16_t, Piece> pieces;  ///< By fragment.
    size_t num_bytes = 0;              ///< What it takes of kMaxPendingBytes.
    /// Not initialised: it is read only when the pieces fill it.
    std::unique_ptr<uint8_t[]> data;
  };
  using Key = std::pair<uint64_t, uint32_t>;  ///< Sender and sequence.
  using PendingMap = std::map<Key, Pending>;

  std::optional<LcmMessage> AddFragment(uint64_t sender, std::span<const uint8_t> datagram);
  PendingMap::iterator Await(uint64_t sender, const Header& header);
  void Forget(PendingMap::iterator pending);
  void GiveUpOldestOf(uint64_t sender);
  void MakeRoom(size_t num_bytes, const Key& kept);

  PendingMap pending_;
  Pending done_;  ///< The last one completed, whose views are in use.
  size_t pending_bytes_ = 0;
  int64_t order_ = 0;
  int64_t num_malformed_ = 0;
  int64_t num_abandoned_ = 0;
};

}  // namespace shoal
