#include "apps/shoal_plot/plot_command.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/run/command_line/find_program.h"
#include "lib/tools/plot/plot_figures.h"
#include "lib/tools/plot/plot_gnuplot.h"
#include "lib/tools/plot/plot_testing.h"

namespace shoal::plot_command_test {

class Plot : public ::testing::Test {
 protected:
  void SetUp() override {
    options_.log = directory_.File("mission.lcm");
    // A gnuplot that draws the name of its script.
    const std::string drawn = std::filesystem::absolute(directory_.File("drawn")).string();
    const std::string program =
        "#!/bin/sh\necho \"$2\" >> '" + drawn + "'\necho \"$2\" > \"../${2%.gp}.svg\"\n";
    std::filesystem::create_directory(directory_.File("bin"));
    WriteBytes(directory_.File("bin/gnuplot"), Bytes(program.begin(), program.end()));
    std::filesystem::permissions(directory_.File("bin/gnuplot"), std::filesystem::perms::owner_all);
    options_.search_path = directory_.File("bin");
  }
  int Run() {
    out_.str("");
    err_.str("");
    return RunPlot(options_, out_, err_);
  }
  void WriteMission(const std::string& name, const std::string& text) {
    WriteBytes(directory_.File(name), Bytes(text.begin(), text.end()));
  }
  std::string Script(const std::string& figure) {
    return TextOfFile(directory_.File("plots/gnuplot/" + figure + ".gp"));
  }

  TestDirectory directory_;
  PlotOptions options_;
  std::ostringstream out_;
  std::ostringstream err_;
};

constexpr const char* kMission =
    "[mission]\nduration_s = 60\nseed = 5\n[[vehicle]]\nname = \"alpha\"\ncolor = \"red\"\n"
    "[[vehicle]]\nname = \"bravo\"\n";

TEST_F(Plot, StatesHowToInstallGnuplot) {
  WriteLog(options_.log, LogOfTwoVehicles());
  options_.search_path = directory_.File("nothing");
  EXPECT_EQ(Run(), kExitEnvironment);
  EXPECT_NE(err_.str().find("apt-get install --no-install-recommends gnuplot-nox"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(directory_.File("plots")));
}

TEST_F(Plot, NamesWhatItDrawsAndWhatItLeavesOut) {
  WriteLog(options_.log, LogOfTwoVehicles());
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_EQ(TextOfFile(directory_.File("drawn")),
            "tracks.gp\ntrack_error.gp\ndistances.gp\nactuators.gp\nspeed.gp\n");
  EXPECT_NE(out_.str().find("plots/tracks.svg\n"), std::string::npos);
  EXPECT_NE(out_.str().find("depth is left out: all vehicles stay at the surface\n"),
            std::string::npos);
  EXPECT_EQ(err_.str(), "");
  for (const auto& entry : std::filesystem::directory_iterator(directory_.File("plots"))) {
    EXPECT_EQ(entry.path().extension(), ".svg");  // No scripts are left behind.
  }
}

TEST_F(Plot, KeepsScriptsAndNeverWritesOverThem) {
  WriteLog(options_.log, LogOfTwoVehicles());
  options_.keep = true;
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_NE(Script("tracks"), "");
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("plots/gnuplot is there already"), std::string::npos);
}

TEST_F(Plot, ReplacesLinksAndLeavesWhatTheyLeadTo) {
  WriteLog(options_.log, LogOfTwoVehicles());
  WriteMission("victim", "precious");
  std::filesystem::create_directory(directory_.File("plots"));
  std::filesystem::create_symlink("../victim", directory_.File("plots/tracks.svg"));
  std::filesystem::create_hard_link(directory_.File("victim"), directory_.File("plots/speed.svg"));
  EXPECT_EQ(Run(), kExitOk) << err_.str();
  EXPECT_EQ(TextOfFile(directory_.File("victim")), "precious");
  EXPECT_FALSE(std::filesystem::is_symlink(directory_.File("plots/tracks.svg")));
  EXPECT_EQ(TextOfFile(directory_.File("plots/tracks.svg")), "tracks.gp\n");
  EXPECT_EQ(TextOfFile(directory_.File("plots/speed.svg")), "speed.gp\n");
}

TEST_F(Plot, FollowsALinkToAFolderOnlyWhereTheUserNamesIt) {
  WriteLog(options_.log, LogOfTwoVehicles());
  std::filesystem::create_directory(directory_.File("other"));
  std::filesystem::create_symlink("other", directory_.File("plots"));
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("plots is a symbolic link, which could lead anywhere; name the folder "
                            "of the figures: --out DIR\n"),
            std::string::npos)
      << err_.str();
  EXPECT_TRUE(std::filesystem::is_empty(directory_.File("other")));
  options_.out_dir = directory_.File("plots");
  EXPECT_EQ(Run(), kExitOk) << err_.str();
  EXPECT_EQ(TextOfFile(directory_.File("other/tracks.svg")), "tracks.gp\n");
}

