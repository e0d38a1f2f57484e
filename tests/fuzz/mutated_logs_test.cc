// Recordings that were damaged, and `shoal log mcap`, `shoal log sqlite` of them: an exit code that
// is documented, no crash, no more memory than a bound. The same mutations in every run.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_testing.h"
#include "lib/tools/mcap/log_mcap.h"
#include "lib/tools/sqlite/log_sqlite.h"
#include "shoal/comms_fate_columns_t.hpp"
#include "shoal/comms_fates_t.hpp"
#include "shoal/comms_pulse_columns_t.hpp"
#include "shoal/nav_t.hpp"
#include "shoal/node_report_t.hpp"
#include "shoal/swarm_t.hpp"
#include "tests/fuzz/mutation.h"

namespace shoal::mutated_logs_test {

constexpr int kNumMutations = 5000;
constexpr size_t kMax_bytes = size_t{512} << 20;
/// Lengths without end, and what an event begins with.
constexpr std::string_view kEventBegins("\xED\xA1\xDA\x01", 4);
constexpr std::array<std::string_view, 5> kHarm = {
    std::string_view("\x7F\xFF\xFF\xFF", 4), std::string_view("\xFF\xFF\xFF\xFF", 4),
    std::string_view("\0\0\0\0", 4), kEventBegins, std::string_view("\x7F\xF8\0\0\0\0\0\0", 8)};

Bytes FatesOf(int count) {
  comms_fates_t fates{};
  for (int i = 0; i < count; ++i) {
    fate_t fate{};
    fate.kind = "report";
    fate.source = "alpha";
    fate.destination = "bravo";
    fate.cause = "out_of_range";
    fates.fates.push_back(fate);
  }
  fates.num_fates = count;
  return Encoded(fates);
}

/// The same as columns.
Bytes FateColumns(int16_t count) {
  comms_fate_columns_t columns{};
  columns.num_senders = columns.num_cases = columns.num_names = 1;
  columns.senders = {{"report", "alpha", 7, count}};
  columns.cases.resize(1);
  columns.cases[0].cause = "out_of_range";
  columns.cases[0].has_range = 1;
  columns.names = {"bravo"};
  columns.num_fates = columns.num_ranges = count;
  columns.destination.resize(static_cast<size_t>(count));
  columns.which_case.resize(static_cast<size_t>(count));
  columns.range_m.resize(static_cast<size_t>(count));
  return Encoded(columns);
}

Bytes PulseColumns() {
  comms_pulse_columns_t columns{};
  columns.num_ends = columns.num_pulses = 2;
  columns.num_styles = 1;
  columns.ends = {{"ALPHA", 1, 2}, {"BRAVO", 3, 4}};
  columns.styles.resize(1);
  columns.source = {0, 1};
  columns.destination = {1, 0};
  columns.style = {0, 0};
  columns.beam_width_m = {5, 6};
  return Encoded(columns);
}

Bytes SwarmOf(const std::string& vehicle) {
  swarm_t swarm{};
  swarm.vehicle = vehicle;
  swarm.num_contacts = 2;
  swarm.contacts.resize(2);
  return Encoded(swarm);
}

/// A log of a few hundred bytes to some kilobytes, with numbers, texts, and arrays of structs.
void WriteWhole(const std::string& path) {
  std::vector<TestEvent> events;
  for (int64_t utime = 0; utime < 300'000; utime += 100'000) {
    nav_t nav{};
    nav.utime = utime;
    nav.lat_deg = 43.8;
    nav.lon_deg = -70.3;
    node_report_t report{};
    report.utime = utime;
    report.name = "alpha";
    events.push_back({utime, "NAV_ALPHA", Encoded(nav)});
    events.push_back({utime, "NODE_REPORT_LOCAL", Encoded(report)});
    events.push_back({utime, "COMMS_FATES", utime == 0 ? FatesOf(2) : FateColumns(2)});
    events.push_back({utime, "SWARM_ALPHA", SwarmOf("alpha")});
    events.push_back({utime, "VIEW_COMMS_PULSE", PulseColumns()});
  }
  WriteLog(path, events);
}

struct LogCount {
  int whole = 0;
  int damaged = 0;
  std::string fault = "";  ///< The first answer that no user could use.
};

/// `convert` reads a file and returns an exit code; it has a line in `err` for one that is not 0.
LogCount Convert(const TestDirectory& directory,
                 const std::function<int(const std::string&, bool, std::ostream&)>& convert) {
  const std::string whole = TextOfFile(directory.File("whole.lcm"));
  std::mt19937_64 generator(19);
  LogCount count;
  for (int i = 0; i < kNumMutations; ++i) {
    const std::string bytes = Mutated(whole, kHarm, generator);
    const std::string path = directory.File("a.lcm");
    WriteBytes(path, Bytes(bytes.begin(), bytes.end()));
    std::ostringstream err;
    const int code = convert(path, i % 2 == 0, err);
    ++(code == 0 ? count.whole : count.damaged);
    const bool is_explained = code == 0 || err.str().find("a.lcm") != std::string::npos;
    if ((code != 0 && code != 2 && code != 3) || !is_explained) {
      count.fault = "exit code " + std::to_string(code) + ": " + err.str();
    }
  }
  return count;
}

void ExpectAnswers(const std::function<int(const std::string&, bool, std::ostream&)>& convert) {
  const TestDirectory directory;
  WriteWhole(directory.File("whole.lcm"));
  EXPECT_TRUE(LastsWithin(kMax_bytes, [&] {
    const LogCount count = Convert(directory, convert);
    if (count.fault.empty() && count.whole > 200 && count.damaged > 200) return true;
    std::fprintf(stderr, "%d read, %d not; %s\n", count.whole, count.damaged, count.fault.c_str());
    return false;
  })) << "a crash, more than 512 MB, or an answer that is shown above";
}

TEST(MutatedLogs, GiveAnMcapFileOrAnErrorWithTheirName) {
  ExpectAnswers([](const std::string& path, bool skip_damage, std::ostream& err) {
    std::ostringstream out;
    return LogMcap({.path = path, .out_path = path + ".mcap", .skip_damage = skip_damage}, out,
                   err);
  });
}

TEST(MutatedLogs, GiveADatabaseOrAnErrorWithTheirName) {
  ExpectAnswers([](const std::string& path, bool skip_damage, std::ostream& err) {
    std::ostringstream out;
    return LogSqlite({.path = path, .out_path = path + ".sqlite", .skip_damage = skip_damage}, out,
                     err);
  });
}

}  // namespace shoal::mutated_logs_test
