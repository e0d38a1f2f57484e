// Files in Bellhop's formats, as users have them: fixed and free columns, units, comments; read as
// they are meant, or refused with their line.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "lib/base/random/stream.h"
#include "lib/sea/rays/bellhop_arrivals.h"
#include "lib/sea/rays/cast_text.h"
#include "lib/sea/rays/list_text.h"
#include "lib/sea/rays/rays_testing.h"

namespace shoal::bellhop_files_test {

using Files = std::map<std::string, std::string>;

Result<BellhopCase> Read(const std::string& env, const Files& files = {}) {
  return ReadBellhopCase("bay.env", env, [&](std::string_view ending) {
    const auto found = files.find(std::string(ending));
    return found == files.end() ? std::nullopt : std::optional(found->second);
  });
}

BellhopCase MustRead(const std::string& env, const Files& files = {}) {
  const Result<BellhopCase> read = Read(env, files);
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.error());
  return read.ok() ? *read : BellhopCase();
}

std::string ErrorOf(const std::string& env, const Files& files = {}) {
  const Result<BellhopCase> read = Read(env, files);
  return read.ok() ? "" : read.error();
}

/// A whole .env of these records.
struct Env {
  std::string top = "'CVW'";
  std::string profile = "2 0.0 60\n0 1500 /\n60 1490 /";
  std::string bottom = "'A' 0.0\n60 1650 0.0 1.9 0.8 /";
  std::string places = "1\n20 /\n2\n12 45 /\n3\n0.15 0.6 1.5 /";
  std::string run = "'A'\n2001\n-70 70 /\n20 70 1.55";

  std::string Text() const {
    return "'a bay'\n25000\n1\n" + top + "\n" + profile + "\n" + bottom + "\n" + places + "\n" +
           run + "\n";
  }
};

