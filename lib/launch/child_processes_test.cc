#include "lib/launch/child_processes.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "lib/record/test_log.h"

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
  const Result<pid_t> second = children.Start(True(log, true));
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

}  // namespace shoal::child_processes_test
