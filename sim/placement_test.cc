#include "sim/placement.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lib/mission/file/load.h"

namespace shoal::placement_test {

Mission Fleet(int num_vessels) {
  const LoadedMission loaded = LoadMissionText(
      fmt::format("[mission]\nduration_s = 1\n[template.boat]\ngroup = \"boats\"\n[[fleet]]\n"
                  "template = \"boat\"\ncount = {}\nname = \"boat_{{n:03}}\"\nspacing_m = 100\n",
                  num_vessels),
      "fleet.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.mission;
}

std::vector<size_t> CountsOf(const Placement& placement) {
  std::vector<size_t> counts(placement.num_parts);
  for (const size_t part : placement.part_of_vehicle) ++counts.at(part);
  return counts;
}

Placement Place(const Mission& mission, size_t num_parts, std::vector<std::string> by_hand = {}) {
  Result<Placement> placement = MakePlacement(mission, num_parts, by_hand);
  EXPECT_TRUE(placement.ok()) << placement.error();
  return *placement;
}

TEST(Placement, GivesAllToTheOnlyPart) {
  const Mission mission = Fleet(7);
  EXPECT_EQ(Place(mission, 1), OnePart(mission));
  EXPECT_EQ(CountsOf(OnePart(mission)), std::vector<size_t>{7});
}

TEST(Placement, GivesFewerVehiclesToThePartThatHasTheDirector) {
  Mission mission = Fleet(300);
  mission.comms.comms_range_m = 50;  // None in range of another.
  const std::vector<size_t> counts = CountsOf(Place(mission, 4));
  EXPECT_LT(counts[0] + 10, counts[2]);
  EXPECT_NEAR(static_cast<double>(counts[1]), static_cast<double>(counts[2]), 1);
  EXPECT_NEAR(static_cast<double>(counts[2]), static_cast<double>(counts[3]), 1);
  EXPECT_EQ(counts[0] + counts[1] + counts[2] + counts[3], 300U);
}

TEST(Placement, CountsWhatTheBrokerDecidesAbout) {
  Mission mission = Fleet(300);
  mission.comms.comms_range_m = 50;
  mission.comms.reports_over.names = {
      std::string(kAcousticMedium)};  // So that the broker is whole.
  const Placement few = Place(mission, 2);
  mission.comms.comms_range_m = 150;
  EXPECT_LT(CountsOf(Place(mission, 2))[0] + 5, CountsOf(few)[0]);
}

TEST(Placement, GivesTheReportsOfABlockToThePartThatHasMostOfItsVehicles) {
  const Mission mission = Fleet(300);  // Blocks of 64 from boat_001 on; the last one has 44.
  const Placement two = Place(mission, 2);
  EXPECT_EQ(two.broker_part, 0U);
  ASSERT_EQ(two.part_of_block.size(), 5U);
  for (size_t block = 0; block < 5; ++block) {
    std::vector<size_t> counts(2);
    for (size_t i = block * 64; i < std::min<size_t>(300, (block + 1) * 64); ++i) {
      ++counts[two.part_of_vehicle[i]];
    }
    EXPECT_GE(counts[two.part_of_block[block]], counts[1 - two.part_of_block[block]]) << block;
  }
  EXPECT_NE(two.part_of_block.front(), two.part_of_block.back());
  EXPECT_EQ(Place(mission, 3, {"2=all"}).part_of_block, std::vector<size_t>(5, 2));
}

TEST(Placement, LeavesTheBrokerWholeInASmallFleetAndWhereTheUserPlacesIt) {
  EXPECT_TRUE(Place(Fleet(64), 4).part_of_block.empty());
  EXPECT_FALSE(Place(Fleet(65), 4).part_of_block.empty());
  EXPECT_TRUE(Place(Fleet(300), 1).part_of_block.empty());
  EXPECT_TRUE(Place(Fleet(300), 4, {"0=shore_broker"}).part_of_block.empty());
}

TEST(Placement, PutsAWholeBrokerBesideTheDirectorWhileTheirPartIsNotTheBusiest) {
  Mission mission = Fleet(300);
  mission.comms.reports_over.names = {std::string(kAcousticMedium)};
  mission.comms.comms_range_m = 50;  // Little to decide: 78 us of it, beside 270 us of vehicles.
  EXPECT_EQ(Place(mission, 2).broker_part, 0U);
  EXPECT_EQ(Place(mission, 3).broker_part, 0U);
  EXPECT_EQ(Place(mission, 5).broker_part, 1U);
  mission.comms.comms_range_m =
      -1;  // No limit: 89,700 links, beside which the director is nothing.
  EXPECT_EQ(Place(mission, 2).broker_part, 0U);
}

TEST(Placement, LeavesNeighboursTogether) {
  const Placement placement = Place(Fleet(50), 4);
  EXPECT_TRUE(std::is_sorted(placement.part_of_vehicle.begin(), placement.part_of_vehicle.end()));
}

TEST(Placement, GivesMorePartsThanVehiclesAtMostOneEach) {
  const std::vector<size_t> counts = CountsOf(Place(Fleet(3), 8));
  for (const size_t count : counts) EXPECT_LE(count, 1U);
}

TEST(Placement, CountsModelsThatIntegrateMoreOften) {
  const LoadedMission loaded = LoadMissionText(
      "[mission]\nduration_s = 1\n[[vehicle]]\nname = \"auv\"\nmodel = \"remus100\"\n"
      "[[fleet]]\ntemplate = \"boat\"\ncount = 4\nname = \"boat_{n}\"\nspacing_m = 100\n"
      "[template.boat]\n",
      "mixed.toml");
  ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  const Placement placement = Place(loaded.mission, 2);
  for (size_t i = 1; i < loaded.mission.vehicles.size(); ++i) {
    EXPECT_NE(placement.part_of_vehicle[i], placement.part_of_vehicle[0]) << i;
  }
}

TEST(Placement, FollowsTheUserAndSharesTheRestOutAroundIt) {
  const Mission mission = Fleet(6);
  const Placement placement = Place(mission, 2, {"1=boat_001,BOAT_002", "0=boat_006"});
  EXPECT_EQ(placement.part_of_vehicle[0], 1U);
  EXPECT_EQ(placement.part_of_vehicle[1], 1U);
  EXPECT_EQ(placement.part_of_vehicle[5], 0U);
  EXPECT_EQ(CountsOf(Place(mission, 3, {"2=group:boats"})), (std::vector<size_t>{0, 0, 6}));
  EXPECT_EQ(CountsOf(Place(mission, 3, {"1=all"})), (std::vector<size_t>{0, 6, 0}));
}

TEST(Placement, PutsTheBrokerWhereTheUserWantsIt) {
  const Mission mission = Fleet(6);
  EXPECT_EQ(Place(mission, 3, {"2=shore_broker,boat_001"}).broker_part, 2U);
  EXPECT_EQ(Place(mission, 3, {"0=shore_broker"}).broker_part, 0U);
}

TEST(Placement, NamesWhatIsWrongInTheWordsOfTheUser) {
  const Mission mission = Fleet(3);
  const auto error = [&](std::vector<std::string> words) {
    return MakePlacement(mission, 2, words).error();
  };
  constexpr char kRemedy[] = "; write PART=VEHICLE[,VEHICLE...], with a part from 0 to 1";
  EXPECT_EQ(error({"boat_001"}), std::string("--place 'boat_001': no '='") + kRemedy);
  EXPECT_EQ(error({"x=boat_001"}),
            std::string("--place 'x=boat_001': the part is not a number") + kRemedy);
  EXPECT_EQ(error({"2=boat_001"}),
            std::string("--place '2=boat_001': there is no part 2") + kRemedy);
  EXPECT_EQ(error({"1=boat_001,dinghy"}),
            std::string("--place '1=boat_001,dinghy': there is no vehicle 'dinghy'") + kRemedy);
  EXPECT_EQ(error({"0=boat_001", "1=boat_001"}),
            std::string("--place '1=boat_001': boat_001 is placed on 0 already") + kRemedy);
}

}  // namespace shoal::placement_test
