// `shoal rays`: the paths of sound between two places of a mission's sea, or of a .env of Bellhop.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace shoal {

struct RaysOptions {
  std::string file = {};
  std::string from = {};  ///< "x,y,z"; empty: that of a .env.
  std::string to = {};
  std::vector<std::string> overrides = {};  ///< Of a mission's keys.
  bool plot = false;
  std::string out_dir = {};  ///< Empty: rays.
  bool png = false;
  bool keep = false;
  std::string search_path = {};  ///< Where gnuplot is looked for: PATH.
};

/// Writes the arrivals as a table to `out`, and draws them where asked for; errors go to `err`.
/// Returns the exit code: kExitUsage for a file that does not load, a mission without rays, places
/// that are not in the water; kExitEnvironment where gnuplot is missing or nothing can be written.
int RunRays(const RaysOptions& options, std::ostream& out, std::ostream& err);

}  // namespace shoal
