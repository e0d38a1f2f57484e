// muNet's REPORT and RESPONSE: where a vehicle is and how it moves, in 37 bytes.
//
//   byte  0  type, four letters: RPRT or RSPN
//         4  group_id
//         5  reporter_id      uint32
//         9  reporter_pos     3 x float32, m
//        21  reporter_vel     3 x float32, m/s
//        33  time_stamp       float32, s
//
// Numbers are little-endian. Nothing in it shows whether it was damaged on its way.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace shoal {

inline constexpr size_t kReportBytes = 37;

/// The four letters that a message begins with.
using MessageFlag = std::array<char, 4>;
inline constexpr MessageFlag kReportFlag = {'R', 'P', 'R', 'T'};
inline constexpr MessageFlag kResponseFlag = {'R', 'S', 'P', 'N'};

struct ReportMessage {
  MessageFlag flag = kReportFlag;
  uint8_t group_id = 0;
  uint32_t reporter_id = 0;
  Eigen::Vector3f position_m = Eigen::Vector3f::Zero();    ///< x East, y North, z down.
  Eigen::Vector3f velocity_mps = Eigen::Vector3f::Zero();  ///< Over ground, in the same frame.
  float time_stamp_s = 0;                                  ///< Seconds of mission time.

  bool operator==(const ReportMessage&) const = default;
};

/// Returns kReportBytes bytes.
[[nodiscard]] std::vector<uint8_t> EncodeReport(const ReportMessage& report);

/// Returns the values in the bytes, valid or not; bytes behind the 37th do not matter. Nothing
/// where there are fewer.
[[nodiscard]] std::optional<ReportMessage> DecodeReport(std::span<const uint8_t> bytes);

}  // namespace shoal