TEST_F(Plot, KeepsNoScriptsThroughALink) {
  WriteLog(options_.log, LogOfTwoVehicles());
  std::filesystem::create_directory(directory_.File("plots"));
  std::filesystem::create_symlink("../other", directory_.File("plots/gnuplot"));
  options_.keep = true;
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("plots/gnuplot is there already"), std::string::npos) << err_.str();
  EXPECT_FALSE(std::filesystem::exists(directory_.File("other")));
}

TEST_F(Plot, StatesThatAFigureWasNotDrawn) {
  WriteLog(options_.log, LogOfTwoVehicles());
  WriteMission("bin/gnuplot", "#!/bin/sh\nexit 0\n");
  EXPECT_EQ(Run(), kExitEnvironment);
  EXPECT_NE(err_.str().find("plots/tracks.svg: No such file or directory"), std::string::npos)
      << err_.str();
}

TEST_F(Plot, TakesTheMissionBesideTheLogWithItsOverrides) {
  WriteLog(options_.log, LogOfTwoVehicles());
  WriteMission("mission.toml", kMission);
  WriteMission("run.txt", "mission_file /somewhere/berta.toml\nset mission.seed=9\n");
  options_.keep = true;
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_NE(Script("tracks").find("'Tracks: berta, seed 9'"), std::string::npos);
  EXPECT_NE(Script("tracks").find("#ff0000"), std::string::npos);
}

TEST_F(Plot, DrawsWithoutAMissionThatDoesNotLoad) {
  WriteLog(options_.log, LogOfTwoVehicles());
  WriteMission("mission.toml", "[mission]\n");
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_NE(err_.str().find("drawn without their mission"), std::string::npos);
}

TEST_F(Plot, RefusesAMissionThatWasNamedAndDoesNotLoad) {
  WriteLog(options_.log, LogOfTwoVehicles());
  options_.mission_file = directory_.File("none.toml");
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("none.toml"), std::string::npos);
}

TEST_F(Plot, NamesTheVehiclesThatThereAre) {
  WriteLog(options_.log, LogOfTwoVehicles());
  options_.vehicles = {"charlie"};
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("no vehicle 'charlie'; there are: ALPHA, BRAVO\n"), std::string::npos);
}

TEST_F(Plot, NamesTheTimesThatThereAreWhereThePartIsEmpty) {
  WriteLog(options_.log, LogOfTwoVehicles());
  options_.from_s = 5000;
  options_.to_s = 6000;
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("has nothing in the part --from 5000 --to 6000: it has messages of "
                            "vehicles from 0.0 s to "),
            std::string::npos)
      << err_.str();
  EXPECT_EQ(out_.str(), "") << "no figure, and no reason of another kind";
}

