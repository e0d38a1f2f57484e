#include "lib/run/launch/viewer_arguments.h"

#include <gtest/gtest.h>

namespace shoal::viewer_arguments_test {

using Words = std::vector<std::string>;

TEST(ViewerArguments, NameTheLogOrTheRunningMission) {
  EXPECT_EQ(ViewerArguments({}), Words{});
  EXPECT_EQ(ViewerArguments({.log = "runs/mine", .mission_file = "m.toml", .http_port = 9000}),
            (Words{"--log", "runs/mine", "--mission", "m.toml", "--http", "9000"}));
  EXPECT_EQ(ViewerArguments({.port_base = 7665, .listen = "10.0.0.1", .allow_commands = true}),
            (Words{"--port", "7665", "--listen", "10.0.0.1", "--allow-commands"}));
}

TEST(ViewerArguments, NameTheMissionToPlan) {
  EXPECT_EQ(ViewerArguments({.log = "m.toml", .outside_tiles = "https://a/{z}{x}{y}"}),
            (Words{"--plan", "m.toml", "--allow-tiles", "https://a/{z}{x}{y}"}));
}

TEST(ViewerArguments, NameThePageToWrite) {
  EXPECT_EQ(ViewerArguments({.log = "a.lcm", .export_path = "a.html", .export_step = "0.5"}),
            (Words{"--log", "a.lcm", "--export", "a.html", "--export-step", "0.5"}));
}

}  // namespace shoal::viewer_arguments_test
