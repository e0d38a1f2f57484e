#include "lib/bus/os/child.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <vector>

#include "lib/bus/os/file_bytes.h"
#include "lib/bus/os/standard_descriptors.h"

namespace shoal::child_test {

/// Runs a line of the shell; returns what it prints.
std::string OutputOf(const std::string& line, ProgramStart start = {}) {
  Pipe pipe = MakePipe();
  start.argv = {"sh", "-c", line};
  start.output = pipe.write.get();
  const Result<StartedProgram> started = StartProgram(start);
  EXPECT_TRUE(started.ok());
  pipe.write = {};
  std::string text;
  EXPECT_TRUE(ReadToEnd(pipe.read.get(), 10'000, &text));
  EXPECT_EQ(WaitFor(started->pid), 0);
  return text;
}

TEST(StartProgram, GivesTheChildItsFolderEnvironmentAndOutput) {
  ::setenv("SHOAL_CHILD_TEST", "old", 1);
  EXPECT_EQ(OutputOf("pwd; echo $SHOAL_CHILD_TEST; env | grep -c ^SHOAL_CHILD_TEST=",
                     {.argv = {}, .environment = {"SHOAL_CHILD_TEST=new"}, .folder = "/"}),
            "/\nnew\n1\n");
}

TEST(StartProgram, GivesTheChildNoDescriptorButThoseNamed) {
  const FileDescriptor first(memfd_create("secret", 0));
  const FileDescriptor secret(fcntl(first.get(), F_DUPFD, 50));  // Without close-on-exec.
  const FileDescriptor kept(memfd_create("kept", MFD_CLOEXEC));
  ASSERT_TRUE(WriteAll(kept.get(), "kept"));
  ASSERT_EQ(lseek(kept.get(), 0, SEEK_SET), 0);
  const std::string is_open = "[ -e /proc/self/fd/" + std::to_string(secret.get()) + " ]";
  EXPECT_EQ(OutputOf("cat <&3; " + is_open + " || echo ' and no more'",
                     {.argv = {}, .kept = kept.get(), .kept_as = 3}),
            "kept and no more\n");
}

TEST(StartProgram, KeepsADescriptorUnderItsOwnNumber) {
  const FileDescriptor kept(memfd_create("kept", MFD_CLOEXEC));
  const std::string path = "/proc/self/fd/" + std::to_string(kept.get());
  EXPECT_EQ(OutputOf("[ -e " + path + " ] && echo there", {.argv = {}, .kept = kept.get()}),
            "there\n");
}

TEST(StartProgram, StatesWhyAProgramCannotBeExecuted) {
  const Result<StartedProgram> none = StartProgram({.argv = {"/no/such/program"}});
  ASSERT_TRUE(none.ok());
  EXPECT_EQ(none->exec_error, ENOENT);
  EXPECT_EQ(HowItEnded(WaitFor(none->pid)), "exited with code 127");
  const Result<StartedProgram> folder = StartProgram({.argv = {"/tmp"}});
  ASSERT_TRUE(folder.ok());
  EXPECT_EQ(folder->exec_error, EACCES);
  WaitFor(folder->pid);
}

TEST(StartProgram, StatesThatThereAreTooManyOpenFiles) {
  rlimit limit = {};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &limit), 0);
  const rlimit few = {.rlim_cur = 64, .rlim_max = limit.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
  std::vector<FileDescriptor> open_files;
  do {
    open_files.emplace_back(open("/dev/null", O_RDONLY | O_CLOEXEC));
  } while (open_files.back().is_open());
  const Result<StartedProgram> started = StartProgram({.argv = {"true"}});
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &limit), 0);
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(started.error(), ErrnoText(EMFILE));
}

TEST(StartProgram, DoesNotGiveAFileThatIsNoProgramToTheShell) {
  const FileDescriptor text(memfd_create("text", MFD_CLOEXEC));
  ASSERT_TRUE(WriteAll(text.get(), "exit 0\n"));
  ASSERT_EQ(fchmod(text.get(), 0755), 0);
  const std::string path =
      "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(text.get());
  const Result<StartedProgram> started = StartProgram({.argv = {path}});
  ASSERT_TRUE(started.ok());
  EXPECT_EQ(started->exec_error, ENOEXEC);
  WaitFor(started->pid);
}

TEST(Child, EndsAsItsStatusStates) {
  const Result<StartedProgram> started = StartProgram({.argv = {"sh", "-c", "kill -9 $$"}});
  ASSERT_TRUE(started.ok());
  EXPECT_EQ(HowItEnded(WaitFor(started->pid)), "was killed by signal 9 (Killed)");
}

TEST(ForkWithParent, MakesACopyWithAnEndOfItsOwn) {
  const pid_t pid = ForkWithParent();
  if (pid == 0) ::_exit(7);
  EXPECT_EQ(HowItEnded(WaitFor(pid)), "exited with code 7");
}

/// Runs `check` in a copy of this process whose standard descriptors are closed.
template <class Check>
int CodeWithoutStandardDescriptors(Check check) {
  const pid_t pid = fork();
  if (pid == 0) {
    for (int number = 0; number <= 2; ++number) close(number);
    TakeStandardDescriptors();
    _exit(check());
  }
  int status = 0;
  waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(StandardDescriptors, ThatWereClosedAreNoNumbersOfPipes) {
  EXPECT_EQ(CodeWithoutStandardDescriptors([] {
              const Pipe pipe = MakePipe();
              return pipe.read.get() > 2 && pipe.write.get() > 2 ? 0 : 1;
            }),
            0);
  EXPECT_EQ(CodeWithoutStandardDescriptors([] {
              char byte = 'x';
              return write(1, &byte, 1) < 0 && write(2, &byte, 1) < 0 && read(0, &byte, 1) < 0 ? 0
                                                                                               : 1;
            }),
            0)
      << "what cannot be written is not silently lost";
}

}  // namespace shoal::child_test
