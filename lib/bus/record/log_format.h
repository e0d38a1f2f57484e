// The LCM event log, as lcm-logger writes it. All numbers are big-endian.
//
//   magic            4 bytes   0xeda1da01
//   event number     8 bytes   counts from 0
//   time             8 bytes   microseconds
//   channel length   4 bytes
//   data length      4 bytes
//   channel          without NUL
//   data             an encoded message
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace shoal {

inline constexpr uint32_t kLogMagic = 0xeda1da01;
inline constexpr size_t kLogHeaderSize = 28;
/// LCM's own reader refuses longer names in a log; on the bus it is 63.
inline constexpr size_t kMaxLogChannelLength = 999;
/// LCM's own reader holds the length in an int32_t.
inline constexpr size_t kMaxLogDataLength = 0x7fffffff;

/// One message in a log. The views live until the reader goes on.
struct LogEvent {
  int64_t number = 0;
  int64_t utime = 0;
  std::string_view channel;
  std::span<const uint8_t> data;
  uint64_t offset = 0;  ///< Of the event in the file.
};

}  // namespace shoal
