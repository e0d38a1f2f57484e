#include "lib/run/run/run_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "lib/bus/os/file_bytes.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/os/read_file.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

constexpr mode_t kOthers = 077;
constexpr mode_t kWrittenByOthers = 022;

constexpr char kOwnFolder[] =
    "use a folder of your own, in every shell that you use: mkdir -p -m 700 ~/.shoal "
    "&& export SHOAL_RUN_DIR=~/.shoal";

const char* Variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

/// What is wrong with the open folder `fd` at `path`, or an empty text.
std::string Misfit(int fd, const std::string& path) {
  struct stat status {};
  if (fstat(fd, &status) != 0) {
    return fmt::format("cannot look at {}: {}", path, ErrnoText(errno));
  }
  if (status.st_uid != geteuid()) {
    return fmt::format(
        "the folder of running missions, {}, belongs to user {} and not to you (user {}), so that "
        "what it holds cannot be trusted; {}",
        path, status.st_uid, geteuid(), kOwnFolder);
  }
  const mode_t mode = status.st_mode & 07777;
  if ((mode & kWrittenByOthers) != 0) {
    return fmt::format(
        "other users can write the folder of running missions, {} (mode {:o}), so that what it "
        "holds cannot be trusted; {}",
        path, mode, kOwnFolder);
  }
  if ((mode & kOthers) == 0) return {};
  // A folder that bears our own name, from a version that made it with another mode, is ours to
  // change; one that the user has named may serve other purposes too.
  if (Variable("SHOAL_RUN_DIR") == nullptr && fchmod(fd, S_IRWXU) == 0) return {};
  return fmt::format(
      "other users can read the folder of running missions, {} (mode {:o}): chmod 700 {}, or {}",
      path, mode, path, kOwnFolder);
}

/// Opens the folder, or states why it is not to be used.
Result<FileDescriptor> OpenFolder() {
  const std::string path = RunFolder();
  if (mkdir(path.c_str(), S_IRWXU) != 0 && errno == ENOENT) {
    std::error_code error;
    fs::create_directories(fs::path(path).parent_path(), error);
    mkdir(path.c_str(), S_IRWXU);
  }
  FileDescriptor folder(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!folder.is_open()) {
    std::error_code error;
    if (fs::is_symlink(path, error)) {
      return Error{fmt::format(
          "the folder of running missions, {}, is a symbolic link, which could lead anywhere; {}",
          path, kOwnFolder)};
    }
    return Error{fmt::format("cannot use {} as the folder of running missions: {}; {}", path,
                             ErrnoText(errno), kOwnFolder)};
  }
  if (const std::string misfit = Misfit(folder.get(), path); !misfit.empty()) return Error{misfit};
  return folder;
}

std::string PathOf(std::string_view name) { return fmt::format("{}/{}", RunFolder(), name); }

}  // namespace

std::string RunFolder() {
  if (const char* own = Variable("SHOAL_RUN_DIR")) {
    std::string path = own;
    // Behind a slash, a symbolic link would be followed.
    while (path.size() > 1 && path.ends_with('/')) path.pop_back();
    return path;
  }
  if (const char* xdg = Variable("XDG_RUNTIME_DIR")) return fmt::format("{}/shoal", xdg);
  return fmt::format("/tmp/shoal-{}", geteuid());
}

Result<std::string> OpenRunFolder() {
  const Result<FileDescriptor> folder = OpenFolder();
  if (!folder.ok()) return Error{folder.error()};
  return RunFolder();
}

Result<std::string> WriteRunFile(std::string_view name, std::string_view text) {
  const Result<FileDescriptor> folder = OpenFolder();
  if (!folder.ok()) return Error{folder.error()};
  const std::string final_name(name);
  const std::string draft = final_name + ".new";
  unlinkat(folder->get(), draft.c_str(), 0);
  FileDescriptor file(openat(folder->get(), draft.c_str(),
                             O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                             S_IRUSR | S_IWUSR));
  const bool is_written =
      file.is_open() && WriteAll(file.get(), text) && file.Close() &&
      renameat(folder->get(), draft.c_str(), folder->get(), final_name.c_str()) == 0;
  if (is_written) return PathOf(name);
  Error error{fmt::format("cannot write {}: {}; {}", PathOf(name), ErrnoText(errno), kOwnFolder)};
  unlinkat(folder->get(), draft.c_str(), 0);
  return error;
}

Result<std::string> ReadRunFile(std::string_view name) {
  const Result<FileDescriptor> folder = OpenFolder();
  if (!folder.ok()) return Error{folder.error()};
  // Without O_NONBLOCK, to open a pipe would wait for a writer.
  const FileDescriptor file(openat(folder->get(), std::string(name).c_str(),
                                   O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (!file.is_open() || fstat(file.get(), &status) != 0) {
    return Error{fmt::format("cannot read {}: {}", PathOf(name), ErrnoText(errno))};
  }
  if (!S_ISREG(status.st_mode) || status.st_uid != geteuid() ||
      (status.st_mode & kWrittenByOthers) != 0) {
    return Error{fmt::format("{} is not a file that you alone can write; remove it", PathOf(name))};
  }
  FileText read = ReadOpenFile(file.get(), kLargestRunFile_bytes);
  if (read.problem.empty()) return std::move(read.text);
  return Error{fmt::format("{} {}; remove it", PathOf(name), read.problem)};
}

void RemoveRunFile(std::string_view name) {
  const Result<FileDescriptor> folder = OpenFolder();
  if (folder.ok()) unlinkat(folder->get(), std::string(name).c_str(), 0);
}

Result<std::string> MakeRunSubfolder(std::string_view name) {
  const Result<FileDescriptor> folder = OpenFolder();
  if (!folder.ok()) return Error{folder.error()};
  const std::string path = PathOf(name);
  std::error_code error;
  fs::remove_all(path, error);
  if (error) return Error{fmt::format("cannot remove {}: {}", path, error.message())};
  if (mkdirat(folder->get(), std::string(name).c_str(), S_IRWXU) != 0) {
    return Error{
        fmt::format("cannot make the folder {}: {}; {}", path, ErrnoText(errno), kOwnFolder)};
  }
  return path;
}

}  // namespace shoal
