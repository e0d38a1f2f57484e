// NetCDF files of both kinds, read by shoal-netcdf.
#include "lib/mission/netcdf/netcdf_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "lib/bus/os/file_descriptor.h"
#include "lib/mission/netcdf/netcdf_wire.h"
#include "tests/netcdf/write_netcdf.h"

namespace shoal::netcdf_file_test {

WrittenNetcdf SmallFile() {
  return {.dimensions = {{"lat", 2}, {"lon", 3}},
          .variables = {{.name = "lat",
                         .type = WrittenType::kDouble,
                         .dimensions = {0},
                         .values = {54, 54.5},
                         .texts = {{"units", "degrees_north"}}},
                        {.name = "lon",
                         .type = WrittenType::kFloat,
                         .dimensions = {1},
                         .values = {10, 10.25, 10.5},
                         .texts = {{"units", "degrees_east"}}},
                        {.name = "z",
                         .type = WrittenType::kShort,
                         .dimensions = {0, 1},
                         .values = {-1, 2, -3, 4, -5, 6},
                         .numbers = {{"scale_factor", 0.5}, {"_FillValue", -99}}}}};
}

/// A folder of its own, and a file in it.
class NetcdfFiles : public testing::TestWithParam<NetcdfForm> {
 protected:
  NetcdfFiles()
      : path_(testing::TempDir() + "netcdf_file_test_" + std::to_string(getpid()) + ".nc") {}
  ~NetcdfFiles() override { std::filesystem::remove(path_); }