TEST_F(Plot, DrawsWhatCanBeReadOfADamagedLogAndReportsTheDamage) {
  WriteLog(options_.log, LogOfTwoVehicles());
  Bytes bytes = FileBytes(options_.log);
  bytes.resize(bytes.size() - 5);
  WriteBytes(options_.log, bytes);
  EXPECT_EQ(Run(), kExitEnvironment);
  EXPECT_NE(out_.str().find("tracks.svg"), std::string::npos);
  EXPECT_NE(err_.str(), "");
}

TEST_F(Plot, NeedsALogAndAFolder) {
  EXPECT_EQ(Run(), kExitEnvironment);
  WriteLog(options_.log, LogOfTwoVehicles());
  const std::vector<std::pair<std::string, std::string>> kClosed = {
      {"/dev/null/plots", "cannot make the folder /dev/null/plots: Not a directory"},
      {"/proc", "cannot write into /proc: No such file or directory"}};
  for (const auto& [folder, text] : kClosed) {
    options_.out_dir = folder;
    EXPECT_EQ(Run(), kExitEnvironment);
    EXPECT_NE(err_.str().find(text), std::string::npos) << err_.str();
  }
}

TEST_F(Plot, DrawsTheContourOfTheSeaFloor) {
  const char* path = std::getenv("PATH");
  const std::string gnuplot = FindExecutable("gnuplot", path == nullptr ? "" : path);
  if (gnuplot.empty()) GTEST_SKIP() << "no gnuplot here";
  const PlotSetting setting{.title = "m", .floor_depth_m = [](double x_m, double y_m) {
                              return 40 + 10 * std::sin(x_m / 30) * std::cos(y_m / 20);
                            }};
  PlotDataBuilder builder({}, setting);
  for (const TestEvent& event : LogOfTwoVehicles()) {
    builder.Add({.utime = event.utime, .channel = event.channel, .data = event.data});
  }
  const Figure tracks = DrawFigures(builder.Build(), setting, false).at(0);
  WriteMission("bin/tracks.dat", tracks.data);
  WriteMission("bin/tracks.gp", tracks.script);
  const auto drawn = RunGnuplot(gnuplot, directory_.File("bin"), "tracks.gp");
  ASSERT_TRUE(drawn.ok()) << drawn.error();
  const std::string svg = TextOfFile(directory_.File("tracks.svg"));
  EXPECT_NE(svg.find("sea floor, depth [m]"), std::string::npos);
  EXPECT_NE(svg.find("rgb(200, 184, 154)"), std::string::npos);  // The contour's lines.
}

TEST_F(Plot, MakesFiguresThatNameTheVehiclesAndRunNothing) {
  const char* path = std::getenv("PATH");
  options_.search_path = path == nullptr ? "" : path;
  if (FindExecutable("gnuplot", options_.search_path).empty()) GTEST_SKIP() << "no gnuplot here";
  std::vector<TestEvent> events = LogOfTwoVehicles();
  const std::string evil = "X'`touch PWNED`\\\"; system 'touch PWNED'; <b>&@x\n\xff";
  for (int i = 0; i < 10; ++i) {
    events.push_back(EventOf("NAV_" + evil, PlottedNav(i * 1'000'000, i, i, 10 + i)));
  }
  WriteLog(options_.log, events);
  options_.keep = true;
  ASSERT_EQ(Run(), kExitOk) << err_.str();
  for (const char* figure : {"tracks", "depth", "track_error", "distances", "actuators", "speed"}) {
    const std::string svg = TextOfFile(directory_.File(std::string("plots/") + figure + ".svg"));
    EXPECT_TRUE(svg.starts_with("<?xml")) << figure;
    EXPECT_TRUE(svg.find("</svg>") != std::string::npos) << figure;
    EXPECT_NE(svg.find("<text>alpha</text>"), std::string::npos) << figure;
    EXPECT_NE(svg.find("<text>BRAVO</text>"), std::string::npos) << figure;
    EXPECT_NE(svg.find("&lt;b>&amp;@x ?</text>"), std::string::npos) << figure;
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory_.File(""))) {
    EXPECT_NE(entry.path().filename(), "PWNED");
  }
}

}  // namespace shoal::plot_command_test
