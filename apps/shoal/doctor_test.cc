#include "apps/shoal/doctor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "lib/base/check/result.h"

namespace shoal::doctor_test {

DoctorFacts HealthyMachine() {
  DoctorFacts facts;
  facts.multicast = {.sent = 100, .opened = true, .received = 100};
  facts.receive_buffer_limit_bytes = 4 * 1024 * 1024;
  facts.port_base = PortPlan::kDefaultBase;
  facts.folder = "/home/ada";
  facts.folder_free_bytes = int64_t{100} << 30;
  facts.max_open_files = 1024;
  facts.max_threads = 30000;
  facts.source_dir = "/home/ada/shoal";
  facts.java = "/usr/bin/java";
  facts.java_has_windows = facts.has_lcm_jar = facts.has_chart_jar = facts.has_display = true;
  facts.types_jar = "/home/ada/shoal/build/shoal_types.jar";
  return facts;
}

/// Returns the diagnoses that are not OK.
std::vector<Diagnosis> Findings(const DoctorFacts& facts) {
  std::vector<Diagnosis> diagnoses = Diagnose(facts);
  std::erase_if(diagnoses, [](const Diagnosis& each) { return each.health == Health::kOk; });
  return diagnoses;
}

/// Returns the only diagnosis that is not OK; a test fails where there is none or a second one.
Diagnosis OnlyFinding(const DoctorFacts& facts) {
  const std::vector<Diagnosis> complaints = Findings(facts);
  EXPECT_EQ(complaints.size(), 1U) << FormatDiagnoses(complaints);
  return complaints.empty() ? Diagnosis{} : complaints.front();
}

bool Advises(const Diagnosis& diagnosis, std::string_view command) {
  return std::find(diagnosis.remedies.begin(), diagnosis.remedies.end(), command) !=
         diagnosis.remedies.end();
}

TEST(Doctor, FindsNothingWrongWithAHealthyMachine) {
  const std::vector<Diagnosis> diagnoses = Diagnose(HealthyMachine());
  EXPECT_TRUE(Findings(HealthyMachine()).empty()) << FormatDiagnoses(diagnoses);
  EXPECT_EQ(DoctorExitCode(diagnoses), kExitOk);
  for (const Diagnosis& diagnosis : diagnoses)
    EXPECT_TRUE(diagnosis.remedies.empty()) << diagnosis.text;
}

TEST(Doctor, GivesTheTwoCommandsThatFixAMissingRoute) {
  DoctorFacts facts = HealthyMachine();
  facts.multicast = {.sent = 100, .opened = false, .received = 0};
  const Diagnosis diagnosis = OnlyFinding(facts);
  EXPECT_EQ(diagnosis.health, Health::kFail);
  EXPECT_TRUE(Advises(diagnosis, "sudo ip link set lo up multicast on"));
  EXPECT_TRUE(Advises(diagnosis, "sudo ip route add 224.0.0.0/4 dev lo"));
  EXPECT_EQ(DoctorExitCode(Diagnose(facts)), kExitEnvironment);
}

TEST(Doctor, SuspectsAFirewallWhenNothingComesBack) {
  DoctorFacts facts = HealthyMachine();
  facts.multicast.received = 0;
  const Diagnosis diagnosis = OnlyFinding(facts);
  EXPECT_EQ(diagnosis.health, Health::kFail);
  EXPECT_NE(diagnosis.text.find("firewall"), std::string::npos);
}

TEST(Doctor, FailsWhenOneMessageOfAHundredIsLost) {
  DoctorFacts facts = HealthyMachine();
  facts.multicast.received = 99;
  const Diagnosis diagnosis = OnlyFinding(facts);
  EXPECT_EQ(diagnosis.health, Health::kFail);
  EXPECT_NE(diagnosis.text.find("99 of 100"), std::string::npos) << diagnosis.text;
}

TEST(Doctor, WarnsOfDebiansReceiveBufferAndStatesHowManyMessagesItHolds) {
  DoctorFacts facts = HealthyMachine();
  facts.receive_buffer_limit_bytes = 212992;
  const Diagnosis diagnosis = OnlyFinding(facts);
  EXPECT_EQ(diagnosis.health, Health::kWarn);
  EXPECT_NE(diagnosis.text.find("about 332 messages"), std::string::npos) << diagnosis.text;
  EXPECT_TRUE(Advises(diagnosis, "sudo sysctl -w net.core.rmem_max=4194304"));
  EXPECT_EQ(diagnosis.text.find("host"), std::string::npos);
  facts.in_container = true;
  EXPECT_NE(OnlyFinding(facts).text.find("on the host"), std::string::npos);
}

TEST(Doctor, AcceptsTwoMebibytesAndNoByteLess) {
  DoctorFacts facts = HealthyMachine();
  facts.receive_buffer_limit_bytes = 2 * 1024 * 1024;
  EXPECT_TRUE(Findings(facts).empty());
  --facts.receive_buffer_limit_bytes;
  EXPECT_EQ(OnlyFinding(facts).health, Health::kWarn);
}

TEST(Doctor, AcceptsOtherFreePorts) {
  DoctorFacts facts = HealthyMachine();
  facts.port_base = 7805;
  EXPECT_TRUE(Findings(facts).empty());
  EXPECT_NE(FormatDiagnoses(Diagnose(facts)).find("gets those from 7805 on"), std::string::npos);
  facts.port_base.reset();
  EXPECT_EQ(OnlyFinding(facts).health, Health::kFail);
}

TEST(Doctor, ListsTheMissionsThatRun) {
  DoctorFacts facts = HealthyMachine();
  for (const auto& [name, port_base, pid] : {std::tuple{"berta", 7665, 12}, {"alpha", 7805, 34}}) {
    RunningMission& mission = facts.running.emplace_back();
    mission.name = name;
    mission.port_base = port_base;
    mission.pid = pid;
  }
  const std::string text = FormatDiagnoses(Diagnose(facts));
  EXPECT_NE(text.find("berta (--port 7665, pid 12), alpha (--port 7805, pid 34)"),
            std::string::npos)
      << text;
}

TEST(Doctor, FailsWhereMissionsCannotLeaveTheirAddress) {
  DoctorFacts facts = HealthyMachine();
  facts.run_folder_error = "the folder of running missions, /tmp/shoal-7, belongs to user 8";
  const Diagnosis diagnosis = OnlyFinding(facts);
  EXPECT_EQ(diagnosis.health, Health::kFail);
  EXPECT_NE(diagnosis.text.find("/tmp/shoal-7"), std::string::npos);
}

TEST(Doctor, WarnsBeforeTheDiskIsFullAndFailsWhenItIs) {
  DoctorFacts facts = HealthyMachine();
  facts.folder_free_bytes = int64_t{500} << 20;
  EXPECT_EQ(OnlyFinding(facts).health, Health::kWarn);
  facts.folder_free_bytes = int64_t{10} << 20;
  EXPECT_EQ(OnlyFinding(facts).health, Health::kFail);
  facts.folder_free_bytes.reset();
  EXPECT_EQ(OnlyFinding(facts).health, Health::kWarn);
}

TEST(Doctor, StatesHowToRaiseTheLimitsOfTheShell) {
  DoctorFacts facts = HealthyMachine();
  facts.max_open_files = 256;
  EXPECT_TRUE(Advises(OnlyFinding(facts), "ulimit -n 1024"));
  EXPECT_EQ(OnlyFinding(facts).health, Health::kWarn);
  facts.max_open_files = 32;
  EXPECT_EQ(OnlyFinding(facts).health, Health::kFail);
  facts.max_open_files.reset();
  EXPECT_TRUE(Findings(facts).empty());
  facts.max_threads = 200;
  EXPECT_TRUE(Advises(OnlyFinding(facts), "ulimit -u 1000"));
}

TEST(Doctor, NamesAllThatLcmSpyLacksAndWarnsNoMore) {
  DoctorFacts facts = HealthyMachine();
  facts.java.clear();
  facts.java_has_windows = facts.has_lcm_jar = facts.has_chart_jar = facts.has_display = false;
  facts.types_jar.clear();
  const Diagnosis diagnosis = OnlyFinding(facts);
  EXPECT_EQ(diagnosis.health, Health::kWarn);
  EXPECT_NE(diagnosis.text.find("missing Java, lcm.jar, jchart2d.jar, shoal_types.jar"),
            std::string::npos)
      << diagnosis.text;
  EXPECT_TRUE(Advises(diagnosis, "/home/ada/shoal/scripts/setup --with-spy"));
  EXPECT_EQ(diagnosis.remedies.size(), 2U);
  EXPECT_EQ(DoctorExitCode(Diagnose(facts)), kExitOk);
}

TEST(Doctor, DoesNotAskForPackagesWhereOnlyTheJarIsNotBuilt) {
  DoctorFacts facts = HealthyMachine();
  facts.types_jar.clear();
  const Diagnosis diagnosis = OnlyFinding(facts);
  ASSERT_EQ(diagnosis.remedies.size(), 1U);
  EXPECT_NE(diagnosis.remedies.front().find("--target shoal_types_jar"), std::string::npos);
}

TEST(Doctor, RecognisesAHeadlessJava) {
  DoctorFacts facts = HealthyMachine();
  facts.java_has_windows = false;
  EXPECT_NE(OnlyFinding(facts).text.find("a Java that can open windows"), std::string::npos);
}

TEST(Doctor, EndsWithAVerdictInWords) {
  EXPECT_NE(FormatDiagnoses(Diagnose(HealthyMachine())).find("\nMissions can run here: 0 FAIL, 0 "),
            std::string::npos);
  DoctorFacts facts = HealthyMachine();
  facts.multicast.opened = false;
  const std::string text = FormatDiagnoses(Diagnose(facts));
  EXPECT_NE(text.find("FAIL  multicast"), std::string::npos) << text;
  EXPECT_NE(text.find("\n        sudo ip route add"), std::string::npos) << text;
  EXPECT_NE(text.find("`shoal sim` needs none of this"), std::string::npos) << text;
}

}  // namespace shoal::doctor_test
