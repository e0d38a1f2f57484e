// NetCDF files that were damaged: each is read, or refused with its name; whatever happens to
// shoal-netcdf, shoal does not crash and takes no more memory than a bound. The same mutations in
// every run.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "apps/netcdf_reader/answer.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/mission/netcdf/cf_field.h"
#include "lib/mission/netcdf/cf_variables.h"
#include "lib/mission/netcdf/netcdf_file.h"
#include "tests/fuzz/mutation.h"
#include "tests/netcdf/write_netcdf.h"

namespace shoal::netcdf_mutations_test {

constexpr int kNumMutations = 2500;  // Of either form.
constexpr size_t kMax_bytes = size_t{512} << 20;
/// Lengths without end, NaN, and marks that files of both kinds have.
constexpr std::array<std::string_view, 8> kHarm = {std::string_view("\x7F\xFF\xFF\xFF", 4),
                                                   std::string_view("\xFF\xFF\xFF\xFF", 4),
                                                   std::string_view("\0\0\0\0", 4),
                                                   std::string_view("\0\0\0\x0B", 4),
                                                   std::string_view("\0\0\0\x0C", 4),
                                                   std::string_view("\x7F\xF8\0\0\0\0\0\0", 8),
                                                   "TREE",
                                                   "OHDR"};

WrittenNetcdf SmallTide() {
  return {.dimensions = {{"time", 2}, {"lat", 2}, {"lon", 2}},
          .variables = {{.name = "time",
                         .type = WrittenType::kDouble,
                         .dimensions = {0},
                         .values = {0, 1},
                         .texts = {{"units", "hours since 2026-11-24"}}},
                        {.name = "lat",
                         .type = WrittenType::kDouble,
                         .dimensions = {1},
                         .values = {54, 55},
                         .texts = {{"units", "degrees_north"}}},
                        {.name = "lon",
                         .type = WrittenType::kDouble,
                         .dimensions = {2},
                         .values = {10, 11},
                         .texts = {{"units", "degrees_east"}}},
                        {.name = "u",
                         .type = WrittenType::kShort,
                         .dimensions = {0, 1, 2},
                         .values = {1, 2, 3, 4, 5, 6, 7, 8},
                         .texts = {{"units", "m s-1"}},
                         .numbers = {{"scale_factor", 0.01}}},
                        {.name = "v",
                         .dimensions = {0, 1, 2},
                         .values = {1, 2, 3, 4, 5, 6, 7, 8},
                         .texts = {{"units", "m s-1"}}}}};
}

struct MutationCount {
  int read = 0;
  int refused = 0;
  int crashed = 0;         ///< Of `refused`: shoal-netcdf crashed.
  std::string fault = "";  ///< The first answer that no user could use.
};

/// Starts the reader as a fork of this process: its limits and its crashes are those of the
/// program.
int ForkReader(const std::vector<std::string>& question, int file_fd, int answer_fd, pid_t* pid) {
  *pid = fork();
  if (*pid != 0) return *pid < 0 ? errno : 0;
  const int answer = fcntl(answer_fd, F_DUPFD, 10);
  dup2(file_fd, 3);
  dup2(answer, STDOUT_FILENO);
  close_range(4, ~0U, 0);  // As in a program that was started, where they close by themselves.
  AnswerNetcdf(question);
}

/// Reads both components of the current; returns what is wrong, empty: nothing.
std::string ReadTide(const std::string& path) {
  const FileDescriptor fd(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  const Result<NetcdfFile> file = NetcdfFile::Open(fd.get(), "tide.nc", ForkReader);
  if (!file.ok()) return file.error();
  const auto names = FindCurrentVariables(file->header(), "tide.nc");
  if (!names.ok()) return names.error();
  for (const std::string& name : {names->first, names->second}) {
    const Result<CfField> field = ReadCfField(SourceOf(*file), name, CfQuantity::kMetresPerSecond);
    if (!field.ok()) return field.error();
    const size_t count =
        field->x.size() * field->y.size() * field->depths_m.size() * field->times_s.size();
    if (field->values.size() != count) return "a field of another size than its axes";
  }
  return "";
}

MutationCount ReadMutated(const std::string& path, NetcdfForm form) {
  WriteNetcdf(path, form, SmallTide());
  std::ifstream in(path, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  std::mt19937_64 generator(19);
  MutationCount count;
  for (int i = 0; i < kNumMutations; ++i) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << Mutated(whole, kHarm, generator);
    const std::string error = ReadTide(path);
    ++(error.empty() ? count.read : count.refused);
    if (error.find("crashed") != std::string::npos) ++count.crashed;
    const bool has_place = error.empty() || (error.starts_with("tide.nc: ") && error.size() < 600);
    const bool is_printable =
        std::ranges::all_of(error, [](char c) { return c >= ' ' && c <= '~'; });
    if (!has_place || !is_printable) count.fault = error;
  }
  return count;
}

void ExpectReadOrRefused(NetcdfForm form, const char* name) {
  const std::string path =
      testing::TempDir() + "netcdf_mutations_test_" + name + std::to_string(getpid()) + ".nc";
  EXPECT_TRUE(LastsWithin(kMax_bytes, [&] {
    const MutationCount count = ReadMutated(path, form);
    std::fprintf(stderr, "%s: %d read, %d refused, for %d of which shoal-netcdf crashed %s\n", name,
                 count.read, count.refused, count.crashed, count.fault.c_str());
    return count.fault.empty() && count.read > kNumMutations / 50 &&
           count.refused > kNumMutations / 10;
  })) << "a crash, more than 512 MB, or an answer that is shown above";
  std::filesystem::remove(path);
}

TEST(MutatedNetcdf, OfTheClassicFormIsReadOrRefusedWithItsName) {
  ExpectReadOrRefused(NetcdfForm::kClassic, "classic");
}

TEST(MutatedNetcdf, OfHdf5IsReadOrRefusedWithItsName) {
  ExpectReadOrRefused(NetcdfForm::kHdf5, "hdf5");
}

}  // namespace shoal::netcdf_mutations_test
