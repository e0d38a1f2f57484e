#include "lib/tools/trials/shard_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "lib/bus/os/file_bytes.h"

namespace shoal {

ShardFile::ShardFile(FileDescriptor file, std::string path)
    : file_(std::move(file)), path_(std::move(path)) {}

Result<ShardFile> ShardFile::Open(const std::string& path) {
  constexpr mode_t kMode = 0644;
  FileDescriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, kMode));
  if (!file.is_open()) {
    return Error{fmt::format("{}: cannot be written: {}", path, ErrnoText(errno))};
  }
  if (flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) {
      return Error{fmt::format("{}: cannot be locked: {}", path, ErrnoText(errno))};
    }
    return Error{
        fmt::format("{}: another process runs this shard; wait for it, or give another "
                    "--shard",
                    path)};
  }
  ShardFile shard(std::move(file), path);
  const off_t end = lseek(shard.file_.get(), 0, SEEK_END);
  char last = '\n';
  if (end > 0 && pread(shard.file_.get(), &last, 1, end - 1) != 1) {
    return Error{fmt::format("{}: cannot be read: {}", path, ErrnoText(errno))};
  }
  if (last != '\n') {
    if (const std::string problem = shard.Append(""); !problem.empty()) return Error{problem};
  }
  return shard;
}

std::string ShardFile::Append(std::string_view line) {
  const std::string text = std::string(line) + "\n";
  if (!WriteAll(file_.get(), text)) {
    return fmt::format(
        "{}: cannot be written: {}; what was finished before is kept, and the same "
        "command goes on from there",
        path_, ErrnoText(errno));
  }
  is_synced_ = false;
  return {};
}

std::string ShardFile::Sync() {
  if (is_synced_ || fdatasync(file_.get()) == 0) {
    is_synced_ = true;
    return {};
  }
  return fmt::format("{}: cannot be brought to the disk: {}", path_, ErrnoText(errno));
}

}  // namespace shoal
