// `shoal plot`: a log as figures for a paper, drawn by gnuplot.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace shoal {

struct PlotOptions {
  std::string log;
  std::string out_dir;       ///< Made where it does not exist; empty: `plots` beside the log.
  std::string mission_file;  ///< Empty: mission.toml beside the log, if it is there.
  std::vector<std::string> overrides;  ///< Of mission_file's keys.
  std::vector<std::string> vehicles;   ///< Empty: all.
  std::optional<double> from_s;
  std::optional<double> to_s;
  bool png = false;
  bool keep = false;        ///< Leaves data and scripts in <out_dir>/gnuplot.
  std::string search_path;  ///< Where gnuplot is looked for: PATH.
};

/// Draws what the log holds, names the files in `out`, and what is left out and why; errors go
/// to `err`. Returns the exit code: kExitUsage for a mission file that does not load, vehicles that
/// the log does not have, a folder of scripts that is there already, `plots` beside the log that is
/// a symbolic link; kExitEnvironment where gnuplot is missing, the log cannot be read to its end
/// (what can be read is drawn), or nothing can be written.
int RunPlot(const PlotOptions& options, std::ostream& out, std::ostream& err);

}  // namespace shoal
