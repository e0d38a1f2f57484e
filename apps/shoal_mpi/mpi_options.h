// The command line of shoal-mpi.
#pragma once

#include "apps/shoal_mpi/mpi_mission.h"

namespace shoal {

/// Parses the command line; ends the process for --help, --version and what is wrong with it.
MpiOptions ParseMpiOptionsOrExit(int argc, char** argv);

/// The main function of shoal-mpi.
int RunShoalMpi(int argc, char** argv);

}  // namespace shoal
