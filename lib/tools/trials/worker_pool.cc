#include "lib/tools/trials/worker_pool.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/os/child.h"
#include "lib/bus/os/file_bytes.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

constexpr int kMaxDeaths = 2;  ///< Then a trial's crash is its result.
/// A signal from outside (kill -9, no memory left): the trial itself may be sound.
constexpr int kMaxKills = 4;
constexpr char kEndOfLine = '\n';

bool IsFromOutside(int signal) {
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
}

}  // namespace

std::string TimeoutText(double timeout_s) {
  return fmt::format("did not end within {:g} s of wall time (timeout_s)", timeout_s);
}

WorkerPool::WorkerPool(Options options, RunTrial run)
    : options_(std::move(options)), run_(std::move(run)) {
  const auto num_workers = static_cast<size_t>(options_.num_workers);
  void* shared = mmap(nullptr, num_workers * sizeof(TrialProgress), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  SHOAL_CHECK(shared != MAP_FAILED, "a page of shared memory for the workers");
  progress_ = new (shared) TrialProgress[num_workers];
  workers_.resize(num_workers);
  for (size_t i = 0; i < num_workers; ++i) {
    workers_[i].progress = progress_ + i;
    Fork(&workers_[i]);
  }
}

WorkerPool::~WorkerPool() {
  for (Worker& worker : workers_) {
    if (worker.pid <= 0) continue;
    kill(worker.pid, SIGKILL);
    waitpid(worker.pid, nullptr, 0);
  }
  munmap(progress_, workers_.size() * sizeof(TrialProgress));
}

void WorkerPool::Fork(Worker* worker) {
  Pipe jobs = MakePipe();
  Pipe results = MakePipe();
  FileDescriptor output(memfd_create("shoal trial output", MFD_CLOEXEC));
  if (!jobs.write.is_open() || !results.read.is_open() || !output.is_open()) {
    problem_ = fmt::format("no pipe to a worker: {}", ErrnoText(errno));
    return;
  }
  const pid_t pid = ForkWithParent();
  if (pid < 0) {
    problem_ = fmt::format("no process for a worker: {}; give a smaller --jobs", ErrnoText(errno));
    return;
  }
  if (pid > 0) {
    worker->pid = pid;
    worker->jobs = std::move(jobs.write);
    worker->results = std::move(results.read);
    worker->output = std::move(output);
    worker->received.clear();
    return;
  }
  // Ctrl-C reaches the whole group: the parent alone decides, and lets trials finish.
  // A handler, and not SIG_IGN, which programs that a trial starts would inherit.
  struct sigaction nothing = {};
  nothing.sa_handler = [](int) {};
  nothing.sa_flags = SA_RESTART;
  for (const int each : {SIGINT, SIGTERM, SIGHUP}) sigaction(each, &nothing, nullptr);
  signal(SIGPIPE, SIG_DFL);  // Inherited as well.
  const rlimit no_core{.rlim_cur = 0, .rlim_max = 0};
  setrlimit(RLIMIT_CORE, &no_core);
  for (Worker& other : workers_) {
    other.jobs = {};
    other.results = {};
  }
  dup2(output.get(), STDOUT_FILENO);
  dup2(output.get(), STDERR_FILENO);
  worker->jobs = std::move(jobs.read);
  worker->results = std::move(results.write);
  jobs.write = {};
  results.read = {};
  if (options_.in_worker) options_.in_worker();
  Work(worker);
}

void WorkerPool::Work(Worker* worker) {
  TrialJob job;
  while (ReadAll(worker->jobs.get(), {reinterpret_cast<char*>(&job), sizeof job})) {
    // What earlier trials wrote is of no use, and would fill the memory.
    if (ftruncate(STDERR_FILENO, 0) == 0) lseek(STDERR_FILENO, 0, SEEK_SET);
    worker->progress->utime = 0;
    worker->progress->duration = 0;
    worker->progress->ends_itself = false;
    FinishedTrial finished;
    finished.result = run_(job, worker->progress);
    finished.key.repetition = job.repetition;
    const std::string line = TrialLine(finished, options_.metrics) + kEndOfLine;
    if (!WriteAll(worker->results.get(), line)) break;
  }
  std::fflush(nullptr);
  _exit(kExitOk);
}

bool WorkerPool::HasIdle() const {
  return std::any_of(workers_.begin(), workers_.end(),
                     [](const Worker& each) { return each.pid > 0 && !each.is_busy; });
}

size_t WorkerPool::num_busy() const {
  return static_cast<size_t>(std::count_if(workers_.begin(), workers_.end(),
                                           [](const Worker& each) { return each.is_busy; }));
}

void WorkerPool::Start(const TrialJob& job) {
  const auto worker = std::find_if(workers_.begin(), workers_.end(), [](const Worker& each) {
    return each.pid > 0 && !each.is_busy;
  });
  SHOAL_CHECK(worker != workers_.end(), "Start() is called where a worker is idle");
  worker->job = job;
  worker->num_deaths = 0;
  Send(&*worker);
}

void WorkerPool::Send(Worker* worker) {
  worker->is_busy = true;
  worker->begin_us = MonotonicMicroseconds();
  // If the worker has died, its pipe is broken, and Wait() notices that.
  static_cast<void>(WriteAll(worker->jobs.get(),
                             {reinterpret_cast<const char*>(&worker->job), sizeof worker->job}));
}

void WorkerPool::Conclude(Worker* worker, TrialResult result, std::vector<FinishedJob>* finished) {
  const double wall_s = Seconds(MonotonicMicroseconds() - worker->begin_us);
  worker->is_busy = false;
  finished->push_back({.job = worker->job, .result = std::move(result), .wall_s = wall_s});
}

/// Returns false where the worker has died.
bool WorkerPool::Receive(Worker* worker, std::vector<FinishedJob>* finished) {
  char bytes[4096];
  const ssize_t count = ::read(worker->results.get(), bytes, sizeof bytes);
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  if (count == 0) return false;
  worker->received.append(bytes, static_cast<size_t>(count));
  if (worker->received.back() != kEndOfLine) return true;
  worker->received.pop_back();
  auto trial = ParseTrialLine(worker->received, options_.metrics);
  worker->received.clear();
  TrialResult result{
      .outcome = TrialOutcome::kError, .why = "its result cannot be read", .metrics = {}};
  if (trial) result = std::move(trial->result);
  if (worker->is_busy) Conclude(worker, std::move(result), finished);
  return true;
}

std::string WorkerPool::LastOutput(const Worker& worker) const {
  constexpr off_t kMax = 1500;
  const off_t size = lseek(worker.output.get(), 0, SEEK_END);
  if (size <= 0) return {};
  std::string text(static_cast<size_t>(std::min(size, kMax)), '\0');
  const ssize_t count =
      pread(worker.output.get(), text.data(), text.size(), size - static_cast<off_t>(text.size()));
  text.resize(static_cast<size_t>(std::max<ssize_t>(count, 0)));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void WorkerPool::Remove(Worker* worker, std::vector<FinishedJob>* finished) {
  int status = 0;
  waitpid(worker->pid, &status, 0);
  worker->pid = -1;
  const std::string output = LastOutput(*worker);
  const bool was_busy = worker->is_busy;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  ++worker->num_deaths;
  const int most = IsFromOutside(signal) ? kMaxKills : kMaxDeaths;
  if (was_busy && worker->num_deaths >= most) {
    std::string why = signal != 0
                          ? fmt::format("signal {} ({})", signal, strsignal(signal))
                          : fmt::format("the process ended with exit code {}", WEXITSTATUS(status));
    why += fmt::format(", in each of {} attempts", worker->num_deaths);
    if (!output.empty()) why += ": " + output;
    Conclude(worker, {.outcome = TrialOutcome::kError, .why = why, .metrics = {}}, finished);
  }
  Fork(worker);
  // Shoal is deterministic: a crash repeats itself, a kill from outside does not.
  if (worker->pid > 0 && worker->is_busy) Send(worker);
}

void WorkerPool::StopRunaway(Worker* worker, int64_t now_us, std::vector<FinishedJob>* finished) {
  if (!worker->is_busy || worker->pid <= 0) return;
  const double running_s = Seconds(now_us - worker->begin_us);
  constexpr double kGrace_s = 15;
  const double limit_s = options_.timeout_s + (worker->progress->ends_itself ? kGrace_s : 0);
  if (running_s <= limit_s) return;
  kill(worker->pid, SIGKILL);
  waitpid(worker->pid, nullptr, 0);
  worker->pid = -1;
  const auto seconds = [](int64_t us) { return Seconds(us); };
  const int64_t duration = worker->progress->duration;
  const int64_t utime = worker->progress->utime;
  const std::string where = utime == 0 ? ""
                                       : fmt::format(", at {:.1f} of {:.1f} s of mission time",
                                                     seconds(utime), seconds(duration));
  Conclude(worker,
           {.outcome = TrialOutcome::kTimeout,
            .why = TimeoutText(options_.timeout_s) + where,
            .metrics = {}},
           finished);
  Fork(worker);
}

std::vector<FinishedJob> WorkerPool::Wait(int timeout_ms) {
  std::vector<FinishedJob> finished;
  std::vector<pollfd> polled;
  for (const Worker& worker : workers_) {
    polled.push_back(
        {.fd = worker.pid > 0 ? worker.results.get() : -1, .events = POLLIN, .revents = 0});
  }
  if (poll(polled.data(), polled.size(), timeout_ms) > 0) {
    for (size_t i = 0; i < polled.size(); ++i) {
      if (polled[i].revents == 0) continue;
      if (!Receive(&workers_[i], &finished)) Remove(&workers_[i], &finished);
    }
  }
  const int64_t now_us = MonotonicMicroseconds();
  for (Worker& worker : workers_) StopRunaway(&worker, now_us, &finished);
  for (Worker& worker : workers_) {
    if (worker.pid > 0) continue;
    // No process could be made a moment ago.
    Fork(&worker);
    if (worker.pid > 0 && worker.is_busy) Send(&worker);
  }
  return finished;
}

}  // namespace shoal
