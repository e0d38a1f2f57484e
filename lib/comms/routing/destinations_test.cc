// The destinations of a message: lists, groups, all.
#include "lib/comms/routing/destinations.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/comms/routing/fleet_testing.h"

namespace shoal::destinations_test {

using Names = std::vector<std::string>;

TEST(ParseDestinations, SplitsAtColonsAndKeepsTheOrder) {
  EXPECT_EQ(ParseDestinations("bravo:charlie:Gilda").names, (Names{"bravo", "charlie", "Gilda"}));
  EXPECT_FALSE(ParseDestinations("bravo").all);
}

TEST(ParseDestinations, DropsBlanksAroundNamesAndEmptyParts) {
  EXPECT_EQ(ParseDestinations(" bravo :\t: charlie\r\n::").names, (Names{"bravo", "charlie"}));
  EXPECT_TRUE(ParseDestinations("").names.empty());
  EXPECT_TRUE(ParseDestinations(":::").names.empty());
}

TEST(ParseDestinations, TakesEachNameOnceWithoutRegardToCase) {
  EXPECT_EQ(ParseDestinations("bravo:BRAVO: Bravo:alpha").names, (Names{"bravo", "alpha"}));
}

TEST(ParseDestinations, KnowsAllInAnyCaseAndAmongNames) {
  for (const char* text : {"all", "ALL", "All", " all ", "abe:all", "all:abe"}) {
    EXPECT_TRUE(ParseDestinations(text).all) << text;
  }
  EXPECT_FALSE(ParseDestinations("allan").all);
  EXPECT_EQ(ParseDestinations("abe:all").names, Names{"abe"});
}

std::string ListOf(size_t count) {
  std::string list;
  for (size_t i = 0; i < count; ++i) list += "v" + std::to_string(i) + ":";
  return list;
}

TEST(ParseDestinations, TakesAThousandNamesSomeRepeatedAndNoMore) {
  const Destinations full = ParseDestinations(ListOf(Destinations::kMaxNames) + "v0:V1:all");
  EXPECT_FALSE(full.too_many);
  EXPECT_TRUE(full.all);
  EXPECT_EQ(full.names.size(), Destinations::kMaxNames);
  const Destinations over = ParseDestinations(ListOf(Destinations::kMaxNames + 1));
  EXPECT_TRUE(over.too_many);
  EXPECT_EQ(over.names.size(), Destinations::kMaxNames);
}

TEST(ParseDestinations, StandsAMegabyteInOneName) {
  EXPECT_EQ(ParseDestinations(std::string(1 << 20, 'x')).names.size(), 1U);
}

/// Five vehicles together, two of them of the red team; messages without interval.
struct Team : TestFleet {
  Team() : TestFleet(RulesWithoutInterval(), 1, {"alpha", "bravo", "charlie", "gilda", "henry"}) {
    Report("alpha", {0, 0, 0});
    Report("bravo", {10, 0, 0}, "red_team");
    Report("charlie", {20, 0, 0});
    Report("henry", {40, 0, 0}, "Red_Team");
  }
  static RoutingRules RulesWithoutInterval() {
    RoutingRules rules;
    rules.min_msg_interval_s = -1;
    return rules;
  }
};

Names KeysOf(const Fates& fates) {
  Names names;
  for (const auto& [name, decision] : fates) names.push_back(name);
  return names;
}

// The manual, section 4.4: bravo is in the list and in the group, and receives it once.
TEST(Destinations, AreTheUnionOfListAndGroupEachVehicleOnce) {
  Team team;
  team.Report("gilda", {30, 0, 0});
  const Fates fates = team.Message({.source = "alpha",
                                    .dest_node = "bravo:charlie:gilda",
                                    .dest_group = "red_team",
                                    .length_bytes = 5});
  EXPECT_EQ(KeysOf(fates), (Names{"bravo", "charlie", "gilda", "henry"}));
  for (const auto& [name, decision] : fates) {
    EXPECT_EQ(decision.cause, Cause::kDelivered) << name;
    EXPECT_EQ(decision.length_bytes, 5);
    EXPECT_EQ(decision.number, 0) << "one message, however many destinations";
  }
}

TEST(Destinations, GiveAnUnknownVehicleAFateWithItsContactAndAnUnregisteredOneAFateWithItsName) {
  Team team;
  const Fates fates = team.Message("alpha", "gilda:Nemo:a b:bravo");
  EXPECT_EQ(KeysOf(fates), (Names{"Nemo", "a b", "bravo", "gilda"}));
  EXPECT_EQ(fates.at("gilda").cause, Cause::kUnknownDestination);
  EXPECT_EQ(fates.at("gilda").destination, team.At("gilda").index);
  EXPECT_EQ(fates.at("Nemo").cause, Cause::kUnknownDestination);
  EXPECT_EQ(fates.at("Nemo").destination, kNoContact);
  EXPECT_EQ(fates.at("a b").cause, Cause::kUnknownDestination);
  EXPECT_EQ(CountOf(team.At("alpha").sent[1], Cause::kUnknownDestination), 3);
  EXPECT_EQ(CountOf(team.At("gilda").received[1], Cause::kUnknownDestination), 1);
}

TEST(Destinations, AllMeansEveryOtherKnownVehicleInEitherField) {
  Team team;
  for (const char* all : {"all", "ALL", "All"}) {
    EXPECT_EQ(KeysOf(team.Message("alpha", all)), (Names{"bravo", "charlie", "henry"}));
    EXPECT_EQ(KeysOf(team.Message({.source = "alpha", .dest_group = all})),
              (Names{"bravo", "charlie", "henry"}));
  }
  EXPECT_EQ(KeysOf(team.Message("alpha", "nemo:all:bravo")),
            (Names{"bravo", "charlie", "henry", "nemo"}));
}

TEST(Destinations, AreNeverTheSource) {
  Team team;
  EXPECT_EQ(KeysOf(team.Message("bravo", "BRAVO:alpha")), Names{"alpha"});
  EXPECT_EQ(KeysOf(team.Message({.source = "bravo", .dest_group = "RED_TEAM"})), Names{"henry"});
  const Fates to_itself = team.Message("alpha", "alpha");
  EXPECT_EQ(KeysOf(to_itself), Names{""});
  EXPECT_EQ(to_itself.at("").cause, Cause::kNoDestination);
  EXPECT_EQ(to_itself.at("").destination, kNoContact);
}

TEST(Destinations, OfAGroupWithoutMembersIsOneFate) {
  Team team;
  EXPECT_EQ(team.Message({.source = "alpha", .dest_group = "blue"}).at("").cause,
            Cause::kNoDestination);
  EXPECT_EQ(Total(team.router.counts(Kind::kMessage)), 1);
}

TEST(Destinations, DoNotIncludeVehiclesWithoutGroupWhereOnlyNamesAreGiven) {
  Team team;
  EXPECT_EQ(KeysOf(team.Message({.source = "alpha", .dest_node = "bravo", .dest_group = ""})),
            Names{"bravo"});
}

TEST(Destinations, MissingMakeAMessageInvalid) {
  Team team;
  EXPECT_EQ(team.Message({.source = "alpha"}).at("").cause, Cause::kInvalid);
  EXPECT_EQ(team.Message("alpha", " : ").at("").cause, Cause::kInvalid);
  EXPECT_EQ(team.Message("alpha", ListOf(1001)).at("").cause, Cause::kInvalid);
  EXPECT_EQ(team.Message("not a name", "bravo").at("").cause, Cause::kInvalid);
  EXPECT_EQ(team.Message("not a name", "bravo").at("").source, kNoContact);
  EXPECT_EQ(CountOf(team.At("alpha").sent[1], Cause::kInvalid), 3);
}

TEST(Destinations, AreRefusedOneByOneWhereTheWholeMessageIs) {
  Team team;
  const Fates fates = team.Message("nemo", "bravo:dory");
  EXPECT_EQ(KeysOf(fates), (Names{"bravo", "dory"}));
  EXPECT_EQ(fates.at("bravo").cause, Cause::kUnknownSource);
  EXPECT_EQ(fates.at("dory").cause, Cause::kUnknownSource);
}

}  // namespace shoal::destinations_test
