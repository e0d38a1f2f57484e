// Reads a NetCDF file for shoal, and answers on standard output (lib/mission/netcdf/netcdf_wire.h).
//
//   shoal-netcdf header 3< tide.nc
//   shoal-netcdf values u 1200 3< tide.nc      the variable's name, and how many values it has
//
// The file is descriptor 3: libnetcdf sees no name, which it might take for an address in the net.
// What crashes libnetcdf ends this process alone.
#include <cstdio>
#include <string>
#include <vector>

#include "apps/netcdf_reader/answer.h"
#include "lib/run/command_line/version.h"

namespace shoal {

namespace {

constexpr char kUsage[] =
    "usage: shoal-netcdf header 3< FILE\n"
    "       shoal-netcdf values VARIABLE COUNT 3< FILE\n\n"
    "Reads a NetCDF file for the other programs of shoal, which start it themselves. The answer "
    "is\n"
    "for programs: lib/mission/netcdf/netcdf_wire.h. To look at a file, use ncdump.\n";

}  // namespace

int RunNetcdfReader(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const bool is_header = words.size() == 1 && words[0] == "header";
  const bool is_values = words.size() == 3 && words[0] == "values";
  if (is_header || is_values) AnswerNetcdf(words);
  const bool is_help = words.size() == 1 && words[0] == "--help";
  if (words.size() == 1 && words[0] == "--version") {
    std::printf("shoal-netcdf %s\n", kVersion);
    return 0;
  }
  std::fputs(kUsage, is_help ? stdout : stderr);
  return is_help ? 0 : 2;
}

}  // namespace shoal
