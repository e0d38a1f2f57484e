// The work of shoal-netcdf: one question about one NetCDF file, in a process that limits itself.
#pragma once

#include <string>
#include <vector>

namespace shoal {

/// Answers {"header"}, or {"values", variable, count}, about the file that is open as descriptor 3,
/// on standard output (lib/mission/netcdf/netcdf_wire.h), and ends this process. Before it opens
/// the file it limits memory, CPU time and open files of the process; after that it opens no other,
/// whatever the file names. @pre it is one of these questions
[[noreturn]] void AnswerNetcdf(const std::vector<std::string>& question);

/// The main function of shoal-netcdf.
int RunNetcdfReader(int argc, char** argv);

}  // namespace shoal
