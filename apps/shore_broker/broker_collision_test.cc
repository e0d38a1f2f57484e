// Packets that overlap at the receiver, where collisions damage instead of drop.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "apps/shore_broker/water_testing.h"

namespace shoal::broker_collision_test {

/// Collisions XOR what overlaps; nothing else happens to packets.
Mission CorruptingNetwork(bool crc) {
  Mission mission = QuietNetwork();
  mission.acoustics.crc = crc;
  mission.acoustics.options.collisions = CollisionModel::kCorrupt;
  return mission;
}

class CorruptingFixture : public AcousticFixture {
 protected:
  explicit CorruptingFixture(bool crc) : AcousticFixture(CorruptingNetwork(crc)) {}

  /// alpha and bravo send at once, both 75 m from charlie; steps until that is decided.
  void SendAtOnce() {
    Send(ReportFrom("charlie", 75));
    Begin();
    SendPacket("alpha", {0x0f, 0x0f});
    SendPacket("bravo", {0x33, 0x33});
    StepUntilFates();
  }

  /// Returns the causes at charlie.
  std::vector<std::string> CausesAtCharlie() const {
    std::vector<std::string> causes;
    for (const fate_t& fate : fates_) {
      if (fate.destination == "charlie") causes.push_back(fate.cause);
    }
    return causes;
  }
};

class CheckedCollision : public CorruptingFixture {
 protected:
  CheckedCollision() : CorruptingFixture(true) {}
};

TEST_F(CheckedCollision, IsTheCauseOfWhatItsChecksumThrowsAway) {
  SendAtOnce();
  EXPECT_EQ(CausesAtCharlie(), (std::vector<std::string>{"collision", "collision"}));
  EXPECT_TRUE(packets_["charlie"].empty());
  EXPECT_TRUE(PageHas("rejected by receivers            2")) << broker_.Status().text;
}

class UncheckedCollision : public CorruptingFixture {
 protected:
  UncheckedCollision() : CorruptingFixture(false) {}
};

TEST_F(UncheckedCollision, HandsOverBothPacketsXored) {
  SendAtOnce();
  EXPECT_EQ(CausesAtCharlie(), (std::vector<std::string>{"damaged", "damaged"}));
  ASSERT_EQ(packets_["charlie"].size(), 2U);
  for (const acoustic_rx_t& packet : packets_["charlie"]) {
    EXPECT_EQ(packet.payload, (Bytes{0x3c, 0x3c})) << packet.source;
  }
}

}  // namespace shoal::broker_collision_test
