#include "lib/bus/os/read_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "lib/bus/os/file_bytes.h"
#include "lib/bus/os/files_below.h"

namespace shoal {

namespace {

thread_local FilesRead* list_of_thread = nullptr;

std::string Unreadable() { return std::string("cannot be read: ") + std::strerror(errno); }

Result<FileDescriptor> Open(const std::string& path, bool is_any_kind) {
  if (!MayReadFile(path)) return Error{"lies outside of the folder that the mission came in"};
  FileDescriptor file(
      open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | (is_any_kind ? 0 : O_NONBLOCK)));
  struct stat status {};
  if (!file.is_open() || fstat(file.get(), &status) != 0) return Error{Unreadable()};
  if (S_ISDIR(status.st_mode)) return Error{"is a directory; name the .toml file in it"};
  if (!is_any_kind && !S_ISREG(status.st_mode)) return Error{"is not a regular file"};
  return file;
}

FileText Read(const std::string& path, bool is_any_kind, size_t most_bytes) {
  const Result<FileDescriptor> file = Open(path, is_any_kind);
  return file.ok() ? ReadOpenFile(file->get(), most_bytes) : FileText{"", file.error()};
}

}  // namespace

FileText ReadFile(const std::string& path) { return Read(path, true, kLargestFile_bytes); }

FilesRead::FilesRead() : outer_(list_of_thread) { list_of_thread = this; }

FilesRead::~FilesRead() { list_of_thread = outer_; }

void NoteFileRead(const std::string& path) {
  if (list_of_thread != nullptr) list_of_thread->paths_.insert(path);
}

FileText ReadRegularFile(const std::string& path, size_t most_bytes) {
  FileText read = Read(path, false, most_bytes);
  if (read.problem.empty()) NoteFileRead(path);
  return read;
}

Result<FileDescriptor> OpenRegularFile(const std::string& path) {
  Result<FileDescriptor> file = Open(path, false);
  if (file.ok()) NoteFileRead(path);
  return file;
}

FileText ReadOpenFile(int fd, size_t most_bytes) {
  FileText file;
  if (!ReadToEnd(fd, most_bytes, &file.text)) return {"", Unreadable()};
  if (file.text.size() > most_bytes) {
    return {"", fmt::format("is larger than {} bytes", most_bytes)};
  }
  return file;
}

}  // namespace shoal
