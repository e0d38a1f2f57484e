// What travels between `shoal run` and a `shoal host`: one message of ZeroMQ each.
//
//   magic       4 bytes    0x53484c31, "SHL1"; all numbers big-endian
//   kind        1 byte     LinkKind
//   mission_id  8 bytes    0: before there is one
//   step        8 bytes    -1: of no step
//   sequence    8 bytes    counts the messages of this direction from 0
//   count       4 bytes    of parts
//   per part:   2 bytes    size of the name
//               4 bytes    size of the data
//               name, data
//   digest      32 bytes   BLAKE2b over all before
//
// The digest finds what was torn or mixed up on the way; that no other wrote it is CURVE's part
// (lib/run/hosts/curve_link.h). Pure.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/bus.h"

namespace shoal {

enum class LinkKind : uint8_t {
  kOffer = 1,  ///< Home: a mission, all that a host needs to run its part (host_offer.h).
  kAccept,     ///< Host: its processes start.
  kRefuse,     ///< Host: part "why".
  kTick,       ///< Home: step `step` begins; datagrams of the step before, TICK last.
  kDone,       ///< Host: datagrams of step `step`, STEP_DONE last; -1: hellos.
  kAside,      ///< Either: requests for pages and their answers.
  kStart,      ///< Home: starts the process of part "name" again.
  kSignal,     ///< Home: sends the process of part "name" the signal of part "signal".
  kExit,       ///< Host: a process has ended (host_offer.h).
  kAlive,      ///< Either: nothing but a sign of life.
  kEnd,        ///< Home: the mission is over; the host ends its processes.
  kPing,       ///< Doctor: part "load" is to come back.
  kPong,       ///< Host: the load, and part "utc_us".
};

struct LinkPart {
  std::string name;  ///< A channel, mostly; up to 65,535 bytes.
  Bytes data;

  bool operator==(const LinkPart&) const = default;
};

struct LinkMessage {
  LinkKind kind = LinkKind::kAlive;
  int64_t mission_id = 0;
  int64_t step = -1;
  std::vector<LinkPart> parts = {};

  /// Returns the first part of this name, or nullptr.
  const LinkPart* Find(std::string_view name) const;
  /// Returns the text of the first part of this name as one line that a terminal can show
  /// (lib/base/text/terminal_text.h); empty where there is none.
  std::string TextOf(std::string_view name) const;
  void AddText(std::string_view name, std::string_view text);

  bool operator==(const LinkMessage&) const = default;
};

inline constexpr size_t kLargestLinkMessage_bytes = size_t{64} << 20;
inline constexpr size_t kMaxLinkParts = 1'000'000;

/// Returns the most bytes and parts that a message of this kind may have.
struct LinkLimits {
  size_t bytes = 0;
  size_t parts = 0;
};
[[nodiscard]] LinkLimits LimitsOf(LinkKind kind);

/// Encodes `message` as number `sequence` of its direction.
[[nodiscard]] Bytes EncodeLinkMessage(const LinkMessage& message, uint64_t sequence);

/// Takes what arrives on one direction of a link: each message once, in order, and whole.
class LinkIntake {
 public:
  /// Returns the message; an error names what is wrong with it: torn, replayed, of another mission,
  /// too large. What was refused counts, and is not waited for.
  [[nodiscard]] Result<LinkMessage> Take(std::span<const uint8_t> bytes);

  /// Refuses messages of other missions from now on.
  void set_mission_id(int64_t mission_id) { mission_id_ = mission_id; }

  int64_t num_refused() const { return num_refused_; }
  /// True where a message is missing for good: all that follows is refused.
  bool has_gap() const { return has_gap_; }

 private:
  Result<LinkMessage> Refuse(std::string why);

  int64_t mission_id_ = 0;  ///< 0: any.
  uint64_t next_sequence_ = 0;
  int64_t num_refused_ = 0;
  bool has_gap_ = false;
};

}  // namespace shoal
