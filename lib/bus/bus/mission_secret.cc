#include "lib/bus/bus/mission_secret.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "lib/base/check/check.h"

namespace shoal {

MissionSecret RandomSecret() {
  MissionSecret secret;
  SHOAL_CHECK(sodium_init() >= 0, "the system gives random numbers");
  randombytes_buf(secret.bytes.data(), secret.bytes.size());
  return secret;
}

std::string SecretText(const MissionSecret& secret) {
  std::string text(2 * secret.bytes.size() + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), secret.bytes.data(), secret.bytes.size());
  text.back() = '\n';
  return text;
}

Result<MissionSecret> ParseSecret(std::string_view text) {
  MissionSecret secret;
  const size_t num_digits = 2 * secret.bytes.size();
  size_t size = 0;
  const bool is_hex = text.size() == num_digits + 1 && text.back() == '\n' &&
                      sodium_hex2bin(secret.bytes.data(), secret.bytes.size(), text.data(),
                                     num_digits, nullptr, &size, nullptr) == 0;
  if (!is_hex || size != secret.bytes.size()) {
    return Error{
        fmt::format("a mission's secret is {} hexadecimal digits and a line break", num_digits)};
  }
  return secret;
}

Result<MissionSecret> ReadSecret(int descriptor) {
  std::array<char, 128> text{};
  const ssize_t size = pread(descriptor, text.data(), text.size(), 0);
  if (size < 0) {
    return Error{fmt::format("cannot read descriptor {}: {}", descriptor, std::strerror(errno))};
  }
  return ParseSecret({text.data(), static_cast<size_t>(size)});
}

Result<MissionSecret> ReadSecretFile(const std::string& path) {
  const int opened = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (opened < 0) return Error{fmt::format("cannot read {}: {}", path, std::strerror(errno))};
  struct stat status {};
  const bool is_private = fstat(opened, &status) == 0 && S_ISREG(status.st_mode) &&
                          status.st_uid == geteuid() && (status.st_mode & 077) == 0;
  Result<MissionSecret> secret =
      is_private ? ReadSecret(opened)
                 : Error{"not a plain file of this user's with mode 0600; `shoal run` makes it"};
  close(opened);
  if (!secret.ok()) return Error{fmt::format("{}: {}", path, secret.error())};
  return secret;
}

}  // namespace shoal
