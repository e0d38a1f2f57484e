#include "lib/tools/fields/field_reader.h"

#include <gtest/gtest.h>

#include <string>

#include "lib/bus/bus/bus.h"
#include "shoal/comms_fates_t.hpp"
#include "shoal/comms_pulse_columns_t.hpp"
#include "shoal/helm_state_t.hpp"
#include "shoal/nav_t.hpp"
#include "shoal/node_report_t.hpp"
#include "shoal/swarm_t.hpp"

namespace shoal::field_reader_test {

template <class T>
Bytes Encoded(const T& message) {
  Bytes bytes;
  EncodeInto(message, &bytes);
  return bytes;
}

std::optional<double> Read(std::string_view type, std::string_view path, const Bytes& bytes) {
  const Result<FieldReader> reader = FieldReader::Find(ShoalTypes(), type, path);
  EXPECT_TRUE(reader.ok()) << reader.error();
  return reader->Read(bytes);
}

std::string ErrorOf(std::string_view type, std::string_view path) {
  const Result<FieldReader> reader = FieldReader::Find(ShoalTypes(), type, path);
  return reader.ok() ? "" : reader.error();
}

TEST(FieldReader, ReadsEveryMemberOfATypeOfOneSize) {
  nav_t nav{};
  nav.utime = 12'345'678;
  nav.x_m = 1.5;
  nav.z_m = -7.25;
  nav.altitude_m = 1e6;
  const Bytes bytes = Encoded(nav);
  EXPECT_EQ(Read("nav_t", "utime", bytes), 12'345'678);
  EXPECT_EQ(Read("nav_t", "x_m", bytes), 1.5);
  EXPECT_EQ(Read("nav_t", "z_m", bytes), -7.25);
  EXPECT_EQ(Read("nav_t", "altitude_m", bytes), 1e6);
}

TEST(FieldReader, ReadsBehindTextsAndLists) {
  helm_state_t helm{};
  helm.vehicle = "alpha";
  helm.task = "a long name of a task";
  helm.waypoint_index = -1;
  helm.cross_track_error_m = -3.5;
  EXPECT_EQ(Read("helm_state_t", "waypoint_index", Encoded(helm)), -1);
  EXPECT_EQ(Read("helm_state_t", "cross_track_error_m", Encoded(helm)), -3.5);
}

swarm_t SwarmOfTwo() {
  swarm_t swarm{};
  swarm.vehicle = "bravo";
  swarm.num_contacts = 2;
  swarm.contacts.resize(2);
  swarm.contacts[0].x_m = 10;
  swarm.contacts[0].recovered = {"reporter_pos predict"};
  swarm.contacts[0].num_recovered = 1;
  swarm.contacts[1].x_m = 20;
  swarm.contacts[1].is_silent = 1;
  swarm.num_sources = 1;
  swarm.sources.resize(1);
  swarm.sources[0].clean = 7;
  return swarm;
}

TEST(FieldReader, ReadsOneElementOfAListOfStructs) {
  const Bytes bytes = Encoded(SwarmOfTwo());
  EXPECT_EQ(Read("swarm_t", "contacts[0].x_m", bytes), 10);
  EXPECT_EQ(Read("swarm_t", "contacts[1].x_m", bytes), 20);
  EXPECT_EQ(Read("swarm_t", "contacts[1].is_silent", bytes), 1) << "true is 1";
  EXPECT_EQ(Read("swarm_t", "contacts[0].is_silent", bytes), 0);
  EXPECT_EQ(Read("swarm_t", "sources[0].clean", bytes), 7);
  EXPECT_EQ(Read("swarm_t", "contacts[2].x_m", bytes), std::nullopt) << "there are two";
}

TEST(FieldReader, ReadsListsWithinLists) {
  comms_fates_t fates{};
  fates.num_fates = 2;
  fates.fates.resize(2);
  fates.fates[1].num_paths = 1;
  fates.fates[1].path.resize(1);
  fates.fates[1].path[0].bits_flipped = 9;
  EXPECT_EQ(Read("comms_fates_t", "fates[1].path[0].bits_flipped", Encoded(fates)), 9);
  EXPECT_EQ(Read("comms_fates_t", "fates[0].path[0].bits_flipped", Encoded(fates)), std::nullopt);
  comms_pulse_columns_t pulses{};
  pulses.num_ends = pulses.num_styles = pulses.num_pulses = 1;
  pulses.ends = {{"ALPHA", 3.5, 4}};
  pulses.styles.resize(1);
  pulses.source = pulses.destination = pulses.style = {0};
  pulses.beam_width_m = {12};
  for (const char* type : {"comms_pulses_t", "comms_pulse_columns_t"}) {
    EXPECT_EQ(Read(type, "pulses[0].tx_m", Encoded(pulses)), 3.5) << "columns count as a list";
    EXPECT_EQ(Read(type, "num_pulses", Encoded(pulses)), 1);
  }
}

TEST(FieldReader, ReadsNothingOfOtherOrDamagedMessages) {
  Bytes nav = Encoded(nav_t{});
  EXPECT_EQ(Read("nav_t", "x_m", Encoded(node_report_t{})), std::nullopt);
  EXPECT_EQ(Read("node_report_t", "x_m", nav), std::nullopt);
  nav.pop_back();
  EXPECT_EQ(Read("nav_t", "x_m", nav), std::nullopt);
  EXPECT_EQ(Read("nav_t", "x_m", {}), std::nullopt);
  Bytes swarm = Encoded(SwarmOfTwo());
  swarm.resize(swarm.size() - 1);
  EXPECT_EQ(Read("swarm_t", "contacts[0].x_m", swarm), std::nullopt);
}

TEST(FieldReader, StatesWhatIsWrongWithAPath) {
  EXPECT_EQ(ErrorOf("nav_t", "sped_mps"),
            "nav_t has no field 'sped_mps' (did you mean "
            "'speed_mps'?)");
  EXPECT_EQ(ErrorOf("actuators_t", "zzz"),
            "actuators_t has no field 'zzz'; it has utime, thrust_pct, rudder_deg, "
            "stern_plane_deg, propeller_rpm");
  EXPECT_EQ(ErrorOf("helm_state_t", "task"), "task of helm_state_t is text, no number");
  EXPECT_EQ(ErrorOf("swarm_t", "contacts.x_m"),
            "contacts of swarm_t is an array: write contacts[0]");
  EXPECT_EQ(ErrorOf("nav_t", "x_m[0]"), "x_m of nav_t is not an array: write x_m");
  EXPECT_EQ(ErrorOf("swarm_t", "contacts[0]"),
            "contacts[0] is a swarm_contact_t, no number: write contacts[0].name");
  EXPECT_EQ(ErrorOf("swarm_t", "contacts[0].x"),
            "swarm_contact_t has no field 'x' (did you mean 'x_m'?)");
  EXPECT_EQ(ErrorOf("nav_t", "x_m.y"), "x_m of nav_t is double: nothing can follow it, not '.y'");
  EXPECT_EQ(ErrorOf("swarm_t", "contacts[-1].x_m"),
            "contacts of swarm_t is an array: write contacts[0]");
  EXPECT_NE(ErrorOf("nav_t", ""), "");
  EXPECT_NE(ErrorOf("swarm_t", "contacts[99999999999999999999].x_m"), "");
}

}  // namespace shoal::field_reader_test
