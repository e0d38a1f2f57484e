#include "apps/shoal/check_command.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace shoal::check_command_test {

TEST(ChannelsMarkdown, IsWhatTheDocumentationHolds) {
  std::ifstream in(std::string(SHOAL_SOURCE_DIR) + "/docs/reference/channels.md");
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_EQ(text.str(), ChannelsMarkdown())
      << "run `build/bin/shoal channels > docs/reference/channels.md`";
}

}  // namespace shoal::check_command_test
