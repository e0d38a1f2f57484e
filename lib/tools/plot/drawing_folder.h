// Figures drawn by gnuplot into a folder, as commands do it.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "lib/tools/plot/plot_script.h"

namespace shoal {

struct DrawingOptions {
  std::filesystem::path out_dir;  ///< Made where it does not exist.
  bool png = false;               ///< Instead of SVG.
  bool keep = false;              ///< Leaves data and scripts in <out_dir>/gnuplot.
};

/// Writes the error to `err` where gnuplot is missing. Returns its path, empty where missing.
[[nodiscard]] std::string FindGnuplot(const std::string& search_path, std::ostream& err);

/// Draws the figures with the program `gnuplot`, names the files in `out`, and what is left out and
/// why; errors go to `err`. Returns kExitOk, or kExitEnvironment where gnuplot fails or nothing can
/// be written.
int DrawInto(const DrawingOptions& options, const std::string& gnuplot,
             const std::vector<Figure>& figures, std::ostream& out, std::ostream& err);

}  // namespace shoal
