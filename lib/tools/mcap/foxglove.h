// Messages of the schemas that Foxglove, Rerun and PlotJuggler show without any setting
// (foxglove-sdk, schemas/proto/foxglove): a place on the map, a pose in space, a line of text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "shoal/nav_t.hpp"

namespace shoal {

/// A schema as an MCAP file has it.
struct FoxgloveSchema {
  std::string name;            ///< "foxglove.LocationFix".
  std::string descriptor_set;  ///< An encoded FileDescriptorSet.
};

[[nodiscard]] FoxgloveSchema LocationFixSchema();
[[nodiscard]] FoxgloveSchema PoseInFrameSchema();
[[nodiscard]] FoxgloveSchema LogSchema();

/// The frame of poses: x East, y North, z up, metres from the mission's origin.
inline constexpr std::string_view kMissionFrame = "mission";

/// Appends a foxglove.LocationFix: latitude, longitude, and -depth as altitude.
void AppendLocationFix(const nav_t& nav, std::string_view vehicle, std::string* out);

/// Appends a foxglove.PoseInFrame in kMissionFrame. The body's axes are forward, to port, up
/// (REP 103), where those of nav_t are forward, to starboard, down.
void AppendPoseInFrame(const nav_t& nav, std::string* out);

/// foxglove.Log's level.
enum class LogLevel : uint32_t { kDebug = 1, kInfo = 2, kWarning = 3, kError = 4 };

/// Appends a foxglove.Log.
/// @pre text and name are UTF-8.
void AppendLog(int64_t utime, LogLevel level, std::string_view name, std::string_view text,
               std::string* out);

}  // namespace shoal
