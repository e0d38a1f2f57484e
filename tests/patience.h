// How much longer tests wait for what they expect where a sanitizer slows everything down.
#pragma once

namespace shoal {

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
inline constexpr double kPatienceFactor = 5;  ///< As the time limits of ctest (cmake/Shoal.cmake).
#else
inline constexpr double kPatienceFactor = 1;
#endif

}  // namespace shoal
