#include "apps/shoal/doctor.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/shoal/doctor_facts.h"
#include "lib/base/check/result.h"

namespace shoal {

namespace {

constexpr int64_t kMiB = int64_t{1024} * 1024;
constexpr int64_t kWantedReceiveBuffer_bytes = 2 * kMiB;
/// What the kernel charges for a datagram of 300 bytes, so that 2 MiB hold about 3,200 of them.
constexpr int64_t kCostOfOneDatagram_bytes = 640;
constexpr int64_t kLittleSpace_bytes = 1024 * kMiB;
constexpr int64_t kNoSpace_bytes = 50 * kMiB;
/// A process holds six descriptors per LCM port, and the broker of a large mission 131 ports.
constexpr int64_t kWantedOpenFiles = 1024;
constexpr int64_t kNeededOpenFiles = 64;
/// Three processes per vehicle with up to four threads each, for 50 vehicles; and for two.
constexpr int64_t kWantedThreads = 1000;
constexpr int64_t kNeededThreads = 50;

Diagnosis DiagnoseMulticast(const DoctorFacts& facts) {
  const MulticastTrial& trial = facts.multicast;
  if (trial.opened && trial.received >= trial.sent) {
    return {.text = fmt::format("multicast: {} of {} messages came back over LCM", trial.received,
                                trial.sent)};
  }
  if (!trial.opened) {
    return {.health = Health::kFail,
            .text =
                "multicast: there is no route to LCM's group 239.255.76.67, so processes receive "
                "nothing from each other",
            .remedies = {"sudo ip link set lo up multicast on",
                         "sudo ip route add 224.0.0.0/4 dev lo"}};
  }
  if (trial.received > 0) {
    return {.health = Health::kFail,
            .text = fmt::format("multicast: only {} of {} messages came back over LCM; either the "
                                "machine is very busy or its receive buffer very small",
                                trial.received, trial.sent),
            .remedies = {"sudo sysctl -w net.core.rmem_max=4194304"}};
  }
  return {
      .health = Health::kFail,
      .text =
          "multicast: messages are sent, but none is received; most often a firewall drops them",
      .remedies = {"sudo iptables -I INPUT -d 239.255.76.67 -p udp -j ACCEPT",
                   "sudo ip route add 224.0.0.0/4 dev lo"}};
}

Diagnosis DiagnoseReceiveBuffer(const DoctorFacts& facts) {
  const int64_t limit = facts.receive_buffer_limit_bytes;
  const int64_t num_datagrams = limit / kCostOfOneDatagram_bytes;
  if (limit >= kWantedReceiveBuffer_bytes) {
    return {.text = fmt::format("receive buffer: up to {} bytes (net.core.rmem_max), about {} "
                                "messages at once",
                                limit, num_datagrams)};
  }
  Diagnosis diagnosis{
      .health = Health::kWarn,
      .text =
          fmt::format("receive buffer: only {} bytes (net.core.rmem_max); of more than about {} "
                      "messages at once some are lost and asked for again, which takes time. "
                      "Enough for a few vehicles",
                      limit, num_datagrams),
      .remedies = {"sudo sysctl -w net.core.rmem_max=4194304",
                   "echo net.core.rmem_max=4194304 | sudo tee /etc/sysctl.d/60-shoal.conf"}};
  if (facts.in_container) diagnosis.text += ". In a container: set it on the host";
  return diagnosis;
}

Diagnosis DiagnosePorts(const DoctorFacts& facts) {
  if (!facts.port_base) {
    return {
        .health = Health::kFail,
        .text = fmt::format("ports: no free block of UDP ports from {} on", PortPlan::kDefaultBase),
        .remedies = {"ss -ulnp", "shoal status"}};
  }
  if (*facts.port_base == PortPlan::kDefaultBase) {
    return {.text = fmt::format("ports: free from {} on", PortPlan::kDefaultBase)};
  }
  return {.text = fmt::format("ports: those from {} on are taken; the next mission gets those from "
                              "{} on",
                              PortPlan::kDefaultBase, *facts.port_base)};
}

Diagnosis DiagnoseRunning(const DoctorFacts& facts) {
  if (!facts.run_folder_error.empty()) {
    return {.health = Health::kFail, .text = "running missions: " + facts.run_folder_error};
  }
  if (facts.running.empty()) return {.text = "running missions: none"};
  std::string list;
  for (const RunningMission& mission : facts.running) {
    list += fmt::format("{}{} (--port {}, pid {})", list.empty() ? "" : ", ", mission.name,
                        mission.port_base, mission.pid);
  }
  return {.text = "running missions: " + list};
}

Diagnosis DiagnoseDisk(const DoctorFacts& facts) {
  if (!facts.folder_free_bytes) {
    return {.health = Health::kWarn,
            .text = fmt::format("disk: cannot find out how much is free in {}", facts.folder),
            .remedies = {"df -h ."}};
  }
  const int64_t free_bytes = *facts.folder_free_bytes;
  const std::string text = fmt::format("disk: {} MiB free in {}", free_bytes / kMiB, facts.folder);
  if (free_bytes >= kLittleSpace_bytes) return {.text = text};
  return {.health = free_bytes < kNoSpace_bytes ? Health::kFail : Health::kWarn,
          .text = text + ", where `shoal run --record` writes; a full disk ends the mission",
          .remedies = {"df -h ."}};
}

Diagnosis DiagnoseLimit(std::string_view what, const std::optional<int64_t>& limit, int64_t needed,
                        int64_t wanted, std::string_view meaning, std::string_view option) {
  if (!limit) return {.text = fmt::format("{}: no limit", what)};
  if (*limit >= wanted) return {.text = fmt::format("{}: up to {}", what, *limit)};
  return {.health = *limit < needed ? Health::kFail : Health::kWarn,
          .text = fmt::format("{}: only {}; {}", what, *limit, meaning),
          .remedies = {fmt::format("ulimit {} {}", option, wanted)}};
}

Diagnosis DiagnoseSpy(const DoctorFacts& facts) {
  std::string missing;
  const auto miss = [&](bool is_missing, std::string_view what) {
    if (is_missing) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", what);
  };
  miss(facts.java.empty(), "Java");
  miss(!facts.java.empty() && !facts.java_has_windows, "a Java that can open windows");
  miss(!facts.has_lcm_jar, "lcm.jar");
  miss(!facts.has_chart_jar, "jchart2d.jar");
  const bool packages_missing = !missing.empty();
  miss(facts.types_jar.empty(), "shoal_types.jar");
  Diagnosis diagnosis;
  if (packages_missing)
    diagnosis.remedies.push_back(facts.source_dir + "/scripts/setup --with-spy");
  if (facts.types_jar.empty()) {
    diagnosis.remedies.push_back(
        fmt::format("cd {} && cmake --preset release && cmake --build build --target "
                    "shoal_types_jar",
                    facts.source_dir));
  }
  if (!missing.empty()) {
    diagnosis.health = Health::kWarn;
    diagnosis.text = fmt::format("lcm-spy: missing {}; missions run without", missing);
  } else if (!facts.has_display) {
    diagnosis.health = Health::kWarn;
    diagnosis.text = "lcm-spy: installed, but no screen found (DISPLAY is not set)";
    diagnosis.remedies = {"ssh -X THIS_MACHINE"};
  } else {
    diagnosis.text = fmt::format("lcm-spy: installed; {}/scripts/spy starts it", facts.source_dir);
  }
  return diagnosis;
}

std::string_view Word(Health health) {
  switch (health) {
    case Health::kOk:
      return "OK  ";
    case Health::kWarn:
      return "WARN";
    case Health::kFail:
      break;
  }
  return "FAIL";
}

int64_t Count(const std::vector<Diagnosis>& diagnoses, Health health) {
  return std::count_if(diagnoses.begin(), diagnoses.end(),
                       [&](const Diagnosis& diagnosis) { return diagnosis.health == health; });
}

}  // namespace

std::vector<Diagnosis> Diagnose(const DoctorFacts& facts) {
  return {
      DiagnoseMulticast(facts),
      DiagnoseReceiveBuffer(facts),
      DiagnosePorts(facts),
      DiagnoseRunning(facts),
      DiagnoseDisk(facts),
      DiagnoseLimit("open files", facts.max_open_files, kNeededOpenFiles, kWantedOpenFiles,
                    "a process needs six for each LCM port it receives on, one port per vehicle in "
                    "the communities layout",
                    "-n"),
      DiagnoseLimit(
          "processes and threads", facts.max_threads, kNeededThreads, kWantedThreads,
          "a mission needs about twelve per vehicle; fewer with `shoal run --grouping vehicle`",
          "-u"),
      DiagnoseSpy(facts)};
}

std::string DiagnosisLines(const std::vector<Diagnosis>& diagnoses) {
  std::string text;
  for (const Diagnosis& diagnosis : diagnoses) {
    text += fmt::format("{}  {}\n", Word(diagnosis.health), diagnosis.text);
    for (const std::string& remedy : diagnosis.remedies)
      text += fmt::format("        {}\n", remedy);
  }
  return text;
}

std::string FormatDiagnoses(const std::vector<Diagnosis>& diagnoses) {
  const std::string text = DiagnosisLines(diagnoses);
  const int64_t num_failures = Count(diagnoses, Health::kFail);
  const int64_t num_warnings = Count(diagnoses, Health::kWarn);
  if (num_failures > 0) {
    return text + fmt::format(
                      "\nMissions over several processes cannot run here: {} FAIL, {} WARN. "
                      "`shoal sim` needs none of this.\n",
                      num_failures, num_warnings);
  }
  return text +
         fmt::format("\nMissions can run here: {} FAIL, {} WARN.\n", num_failures, num_warnings);
}

int DoctorExitCode(const std::vector<Diagnosis>& diagnoses) {
  return Count(diagnoses, Health::kFail) > 0 ? kExitEnvironment : kExitOk;
}

int RunDoctor() {
  const std::vector<Diagnosis> diagnoses = Diagnose(CollectDoctorFacts());
  fmt::print("{}", FormatDiagnoses(diagnoses));
  return DoctorExitCode(diagnoses);
}

}  // namespace shoal
