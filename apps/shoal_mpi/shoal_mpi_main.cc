// shoal-mpi: one mission by many processes, under mpirun or srun. See shoal-mpi --help.
#include "apps/shoal_mpi/mpi_options.h"
#include "apps/shoal_mpi/watched_process.h"

int main(int argc, char** argv) {
  const shoal::MpiOptions options = shoal::ParseMpiOptionsOrExit(argc, argv);
  return shoal::RunWatched([&] { return shoal::RunMpiMission(options); });
}