// 1
TEST(Env, IsReadInFreeColumns) {
  const BellhopCase bay = MustRead(Env().Text());
  EXPECT_EQ(bay.title, "a bay");
  EXPECT_EQ(bay.scene.hz, 25'000);
  EXPECT_EQ(bay.scene.water[0].profile, ProfileOf({{0, 1500}, {60, 1490}}));
  EXPECT_EQ(bay.scene.surface_reflector, Reflector(Vacuum()));
  EXPECT_EQ(bay.scene.bottom_reflector, Reflector(HalfSpace{1650, 1.9, 0.8}));
  EXPECT_EQ(bay.scene.bottom, (std::vector<BoundaryPoint>{{0, 60}}));
  EXPECT_EQ(bay.source_depths_m, std::vector<double>{20});
  EXPECT_EQ(bay.receiver_depths_m, (std::vector<double>{12, 45}));
  EXPECT_EQ(bay.receiver_ranges_m, (std::vector<double>{150, 600, 1500}));
  EXPECT_EQ(bay.run, 'A');
  EXPECT_NEAR(bay.last_launch_rad, 70 * kDegree, 1e-15);
  EXPECT_TRUE(bay.warnings.empty());
}

// 2
TEST(Env, IsReadInFixedColumnsWithCommentsTabsAndWindowsLines) {
  const BellhopCase bay = MustRead(
      "'fixed'                     ! TITLE\r\n"
      "   25000.0                  ! FREQ (Hz)\r\n"
      "       1                    ! NMEDIA\r\n"
      "'CVW'                       ! SSPOPT\r\n"
      "     51    0.0      60.0    ! DEPTH of bottom (m)\r\n"
      "      0.0   1500.0   /      \r\n"
      "\t60.0,  1.49D3 /   ! comment\r\n"
      "'A'   0.0\r\n"
      "     60.0   1650.00  0.0  1.9  0.8 /\r\n"
      "1  ! NSD\r\n20.0 /  ! SD\r\n2\r\n12.0, 45.0 /\r\n3\r\n0.15 0.6 1.5 /\r\n"
      "'A'\r\n2001\r\n-70.0 70.0 /\r\n20.0 70.0 1.55\r\n");
  EXPECT_EQ(bay.scene.water[0].profile, ProfileOf({{0, 1500}, {60, 1490}}));
  EXPECT_EQ(bay.receiver_ranges_m, (std::vector<double>{150, 600, 1500}));
}

// 3
TEST(Env, KeepsThePreviousLinesValuesWhereItemsAreMissing) {
  Env env;
  env.profile = "3 0.0 60\n0 1510 0.0 1.03 /\n30 /\n60 1490 /";
  env.bottom = "'A' 0.0\n60 /";
  const BellhopCase bay = MustRead(env.Text());
  EXPECT_EQ(bay.scene.water[0].profile, ProfileOf({{0, 1510}, {30, 1510}, {60, 1490}}));
  EXPECT_EQ(bay.scene.water_density, 1.03);
  EXPECT_EQ(bay.scene.bottom_reflector, Reflector(HalfSpace{1490, 1.03, 0}));
}

// 4
TEST(Env, SpacesReceiversEvenlyBetweenTwoValues) {
  Env env;
  env.places = "1\n20 /\n3\n10 50 /\n5\n0.1 0.5 /";
  const BellhopCase bay = MustRead(env.Text());
  EXPECT_EQ(bay.receiver_depths_m, (std::vector<double>{10, 30, 50}));
  ASSERT_EQ(bay.receiver_ranges_m.size(), 5U);
  EXPECT_NEAR(bay.receiver_ranges_m[1], 200, 1e-9);
}

// 5
TEST(Env, ConvertsAttenuationsOfEachUnit) {
  const auto attenuation = [](const std::string& unit, const std::string& value) {
    Env env;
    env.top = "'CV" + unit + "'";
    env.bottom = "'A' 0.0\n60 1500 0.0 1.9 " + value + " /";
    const BellhopCase bay = MustRead(env.Text());
    return std::get<HalfSpace>(bay.scene.bottom_reflector).attenuation_db_per_wavelength;
  };
  // A wavelength is 0.06 m at 25 kHz.
  EXPECT_EQ(attenuation("W", "0.5"), 0.5);
  EXPECT_NEAR(attenuation("M", "10"), 0.6, 1e-12);
  EXPECT_NEAR(attenuation("F", "0.4"), 0.6, 1e-12);
  EXPECT_NEAR(attenuation("N", "1"), 8.685889638 * 0.06, 1e-9);
  EXPECT_NEAR(attenuation("Q", "100"), 8.685889638 * std::numbers::pi / 100, 1e-9);
  EXPECT_NEAR(attenuation("L", "0.01"), 8.685889638 * 2 * std::numbers::pi * 0.01, 1e-9);
}

// 6
TEST(Env, TakesThorpAndRepeatedItems) {
  Env env;
  env.top = "\"CVWT\"";
  env.profile = "2 2*0.0 ! no depth yet\n";
  EXPECT_NE(ErrorOf(env.Text()), "");
  env.profile = "2 0.0 60\n0 1500 2*0.0 /\n60 1490 /";
  // The density 0 of the second repeated item is refused.
  EXPECT_EQ(ErrorOf(env.Text()), "bay.env:6: the density of the water must be more than 0");
  env.profile = "2 0.0 60\n0 1500 1*0.0 1.0 2*0.0\n60 1490 /";
  EXPECT_TRUE(MustRead(env.Text()).has_thorp_absorption);
}

// 7
TEST(Env, WarnsOfShearWhichHasNoEffect) {
  Env env;
  env.bottom = "'A' 0.0\n60 2800 1400 2.4 0.2 /";
  const BellhopCase bay = MustRead(env.Text());
  ASSERT_EQ(bay.warnings.size(), 1U);
  EXPECT_NE(bay.warnings[0].find("shear speed"), std::string::npos);
}

// 8
TEST(Env, RefusesWhatIsBeyondItsSubsetWithTheLine) {
  Env env;
  env.top = "'SVW'";
  EXPECT_EQ(ErrorOf(env.Text()).substr(0, 46), "bay.env:4: option string 'SVW': letter 1 is 'S");
  env.top = "'CGW'";
  EXPECT_NE(ErrorOf(env.Text()).find("bay.env:4: the kind of the surface is 'G'"),
            std::string::npos);
  env.top = "'CVX'";
  EXPECT_NE(ErrorOf(env.Text()).find("letter 3"), std::string::npos);
  env.top = "'CVWF'";
  EXPECT_NE(ErrorOf(env.Text()).find("letter 4"), std::string::npos);
  env.top = "'CVW  I'";
  EXPECT_NE(ErrorOf(env.Text()).find("letter 6"), std::string::npos);
  env = Env();
  env.bottom = "'G' 0.0\n60 3.2 /";
  EXPECT_NE(ErrorOf(env.Text()).find("bay.env:8: the kind of the bottom is 'G'"),
            std::string::npos);
  env = Env();
  env.run = "'A  X'\n2001\n-70 70 /\n20 70 1.55";
  EXPECT_NE(ErrorOf(env.Text()).find("line sources"), std::string::npos);
  EXPECT_EQ(ErrorOf("'two media'\n100\n2\n"),
            "bay.env:3: the number of media must be 1, as for Bellhop, not 2");
}

// 9
TEST(Env, RefusesDamageWithTheLine) {
  Env env;
  env.profile = "2 0.0 60\n0 1500 /\n60 fast /";
  EXPECT_NE(ErrorOf(env.Text()).find("bay.env:7: 'fast' is not a number"), std::string::npos);
  env.profile = "2 0.0 60\n0 1500 /\n30 1490 /\n20 1480 /";
  EXPECT_EQ(ErrorOf(env.Text()), "bay.env:8: depths must grow from point to point");
  env.profile = "2 0.0 60\n0 1500 /\n70 1490 /";
  EXPECT_NE(ErrorOf(env.Text()).find("bay.env:7: the profile must have a point at the depth"),
            std::string::npos);
  env.profile = "2 0.0 60\n0 150 /\n60 1490 /";
  EXPECT_NE(ErrorOf(env.Text()).find("bay.env:6: depth 0 m, speed 150 m/s"), std::string::npos);
  const std::string whole = Env().Text();
  EXPECT_NE(ErrorOf(whole.substr(0, 30)).find("the file ends"), std::string::npos);
  EXPECT_NE(ErrorOf("'open\n25000\n").find("bay.env:1: "), std::string::npos);
  env = Env();
  env.places = "1\n20 /\n4\n12 45 50 /\n3\n0.15 0.6 1.5 /";
  EXPECT_NE(ErrorOf(env.Text()).find("4 receiver depths are announced, and 3 given"),
            std::string::npos);
}

// 10, 11
TEST(Bty, IsReadWithCommentsAndInBothSpellings) {
  Env env;
  env.bottom = "'A~' 0.0\n60 1650 0.0 1.9 0.8 /";
  const std::vector<BoundaryPoint> expected = {{0, 50}, {1500, 60}};
  EXPECT_EQ(MustRead(env.Text(), {{".bty", "'L'\n2\n0 50\n1.5 60\n"}}).scene.bottom, expected);
  EXPECT_EQ(
      MustRead(env.Text(), {{".bty", "\"LS\" ! short form\n  2\n0.0, 50.0 /\n1.5\t60.0 / end\n"}})
          .scene.bottom,
      expected);
}

// 12, 13
TEST(Bty, IsRefusedWithTheLine) {
  Env env;
  env.bottom = "'A*' 0.0\n60 1650 0.0 1.9 0.8 /";
  const auto error = [&](const std::string& bty) { return ErrorOf(env.Text(), {{".bty", bty}}); };
  EXPECT_EQ(error("'L'\n2\n0 50\n0 60\n"), "bay.bty:4: ranges must grow from point to point");
  EXPECT_NE(error("'C'\n2\n0 50\n1 60\n").find("bay.bty:1: boundary type 'C'"), std::string::npos);
  EXPECT_NE(error("'LL'\n1\n0 50 1500 0 1 0 0\n").find("properties of their own"),
            std::string::npos);
  EXPECT_NE(error("'L'\n3\n0 50\n1 60\n").find("bay.bty:5: the file ends"), std::string::npos);
  EXPECT_NE(error("'L'\n2\n0 50\n1 90\n").find("the bottom is at 90 m, below the profile"),
            std::string::npos);
  EXPECT_NE(error("'L'\n2\n0 50\n1 -3\n").find("the bottom must be below the surface"),
            std::string::npos);
  EXPECT_NE(ErrorOf(env.Text()).find("bay.env:9: this line asks for bay.bty, which is missing"),
            std::string::npos)
      << ErrorOf(env.Text());
}

// 14
TEST(Ati, IsReadBelowTheProfilesFirstDepth) {
  Env env;
  env.top = "'CVW ~'";
  const BellhopCase bay = MustRead(env.Text(), {{".ati", "'L'\n3\n0 0.5\n0.1 1\n0.2 0.5\n"}});
  EXPECT_EQ(bay.scene.surface, (std::vector<BoundaryPoint>{{0, 0.5}, {100, 1}, {200, 0.5}}));
  EXPECT_NE(ErrorOf(env.Text(), {{".ati", "'L'\n2\n0 0\n0.1 -1\n"}})
                .find("the surface rises above the first depth"),
            std::string::npos);
}

// 15, 16
TEST(Ssp, IsReadByItemsWhateverItsLines) {
  Env env;
  env.top = "'QVW'";
  const BellhopCase bay =
      MustRead(env.Text(), {{".ssp", "2\n0 2.5\n1500 1505\n1490\n1495 ! over two lines\n"}});
  ASSERT_EQ(bay.scene.water.size(), 2U);
  EXPECT_EQ(bay.scene.water[1].range_m, 2500);
  EXPECT_EQ(bay.scene.water[1].profile, ProfileOf({{0, 1505}, {60, 1495}}));
  EXPECT_EQ(SpeedAt(bay.scene, 1250, 0), 1502.5);
  const auto error = [&](const std::string& ssp) { return ErrorOf(env.Text(), {{".ssp", ssp}}); };
  EXPECT_NE(error("2\n0 2.5\n1500 1505\n1490\n").find("the file ends"), std::string::npos);
  EXPECT_NE(error("2\n2.5 0\n1500 1505\n1490 1495\n").find("must grow"), std::string::npos);
  EXPECT_NE(error("2\n0 2.5\n1500 15\n1490 1495\n").find("bay.ssp:3: a speed of 15 m/s"),
            std::string::npos);
  EXPECT_NE(error("0\n").find("whole number from 1"), std::string::npos);
}

// 17
TEST(Trc, IsReadAndRefused) {
  Env env;
  env.top = "'CFW'";
  const BellhopCase bay = MustRead(env.Text(), {{".trc", "2\n0 1 180\n90 0.25 150\n"}});
  EXPECT_EQ(std::get<ReflectionTable>(bay.scene.surface_reflector).rows.size(), 2U);
  EXPECT_NE(ErrorOf(env.Text(), {{".trc", "2\n0 1 180\n0 0.25 150\n"}})
                .find("bay.trc:3: row 2 of the reflection table: angles must grow"),
            std::string::npos);
}

// 18, 19, 20
TEST(Arr, IsReadInBothFormsAndJoinsTheTwoRowsOfAPath) {
  const std::string rows =
      "  2\n"
      " 2\n 6.0e-4 540.0 0.70000000 -1.0e-9 1.5 2.5 1 2\n 4.0e-4 540.0 0.70000001 -1.0e-9 1.6 2.6 "
      "1 "
      "2\n 0\n";
  const std::string head = "'2D'\n 25000.0\n 1 30.0\n 1 60.0\n 2 1000.0 2000.0\n";
  const std::string older = "25000.0 1 1 2\n30.0\n60.0\n1000.0 2000.0\n";
  for (const std::string& text : {head + rows, older + rows}) {
    const Result<ArrivalTable> table = ReadBellhopArrivals("bay.arr", text);
    ASSERT_TRUE(table.ok()) << table.error();
    EXPECT_EQ(table->hz(), 25'000);
    EXPECT_TRUE(table->has_absorption());
    const auto arrivals = table->Nearest(25, 1400, 70);
    ASSERT_EQ(arrivals.size(), 1U);
    const double absorbed = std::exp(-2 * std::numbers::pi * 25'000 * 1e-9);
    EXPECT_NEAR(arrivals[0].amplitude, 1e-3 * absorbed, 1e-15);
    EXPECT_NEAR(arrivals[0].delay_s, 0.700000004, 1e-12);
    EXPECT_NEAR(arrivals[0].launch_rad, 1.54 * kDegree, 1e-6);
    EXPECT_NEAR(arrivals[0].phase_rad, std::numbers::pi, 1e-9);
    EXPECT_EQ(arrivals[0].num_surface, 1);
    EXPECT_EQ(arrivals[0].num_bottom, 2);
    EXPECT_TRUE(table->Nearest(25, 1600, 70).empty());
  }
}

TEST(Arr, IsRefusedWithTheLine) {
  const auto error = [](const std::string& text) {
    const Result<ArrivalTable> table = ReadBellhopArrivals("bay.arr", text);
    return table.ok() ? "" : table.error();
  };
  EXPECT_NE(error("'3D'\n25000\n").find("bay.arr:1: type '3D'"), std::string::npos);
  EXPECT_NE(error("'2D'\n25000\n1 30\n1 60\n1 1000\n1\n2\n").find("bay.arr:7: the number"),
            std::string::npos);
  EXPECT_NE(error("'2D'\n25000\n1 30\n1 60\n1 1000\n1\n1\n1e-3 0 x\n").find("bay.arr:8: 'x'"),
            std::string::npos);
  EXPECT_NE(error("'2D'\n25000\n1 30\n1 60\n1 1000\n1\n0\n5\n").find("the file goes on"),
            std::string::npos);
  EXPECT_NE(error("'2D'\n25000\n10000 1\n"), "");
}

TEST(Casts, AreReadByTheirColumns) {
  const Result<SoundProfile> speeds =
      ReadCast("c.csv", "# cruise 7\nspeed_mps,z_m\n1500,0\n1490,20\n");
  ASSERT_TRUE(speeds.ok()) << speeds.error();
  EXPECT_EQ(*speeds, ProfileOf({{0, 1500}, {20, 1490}}));
  const Result<SoundProfile> water =
      ReadCast("c.csv", "Station\tDepth [m]\tTEMP\tSal\r\nA\t0\t25\t35\r\nA\t1000\t25\t35\r\n");
  ASSERT_TRUE(water.ok()) << water.error();
  EXPECT_NEAR(water->SpeedAt(1000), 1550.744, 5e-4);
  const auto error = [](const std::string& text) {
    const Result<SoundProfile> profile = ReadCast("c.csv", text);
    return profile.ok() ? "" : profile.error();
  };
  EXPECT_NE(error("depth,temp\n0,10\n").find("c.csv:1: a cast needs the columns"),
            std::string::npos);
  EXPECT_NE(error("depth,speed\n0,1500\n0,1490\n").find("c.csv:3: depths must grow"),
            std::string::npos);
  EXPECT_NE(error("depth,speed\n0,\n").find("c.csv:2: the column 'speed' needs a number"),
            std::string::npos);
  EXPECT_NE(error("depth,speed\n").find("no rows"), std::string::npos);
  EXPECT_NE(error("").find("no line"), std::string::npos);
}

/// Changes a text at some places, as damaged files and wrong hands do.
std::string Mutant(const std::string& text, Stream* stream) {
  constexpr std::string_view kPieces[] = {
      "",    " ",  "/",    "'",  ",",    "-", "1e309", "nan",          "0", "\n", "*",
      "9*1", "\"", "\x01", "-1", "1d99", "!", "1e9",   "999999999999", "A~"};
  std::string mutant = text;
  const auto changes = 1 + stream->UniformInt(4);
  for (uint64_t i = 0; i < changes && !mutant.empty(); ++i) {
    const size_t at = stream->UniformInt(mutant.size());
    const size_t length = std::min<size_t>(stream->UniformInt(6), mutant.size() - at);
    mutant.replace(at, length, kPieces[stream->UniformInt(std::size(kPieces))]);
  }
  return mutant;
}

TEST(Mutants, AreReadOrRefusedAndNeverEndTheProgram) {
  Env env;
  env.top = "'QFWT~'";
  env.bottom = "'A~' 0.0\n60 1650 0.0 1.9 0.8 /";
  const Files files = {{".ssp", "2\n0 2.5\n1500 1505\n1490 1495\n"},
                       {".bty", "'L'\n2\n0 50\n1.5 60\n"},
                       {".ati", "'L'\n3\n0 0.5\n0.1 1\n0.2 0.5\n"},
                       {".trc", "2\n0 1 180\n90 0.25 150\n"}};
  ASSERT_EQ(ErrorOf(env.Text(), files), "");
  const std::string arr =
      "'2D'\n25000\n1 30\n1 60\n2 1000 2000\n1\n1\n1e-3 0 0.7 0 1.5 2.5 0 1\n0\n";
  int num_read = 0;
  int num_refused = 0;
  for (int i = 0; i < 5000; ++i) {
    Stream stream(11, "mutants", i);
    bool is_ok = false;
    std::string error;
    if (i % 5 == 4) {
      const Result<ArrivalTable> table = ReadBellhopArrivals("bay.arr", Mutant(arr, &stream));
      is_ok = table.ok();
      if (!is_ok) error = table.error();
    } else {
      Files mutants = files;
      std::string text = env.Text();
      auto changed = mutants.begin();
      std::advance(changed, stream.UniformInt(mutants.size()));
      std::string& target = stream.UniformInt(2) == 0 ? text : changed->second;
      target = Mutant(target, &stream);
      const Result<BellhopCase> bay = Read(text, mutants);
      is_ok = bay.ok();
      if (!is_ok) error = bay.error();
      // What is read can be traced.
      if (is_ok) {
        EXPECT_EQ(ProblemOf(bay->scene), "");
        if (i % 50 == 0) {
          static_cast<void>(FindEigenrays(bay->scene, {0, 20}, {300, 30}, Fan(10)));
        }
      }
    }
    ++(is_ok ? num_read : num_refused);
    if (!is_ok) {
      EXPECT_EQ(error.substr(0, 4), "bay.") << error;
    }
  }
  EXPECT_GT(num_read, 200);
  EXPECT_GT(num_refused, 500);
}

}  // namespace shoal::bellhop_files_test