  Result<NetcdfFile> Open() {
    fd_ = FileDescriptor(open(path_.c_str(), O_RDONLY | O_CLOEXEC));
    return NetcdfFile::Open(fd_.get(), "small.nc");
  }
  std::string Bytes() const {
    std::ifstream in(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void Put(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
  }

  const std::string path_;
  FileDescriptor fd_;
};

TEST_P(NetcdfFiles, GiveTheirHeaderAndTheirValues) {
  WriteNetcdf(path_, GetParam(), SmallFile());
  const Result<NetcdfFile> file = Open();
  ASSERT_TRUE(file.ok()) << file.error();
  const NetcdfVariable* z = file->header().Find("z");
  ASSERT_NE(z, nullptr);
  EXPECT_EQ(z->type, NetcdfType::kShort);
  EXPECT_EQ(z->NumbersOf("scale_factor"), std::vector<double>{0.5});
  EXPECT_EQ(z->NumbersOf("_FillValue"), std::vector<double>{-99});
  EXPECT_EQ(file->header().Find("lat")->TextOf("units"), "degrees_north");
  const Result<std::vector<double>> values = file->Read(*z);
  ASSERT_TRUE(values.ok()) << values.error();
  EXPECT_EQ(*values, (std::vector<double>{-1, 2, -3, 4, -5, 6})) << "packed, as in the file";
  EXPECT_EQ(*file->Read(*file->header().Find("lon")), (std::vector<double>{10, 10.25, 10.5}));
}

TEST_P(NetcdfFiles, ThatAreCutOffAreRefused) {
  WriteNetcdf(path_, GetParam(), SmallFile());
  const std::string whole = Bytes();
  for (const size_t size : {size_t{0}, size_t{3}, size_t{20}, whole.size() / 2, whole.size() - 5}) {
    Put(whole.substr(0, size));
    const Result<NetcdfFile> file = Open();
    ASSERT_FALSE(file.ok()) << size;
    EXPECT_TRUE(file.error().starts_with("small.nc: ")) << file.error();
    EXPECT_TRUE(file.error().find("ncdump -h") != std::string::npos ||
                file.error().find("it was cut off, copy or download it again") != std::string::npos)
        << file.error();
  }
}

TEST_P(NetcdfFiles, AreNoTexts) {
  Put("ncols 2\nnrows 2\nxllcorner 0\n");
  const Result<NetcdfFile> text = Open();
  ASSERT_FALSE(text.ok());
  EXPECT_NE(text.error().find("is it a NetCDF file, and whole?"), std::string::npos)
      << text.error();
}

TEST_P(NetcdfFiles, WithLettersWhereNumbersAreWantedAreRefused) {
  WriteNetcdf(path_, GetParam(),
              {.dimensions = {{"n", 2}},
               .variables = {{.name = "text", .type = WrittenType::kChar, .dimensions = {0}}}});
  const Result<NetcdfFile> file = Open();
  ASSERT_TRUE(file.ok()) << file.error();
  const Result<std::vector<double>> values = file->Read(file->header().variables[0]);
  ASSERT_FALSE(values.ok());
  EXPECT_EQ(values.error(),
            "small.nc: variable 'text' holds no numbers; name another one after the "
            "file: file.nc:variable");
}

TEST_P(NetcdfFiles, ThatHaveChangedSinceAreRefused) {
  WriteNetcdf(path_, GetParam(), SmallFile());
  const Result<NetcdfFile> file = Open();
  ASSERT_TRUE(file.ok()) << file.error();
  NetcdfVariable other = *file->header().Find("z");
  other.dimensions = {0, 0};
  const Result<std::vector<double>> values = file->Read(other);
  ASSERT_FALSE(values.ok());
  EXPECT_EQ(values.error(),
            "small.nc: variable 'z': it has changed while it was read; start again");
}

TEST_P(NetcdfFiles, OfMoreValuesThanAGridMayHaveAreRefusedUnread) {
  WriteNetcdf(path_, GetParam(),
              {.dimensions = {{"lat", 5000}, {"lon", 5000}},
               .variables = {{.name = "z", .type = WrittenType::kShort, .dimensions = {0, 1}}}});
  if (GetParam() == NetcdfForm::kClassic) std::filesystem::resize_file(path_, 51'000'000);
  const Result<NetcdfFile> file = Open();
  ASSERT_TRUE(file.ok()) << file.error();
  const Result<std::vector<double>> values = file->Read(file->header().variables[0]);
  ASSERT_FALSE(values.ok());
  EXPECT_TRUE(values.error().starts_with(
      "small.nc: variable 'z' has 25000000 values, and a grid at most 16000000; cut out the part"))
      << values.error();
}

/// Returns the bytes of a file beside this test.
std::string BytesBeside(const std::string& name) {
  std::ifstream in(std::string(SHOAL_SOURCE_DIR) + "/tests/netcdf/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What only HDF5 can.
class Hdf5Files : public NetcdfFiles {};

// external.nc and virtual.nc: latitudes, longitudes, and an elevation of 2 x 2 bytes made by HDF5
// itself, with H5Pset_external("@@@...", 200 of them) and H5Pset_virtual("source.nc", "z").
TEST_P(Hdf5Files, WithValuesInAnotherFileAreRefusedWithoutOpeningIt) {
  const std::string other = path_ + ".other";
  std::string bytes = BytesBeside("external.nc");
  const size_t name_at = bytes.find(std::string(200, '@'));
  ASSERT_NE(name_at, std::string::npos);
  std::string name = other;
  name.resize(200);
  Put(bytes.replace(name_at, 200, name));
  const auto error = [&] {
    const Result<NetcdfFile> file = Open();
    if (!file.ok()) return file.error();
    const Result<std::vector<double>> values = file->Read(*file->header().Find("elevation"));
    return values.ok() ? "no error" : values.error();
  };
  const std::string refusal =
      "small.nc: variable 'elevation': its values are in another file, which it names (HDF5 "
      "external or virtual storage), and no other file is opened: copy them into one file, for "
      "example with nccopy";
  std::ofstream(other) << "SECRET";
  EXPECT_EQ(error(), refusal);
  std::filesystem::remove(other);
  ASSERT_EQ(mkfifo(other.c_str(), 0600), 0);
  EXPECT_EQ(error(), refusal) << "and does not wait for what comes through a pipe";
  std::filesystem::remove(other);
  Put(BytesBeside("virtual.nc"));
  EXPECT_EQ(error(), refusal);
}

/// Starts a reader that does this instead of its work.
NetcdfReaderStart Instead(const std::function<void(int answer_fd)>& work) {
  return [work](const std::vector<std::string>& /*question*/, int /*file_fd*/, int answer_fd,
                pid_t* pid) {
    *pid = fork();
    if (*pid != 0) return *pid < 0 ? errno : 0;
    work(answer_fd);
    _exit(0);
  };
}

void Answer(int fd, const std::string& bytes) {
  for (size_t at = 0; at < bytes.size();) {
    const ssize_t written = write(fd, bytes.data() + at, bytes.size() - at);
    if (written <= 0) return;
    at += static_cast<size_t>(written);
  }
}

std::string ErrorWith(const NetcdfReaderStart& start) {
  const Result<NetcdfFile> file = NetcdfFile::Open(STDIN_FILENO, "small.nc", start);
  return file.ok() ? "no error" : file.error();
}

TEST(NetcdfReader, ThatCrashesIsAnErrorThatNamesTheFile) {
  EXPECT_TRUE(
      ErrorWith(Instead([](int) {
        signal(SIGSEGV, SIG_DFL);  // A sanitizer would catch it.
        raise(SIGSEGV);
      }))
          .starts_with("small.nc: the NetCDF library crashed on it (Segmentation fault); the "
                       "file is damaged"));
  EXPECT_TRUE(ErrorWith(Instead([](int) {
                raise(SIGXCPU);
              })).starts_with("small.nc: reading it takes longer than shoal-netcdf may"));
  EXPECT_TRUE(ErrorWith(Instead([](int) {
                _exit(7);
              })).starts_with("small.nc: shoal-netcdf ended without a whole answer (exit code 7)"));
}

TEST(NetcdfReader, ThatWaitsForSomethingIsEnded) {
  const auto wait = Instead([](int) { pause(); });
  const Result<NetcdfFile> file = NetcdfFile::Open(STDIN_FILENO, "small.nc", wait, 0.02);
  ASSERT_FALSE(file.ok());
  EXPECT_TRUE(file.error().starts_with("small.nc: reading it takes longer than shoal-netcdf may"))
      << file.error();
}

TEST(NetcdfReader, IsNotBelieved) {
  const std::string greeting(kNetcdfGreeting);
  const std::string huge_count = std::string("\x7F\xFF\xFF\xFF", 4);
  for (const std::string& answer :
       {std::string(), std::string("hello"), greeting, greeting + "H", greeting + "H.\n",
        greeting + "V.\n", greeting + "H" + huge_count + ".\n",
        greeting + "E" + huge_count + ".\n"}) {
    const std::string error = ErrorWith(Instead([&](int fd) { Answer(fd, answer); }));
    EXPECT_TRUE(error.starts_with("small.nc: ")) << error;
    EXPECT_NE(error.find("the file is damaged"), std::string::npos) << error;
  }
  const std::string error = ErrorWith(Instead([](int fd) {
    const std::string megabyte(size_t{1} << 20, 'x');
    for (int i = 0; i < 1000; ++i) Answer(fd, megabyte);
  }));
  EXPECT_TRUE(error.starts_with("small.nc: shoal-netcdf answered with more than")) << error;
}

TEST(NetcdfReader, ThatIsNotThereIsAnErrorThatNamesThePackage) {
  const std::string error = ErrorWith([](const auto&, int, int, pid_t*) { return ENOENT; });
  EXPECT_NE(error.find("apt-get install libnetcdf-dev"), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(OfOneForm, Hdf5Files, testing::Values(NetcdfForm::kHdf5));
INSTANTIATE_TEST_SUITE_P(OfBothForms, NetcdfFiles,
                         testing::Values(NetcdfForm::kClassic, NetcdfForm::kHdf5),
                         [](const auto& each) {
                           return each.param == NetcdfForm::kClassic ? "Classic" : "Hdf5";
                         });

}  // namespace shoal::netcdf_file_test
