#include "lib/tools/trials/shard_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <utility>

#include "lib/bus/os/file_bytes.h"
#include "lib/bus/os/plain_folder.h"

namespace shoal {

ShardFile::ShardFile(FileDescriptor file, std::string path)
    : file_(std::move(file)), path_(std::move(path)) {}

Result<ShardFile> ShardFile::Open(const std::string& path) {
  const std::filesystem::path shards = std::filesystem::path(path).parent_path();
  const auto folder = PlainFolder::Open(shards.parent_path().string());
  if (!folder.ok()) return Error{folder.error()};
  const auto below = folder->Below(shards.filename().string());
  if (!below.ok()) return Error{below.error()};
  Result<FileDescriptor> opened =
      below->OpenFile(std::filesystem::path(path).filename().string(), O_APPEND);
  if (!opened.ok()) return Error{opened.error()};
  FileDescriptor file = std::move(*opened);
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
