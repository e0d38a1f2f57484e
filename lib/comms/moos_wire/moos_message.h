// One message of the wire protocol of MOOS, between a client and its MOOSDB.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace shoal {

/// What a message is for. Others exist ('C' command, 'A' anonymous, 'K' poison ...): a reader takes
/// any.
namespace moos_type {
inline constexpr char kNotify = 'N';
inline constexpr char kRegister = 'R';
inline constexpr char kUnregister = 'U';
inline constexpr char kWildcardRegister = '*';
inline constexpr char kWildcardUnregister = '/';
inline constexpr char kNull = '.';
inline constexpr char kData = 'i';     ///< Of the handshake: the client's name.
inline constexpr char kWelcome = 'W';  ///< Of the handshake: accepted.
inline constexpr char kPoison = 'K';   ///< Of the handshake: refused, the text has the reason.
inline constexpr char kServerRequest = 'Q';
inline constexpr char kTiming = 'T';
}  // namespace moos_type

/// What a message holds.
namespace moos_data {
inline constexpr char kDouble = 'D';
inline constexpr char kString = 'S';
inline constexpr char kBinary = 'B';  ///< In `text`, any bytes.
}  // namespace moos_data

/// Ids of messages that are not counted.
inline constexpr int32_t kMoosNoId = -1;       ///< Handshake, timing, present values.
inline constexpr int32_t kMoosRequestId = -2;  ///< Server requests and their answers.

struct MoosMessage {
  int32_t id = kMoosNoId;
  char type = moos_type::kNotify;
  char data_type = moos_data::kDouble;
  std::string source = {};      ///< Name of the client that wrote it.
  std::string source_aux = {};  ///< What that client adds to its name.
  std::string community = {};   ///< In which it was first written; empty from a client.
  std::string key = {};         ///< The variable.
  double time_s = 0;            ///< MOOS time: Unix time times the warp.
  double value = -1;            ///< -1 of a string.
  double value2 = -1;
  std::string text = {};  ///< Empty of a double.

  /// NaN is equal to NaN: the bytes count.
  bool operator==(const MoosMessage& other) const;

  bool IsDouble() const { return data_type == moos_data::kDouble; }
};

/// Returns a notify, with neither id nor time.
[[nodiscard]] MoosMessage MoosNotify(std::string_view source, std::string_view key, double value);
[[nodiscard]] MoosMessage MoosNotify(std::string_view source, std::string_view key,
                                     std::string_view text);

}  // namespace shoal
