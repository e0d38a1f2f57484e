// A Slurm on this machine alone, for tests: a controller and two nodes, without privileges or
// systemd.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/missions/shoal_process.h"

namespace shoal {

/// True where a program of this name is on the PATH.
inline bool IsInstalled(const std::string& program) {
  return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
}

/// SLURM_CONF names it while it exists.
class SlurmOfOneBox {
 public:
  explicit SlurmOfOneBox(const TestFolder& folder) {
    char host[256] = {};
    gethostname(host, sizeof host - 1);
    const std::string path = (folder.path() / "slurm").string();
    for (const char* each : {"state", "spool/n1", "spool/n2", "log", "run"}) {
      std::filesystem::create_directories(path + "/" + each);
    }
    const int port = FreeTcpPorts(3);
    const char* user = std::getenv("USER");
    if (geteuid() == 0 || user == nullptr) user = "root";
    const std::string file = path + "/slurm.conf";
    WriteFile(file,
              "ClusterName=onebox\nSlurmctldHost=" + std::string(host) +
                  "(127.0.0.1)\nSlurmUser=" + user + "\nSlurmdUser=" + user +
                  "\nAuthType=auth/none\nCredType=cred/none\nStateSaveLocation=" + path +
                  "/state\nSlurmdSpoolDir=" + path + "/spool/%n\nSlurmctldPidFile=" + path +
                  "/run/ctld.pid\nSlurmdPidFile=" + path + "/run/%n.pid\nSlurmctldLogFile=" + path +
                  "/log/ctld.log\nSlurmdLogFile=" + path +
                  "/log/%n.log\nSlurmctldPort=" + std::to_string(port) +
                  "\nProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\nMailProg=/bin/true\n"
                  "MpiDefault=none\nSelectType=select/cons_tres\nSelectTypeParameters=CR_Core\n"
                  "SchedulerParameters=sched_min_interval=0,sched_interval=1,batch_sched_delay=0\n"
                  "ReturnToService=2\nMaxArraySize=10001\nNodeName=n[1-2] NodeHostname=" +
                  host + " NodeAddr=127.0.0.1 Port=" + std::to_string(port + 1) + "-" +
                  std::to_string(port + 2) +
                  " CPUs=2 State=UNKNOWN\n"
                  "PartitionName=debug Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n");
    setenv("SLURM_CONF", file.c_str(), 1);
    is_up_ = std::system(("slurmctld -c -f " + file).c_str()) == 0 &&
             std::system(("slurmd -c -N n1 -f " + file).c_str()) == 0 &&
             std::system(("slurmd -c -N n2 -f " + file).c_str()) == 0 &&
             AwaitThat([] { return std::system("sinfo -h -o %t | grep -q idle") == 0; });
  }
  ~SlurmOfOneBox() {
    static_cast<void>(std::system("scontrol shutdown > /dev/null 2>&1"));
    unsetenv("SLURM_CONF");
  }
  SlurmOfOneBox(const SlurmOfOneBox&) = delete;
  SlurmOfOneBox& operator=(const SlurmOfOneBox&) = delete;

  bool is_up() const { return is_up_; }

 private:
  bool is_up_ = false;
};

}  // namespace shoal
