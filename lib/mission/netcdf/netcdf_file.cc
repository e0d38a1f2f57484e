#include "lib/mission/netcdf/netcdf_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/timerfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "lib/bus/os/child.h"
#include "lib/bus/os/file_bytes.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/mission/netcdf/cf_words.h"
#include "lib/mission/netcdf/netcdf_wire.h"

namespace shoal {

namespace {

constexpr size_t kMaxHeader_bytes = size_t{16} << 20;
/// Of an answer beside its numbers, or of one that is a text.
constexpr size_t kAround_bytes = kMaxNetcdfText_bytes + 64;
constexpr char kDamaged[] =
    "the file is damaged, or was made by no NetCDF library: copy or write it again, and look at it "
    "with ncdump -h";
constexpr char kMissing[] =
    "shoal's program shoal-netcdf, which reads NetCDF, is not there: where shoal was built, run "
    "apt-get install libnetcdf-dev, then scripts/configure release, and build again; elsewhere put "
    "the folder of shoal's programs, lib/shoal/bin, on the PATH";

/// Appends what comes through a pipe until its other end is closed, `text` has more than
/// `most_bytes`, or the time is over. Returns whether it was closed.
bool ReadWithin(int pipe, double longest_s, size_t most_bytes, std::string* text) {
  const FileDescriptor timer(timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC));
  itimerspec end = {};
  end.it_value.tv_sec = static_cast<time_t>(longest_s);
  end.it_value.tv_nsec = static_cast<long>(1e9 * (longest_s - std::floor(longest_s)));
  if (timerfd_settime(timer.get(), 0, &end, nullptr) != 0) return false;
  std::array<pollfd, 2> waiting = {{{.fd = pipe, .events = POLLIN, .revents = 0},
                                    {.fd = timer.get(), .events = POLLIN, .revents = 0}}};
  std::array<char, 65536> buffer;
  while (text->size() <= most_bytes) {
    if (poll(waiting.data(), waiting.size(), -1) < 0 && errno == EINTR) continue;
    if (waiting[1].revents != 0) return false;
    const ssize_t count = read(pipe, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0;
    text->append(buffer.data(), static_cast<size_t>(count));
  }
  return false;
}

/// Returns the reason why a reader that ended with this status gave no answer.
std::string Failure(int status) {
  if (!WIFSIGNALED(status)) {
    return fmt::format("shoal-netcdf ended without a whole answer (exit code {}); {}",
                       WEXITSTATUS(status), kDamaged);
  }
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL) {
    return fmt::format("reading it takes longer than shoal-netcdf may; {}", kDamaged);
  }
  return fmt::format("the NetCDF library crashed on it ({}); {}", strsignal(signal), kDamaged);
}

}  // namespace

int StartNetcdfReader(const std::vector<std::string>& question, int file_fd, int answer_fd,
                      pid_t* pid) {
  ProgramStart start{
      .argv = {FindNetcdfReader()}, .output = answer_fd, .kept = file_fd, .kept_as = 3};
  start.argv.insert(start.argv.end(), question.begin(), question.end());
  const Result<StartedProgram> started = StartProgram(start);
  if (!started.ok()) return EAGAIN;
  if (started->exec_error != 0) WaitFor(started->pid);
  *pid = started->pid;
  return started->exec_error;
}

/// Returns the answer's bytes between greeting and end, for one of the kind `wanted`.
Result<std::string> NetcdfFile::Ask(const std::vector<std::string>& question, char wanted,
                                    size_t most_bytes) const {
  Pipe answer = MakePipe();
  if (!answer.read.is_open()) {
    return Error{fmt::format("cannot make a pipe: {}", ErrnoText(errno))};
  }
  pid_t pid = 0;
  const int failure = start_(question, fd_, answer.write.get(), &pid);
  if (failure == ENOENT) return Error{kMissing};
  if (failure != 0) return Error{fmt::format("cannot run shoal-netcdf: {}", ErrnoText(failure))};
  answer.write = {};
  std::string bytes;
  if (!ReadWithin(answer.read.get(), longest_answer_s_, most_bytes, &bytes)) kill(pid, SIGKILL);
  const int status = WaitFor(pid);
  if (bytes.size() > most_bytes) {
    return Error{
        fmt::format("shoal-netcdf answered with more than {} bytes; {}", most_bytes, kDamaged)};
  }
  NetcdfReply reply(bytes);
  reply.TakeWord(kNetcdfGreeting);
  const char kind = reply.Take<char>();
  if (reply.ok() && kind == 'E') {
    const std::string text = reply.TakeText();
    reply.TakeWord(kNetcdfEnd);
    if (reply.IsWhole()) return Error{text};
  }
  if (!reply.ok() || kind != wanted || !bytes.ends_with(kNetcdfEnd) || !WIFEXITED(status) ||
      WEXITSTATUS(status) != 0) {
    return Error{Failure(status)};
  }
  bytes.resize(bytes.size() - kNetcdfEnd.size());
  bytes.erase(0, kNetcdfGreeting.size() + 1);
  return bytes;
}

Result<NetcdfFile> NetcdfFile::Open(int fd, const std::string& name, NetcdfReaderStart start,
                                    double longest_answer_s) {
  NetcdfFile file(fd, name, std::move(start), longest_answer_s);
  const Result<std::string> answer = file.Ask({"header"}, 'H', kMaxHeader_bytes);
  if (!answer.ok()) return Error{name + ": " + answer.error()};
  NetcdfReply reply(*answer);
  std::optional<NetcdfHeader> header = TakeHeader(&reply);
  for (std::string each = reply.TakeText(); reply.ok() && !each.empty(); each = reply.TakeText()) {
    file.coordinates_[each] = reply.TakeNumbers();
  }
  if (!header || !reply.IsWhole()) {
    return Error{name + ": what it holds is not a header; " + kDamaged};
  }
  file.header_ = std::move(*header);
  return file;
}

Result<std::vector<double>> NetcdfFile::Read(const NetcdfVariable& variable) const {
  const uint64_t count = header_.NumValues(variable);
  const auto known = coordinates_.find(variable.name);
  if (known != coordinates_.end() && known->second.size() == count) return known->second;
  const std::string where = fmt::format("{}: variable '{}'", name_, PrintableName(variable.name));
  if (variable.type == NetcdfType::kOther) {
    return Error{where + " holds no numbers; name another one after the file: file.nc:variable"};
  }
  if (count > kMaxNetcdfValues) {
    return Error{
        fmt::format("{} has {} values, and a grid at most {}; cut out the part that the "
                    "mission needs, for example with ncks -d lat,54.0,54.5 -d lon,10.0,10.5",
                    where, count, kMaxNetcdfValues)};
  }
  const Result<std::string> answer =
      Ask({"values", variable.name, std::to_string(count)}, 'V',
          count * sizeof(double) + kNetcdfGreeting.size() + kAround_bytes);
  if (!answer.ok()) return Error{where + ": " + answer.error()};
  NetcdfReply reply(*answer);
  std::vector<double> values = reply.TakeNumbers();
  if (!reply.IsWhole() || values.size() != count) {
    return Error{
        fmt::format("{} has {} values, not {}; {}", where, values.size(), count, kDamaged)};
  }
  return values;
}

}  // namespace shoal
