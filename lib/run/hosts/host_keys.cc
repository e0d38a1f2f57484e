#include "lib/run/hosts/host_keys.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zmq.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "lib/base/check/check.h"
#include "lib/bus/os/file_bytes.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/os/read_file.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

constexpr size_t kKeySize = 40;
constexpr size_t kLargestKeyFile_bytes = 4096;
constexpr mode_t kKeyOthers = 077;

bool IsKey(const std::string& text) {
  std::array<uint8_t, 32> bytes{};
  return text.size() == kKeySize && zmq_z85_decode(bytes.data(), text.c_str()) != nullptr;
}

Result<bool> WriteNew(const std::string& path, const std::string& text, mode_t mode) {
  const FileDescriptor file(
      open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
  if (!file.is_open() && errno == EEXIST) {
    return Error{fmt::format(
        "{} exists: computers that know its key would refuse another; --out names other files",
        path)};
  }
  if (!file.is_open() || !WriteAll(file.get(), text)) {
    return Error{fmt::format("cannot write {}: {}", path, ErrnoText(errno))};
  }
  return true;
}

/// Returns the value of `name` among lines "name value".
std::string ValueOf(const std::string& text, std::string_view name) {
  std::istringstream lines(text);
  std::string key;
  for (std::string value; lines >> key >> value;) {
    if (key == name) return value;
  }
  return {};
}

}  // namespace

HostKey MakeHostKey() {
  std::array<char, kKeySize + 1> public_key{};
  std::array<char, kKeySize + 1> secret_key{};
  SHOAL_CHECK(zmq_curve_keypair(public_key.data(), secret_key.data()) == 0,
              "libzmq was built with CURVE");
  return {.public_key = public_key.data(), .secret_key = secret_key.data()};
}

Result<bool> WriteHostKey(const HostKey& key, const std::string& prefix) {
  std::error_code error;
  if (const fs::path folder = fs::path(prefix).parent_path(); !folder.empty()) {
    fs::create_directories(folder, error);
  }
  const std::string secret = fmt::format("public {}\nsecret {}\n", key.public_key, key.secret_key);
  if (auto written = WriteNew(prefix + ".key", secret, 0600); !written.ok()) return written;
  return WriteNew(prefix + ".pub", key.public_key + "\n", 0644);
}

Result<HostKey> ReadHostKey(const std::string& path) {
  const FileDescriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (!file.is_open() || fstat(file.get(), &status) != 0) {
    return Error{fmt::format(
        "cannot read this computer's key, {}: {}. `shoal host keygen` makes one; --key names "
        "another file",
        path, ErrnoText(errno))};
  }
  if (!S_ISREG(status.st_mode) || status.st_uid != geteuid()) {
    return Error{
        fmt::format("{} is not a plain file of yours; `shoal host keygen` makes one", path)};
  }
  if ((status.st_mode & kKeyOthers) != 0) {
    return Error{fmt::format(
        "other users can read the secret key in {} (mode {:o}). If none has: chmod 600 {}; else "
        "make a new one with `shoal host keygen --out PREFIX`",
        path, status.st_mode & 07777, path)};
  }
  const FileText read = ReadOpenFile(file.get(), kLargestKeyFile_bytes);
  HostKey key{.public_key = ValueOf(read.text, "public"),
              .secret_key = ValueOf(read.text, "secret")};
  if (IsKey(key.public_key) && IsKey(key.secret_key)) return key;
  return Error{fmt::format("{} holds no pair of keys; `shoal host keygen` makes one", path)};
}

Result<std::string> FindPublicKey(const std::string& text, const std::string& folder) {
  if (IsKey(text)) return text;
  const fs::path path = fs::path(folder) / text;
  const FileText read = ReadRegularFile(path.string(), kLargestKeyFile_bytes);
  if (!read.problem.empty()) {
    return Error{
        fmt::format("'{}' is neither a public key of 40 characters nor a file with one: {} {}",
                    text, path.string(), read.problem)};
  }
  std::istringstream in(read.text);
  std::string key;
  in >> key;
  if (IsKey(key)) return key;
  return Error{fmt::format(
      "{} holds no public key of 40 characters; name the .pub file that `shoal host keygen` wrote",
      path.string())};
}

std::string DefaultKeyPrefix() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && *config != '\0') return std::string(config) + "/shoal/host";
  const char* home = std::getenv("HOME");
  return std::string(home == nullptr ? "." : home) + "/.config/shoal/host";
}

std::string HostKeyPath(const std::string& wanted) {
  if (!wanted.empty()) return wanted;
  const char* variable = std::getenv("SHOAL_KEY");
  if (variable != nullptr && *variable != '\0') return variable;
  return DefaultKeyPrefix() + ".key";
}

}  // namespace shoal
