// Which type a logged message has, and whether its bytes are whole.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/schema/walk.h"
#include "lib/bus/bus/bus.h"

namespace shoal {

/// Returns shoal's own types and those of the .lcm files named, a user's own.
Result<Schema> LoadMessageTypes(const std::vector<std::string>& lcm_files);

/// A logged message without the seal that it may have (logs of lcm-logger hold sealed messages).
struct RecognisedMessage {
  std::span<const uint8_t> data;
  const StructType* type = nullptr;  ///< nullptr: its fingerprint is unknown.
  std::optional<WireFault> fault;    ///< Of a message whose type is known.

  bool IsDecodable() const { return type != nullptr && !fault; }
};

RecognisedMessage Recognise(const Schema& schema, std::span<const uint8_t> logged);

/// The same for what shows messages: one that has fates or pulses as columns becomes one that lists
/// them (lib/bus/bus/fate_columns.h, pulse_columns.h), as all logs had them, in `storage`.
RecognisedMessage RecogniseAsList(const Schema& schema, std::span<const uint8_t> logged,
                                  Bytes* storage);

/// Returns "nav_t" for shoal's own types, "their.package.pose_t" for others.
std::string DisplayName(const StructType& type);

/// Returns a description of a message of unknown type: "fingerprint 0x0123456789abcdef",
/// or "no fingerprint" where there are less than eight bytes.
std::string DescribeFingerprint(std::span<const uint8_t> message);

/// Returns the message's utime, where its type begins with that member.
/// @pre message.IsDecodable()
std::optional<int64_t> UtimeOf(const RecognisedMessage& message);

}  // namespace shoal
