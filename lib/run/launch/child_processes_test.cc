#include "lib/run/launch/child_processes.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>

#include "lib/bus/record/log_testing.h"

namespace shoal::child_processes_test {

namespace fs = std::filesystem;

/// The command of a process that ends at once, with its output in `log_path`.
ChildCommand True(const std::string& log_path, bool is_log_private) {
  return {.name = "true",
          .argv = {"/bin/true"},
          .environment = {},
          .log_path = log_path,
          .is_log_private = is_log_private};
}

TEST(PrivateLog, IsNeverAFileThatWasThereBefore) {
  const TestDirectory directory;
  const std::string log = directory.File("shoal-viewer.txt");
  ChildProcesses children;
  EXPECT_TRUE(children.Start(True(log, true)).ok());
  EXPECT_EQ(fs::status(log).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  ChildProcesses others;
  const Result<pid_t> second = others.Start(True(log, true));
  ASSERT_FALSE(second.ok()) << "another user may have opened it";
  EXPECT_NE(second.error().find("cannot write " + log), std::string::npos) << second.error();
}

TEST(Log, OfAParticipantIsAppendedToAndNeverWrittenThroughALink) {
  const TestDirectory directory;
  const std::string log = directory.File("helm_alpha.txt");
  WriteBytes(log, {'x'});
  ChildProcesses children;
  EXPECT_TRUE(children.Start(True(log, false)).ok());
  EXPECT_EQ(TextOfFile(log), "x");
  fs::create_symlink(log, directory.File("link.txt"));
  EXPECT_FALSE(children.Start(True(directory.File("link.txt"), false)).ok());
}

/// Waits until the child has ended, and leaves it to be reaped.
void AwaitEnd(pid_t pid) {
  siginfo_t info{};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOWAIT), 0);
}

TEST(Child, IsNotStartedASecondTimeWhileItRuns) {
  const TestDirectory directory;
  ChildCommand command = True(directory.File("sleep.txt"), false);
  command.argv = {"/bin/sleep", "1000"};
  ChildProcesses children;
  ASSERT_TRUE(children.Start(command).ok());
  const Result<pid_t> second = children.Start(command);
  ASSERT_FALSE(second.ok()) << "the first would be forgotten, and outlive this process";
  EXPECT_EQ(second.error(), "cannot start true: it runs already");
  EXPECT_EQ(children.num_running(), 1U);
}

TEST(Exit, IsCleanByAnySignalThatWasSentAndNotTheLastAlone) {
  const TestDirectory directory;
  ChildCommand command = True(directory.File("sleep.txt"), false);
  command.argv = {"/bin/sleep", "1000"};
  ChildProcesses children;
  const Result<pid_t> pid = children.Start(command);
  ASSERT_TRUE(pid.ok()) << pid.error();
  children.Signal("true", SIGKILL);
  children.Signal("true", SIGTERM);  // As where a process that hangs is killed, and then all end.
  AwaitEnd(*pid);
  const std::vector<ChildExit> exits = children.Reap();
  ASSERT_EQ(exits.size(), 1U);
  EXPECT_EQ(exits[0].how, "was killed by signal 9 (Killed)");
  EXPECT_TRUE(exits[0].clean);
}

TEST(Exit, IsNotCleanByASignalThatWasNotSent) {
  const TestDirectory directory;
  ChildCommand command = True(directory.File("sleep.txt"), false);
  command.argv = {"/bin/sleep", "1000"};
  ChildProcesses children;
  const Result<pid_t> pid = children.Start(command);
  ASSERT_TRUE(pid.ok()) << pid.error();
  ASSERT_EQ(kill(*pid, SIGKILL), 0);
  AwaitEnd(*pid);
  const std::vector<ChildExit> exits = children.Reap();
  ASSERT_EQ(exits.size(), 1U);
  EXPECT_FALSE(exits[0].clean);
}

TEST(Child, HasNoDescriptorOfTheLauncherButTheOneThatItInherits) {
  const TestDirectory directory;
  // As liblcm opens its own: without close-on-exec. Far from those that `ls` opens itself.
  const int foreign = fcntl(STDIN_FILENO, F_DUPFD, 200);
  const int inherited = fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 300);
  ASSERT_GE(foreign, 200);
  ASSERT_GE(inherited, 300);
  ChildCommand command = True(directory.File("ls.txt"), false);
  command.argv = {"/bin/ls", "/proc/self/fd"};
  command.inherited_fd = inherited;
  ChildProcesses children;
  const Result<pid_t> pid = children.Start(command);
  ASSERT_TRUE(pid.ok()) << pid.error();
  AwaitEnd(*pid);
  std::istringstream listed(TextOfFile(directory.File("ls.txt")));
  const std::set<int> open_in_child{std::istream_iterator<int>(listed), {}};
  EXPECT_EQ(open_in_child.count(foreign), 0U);
  EXPECT_EQ(open_in_child.count(inherited), 1U);
  EXPECT_EQ(open_in_child.size(), 5U) << "0, 1, 2, the inherited one, and that of ls itself";
  close(foreign);
  close(inherited);
}

}  // namespace shoal::child_processes_test
