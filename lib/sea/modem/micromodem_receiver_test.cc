// Two modems and the water between them.
#include <gtest/gtest.h>

#include "lib/base/time/seconds.h"
#include "lib/base/time/utc_time.h"
#include "lib/sea/modem/two_modems.h"

namespace shoal::micromodem_receiver_test {

using Lines = std::vector<std::string>;

std::string Hex(size_t num_bytes, const std::string& pair = "5a") {
  std::string text;
  for (size_t i = 0; i < num_bytes; ++i) text += pair;
  return text;
}

TEST(MicroModemPair, CarriesDataAtRate0BehindACyclePacket) {
  TwoModems modems;
  modems.Give(0, "CCCYC,0,1,2,0,1,1");
  EXPECT_EQ(modems.Lines(0), (Lines{"CACYC,0,1,2,0,1,1", "CATXP,0"}));
  modems.Run(0.8);
  EXPECT_EQ(modems.Lines(0), Lines{}) << "9 bytes take 0.9 s at 80 bit/s";
  modems.Run(0.15);
  EXPECT_EQ(modems.Lines(0), Lines{"CATXF,0"}) << "then there is a pause";
  modems.Run(0.15);
  const Lines asked = modems.Lines(0);
  ASSERT_EQ(Names(asked), (Lines{"CADRQ"}));
  EXPECT_EQ(asked[0].substr(12), ",1,2,1,32,1");
  modems.Give(0, "CCTXD,1,2,1," + Hex(32));
  EXPECT_EQ(modems.Lines(0), (Lines{"CATXD,1,2,1,32", "CATXP,32"}));
  modems.Run(12);
  const Lines received = modems.Lines(1);
  EXPECT_EQ(Names(received), (Lines{"CARXP", "CACYC", "CACST", "CARXP", "CARXD", "CACST"}));
  EXPECT_EQ(received[4], "CARXD,1,2,1,1," + Hex(32));
  const Lines sender = modems.Lines(0);
  ASSERT_EQ(Names(sender), (Lines{"CATXF", "CAACK", "CACST"}));
  EXPECT_EQ(sender[1], "CAACK,2,1,1,1");
  EXPECT_FALSE(modems.modem(0).is_in_a_cycle());
}

TEST(MicroModemPair, CarriesAsManyAndAsLongFramesAsEachRateHolds) {
  for (size_t rate = 1; rate < kMicroModemRates.size(); ++rate) {
    const MicroModemRate& row = kMicroModemRates[rate];
    TwoModems modems;
    modems.Give(0, "CCCYC,0,1,2," + std::to_string(rate) + ",1," + std::to_string(row.max_frames));
    for (int i = 0; i < row.max_frames; ++i) {
      const Lines asked = modems.Lines(0, "CADRQ");
      ASSERT_EQ(asked.size(), 1U) << "rate " << rate << ", frame " << i + 1;
      EXPECT_EQ(asked[0].substr(12),
                ",1,2,1," + std::to_string(row.max_frame_bytes) + "," + std::to_string(i + 1));
      modems.Give(0, "CCTXD,1,2,1," + Hex(static_cast<size_t>(row.max_frame_bytes)));
    }
    modems.Run(10);
    EXPECT_EQ(modems.Lines(1, "CARXD").size(), static_cast<size_t>(row.max_frames)) << rate;
    EXPECT_EQ(modems.Lines(0, "CAACK").size(), static_cast<size_t>(row.max_frames)) << rate;
    EXPECT_EQ(modems.sent(1).size(), 1U) << "one packet acknowledges all frames";
    const MicroModemSent& packet = modems.sent(0).at(0);
    EXPECT_NEAR(Seconds(packet.air_us), static_cast<double>(8 * packet.bytes.size()) / row.bps,
                1e-5);
  }
}

TEST(MicroModemPair, TellsTheFramesThatAreDamagedAndAcknowledgesTheOthers) {
  TwoModems modems;
  modems.snr_db = 7.4;
  modems.water = [](int from, std::vector<uint8_t>* bytes) {
    if (from == 0) (*bytes)[bytes->size() - 4 - 64 - 4 - 1] ^= 0x10;  // Last byte of frame 2.
    return true;
  };
  modems.Give(0, "CCCYC,0,1,2,1,1,3");
  for (int i = 0; i < 3; ++i) modems.Give(0, "CCTXD,1,2,1," + Hex(64));
  modems.Run(20);
  const Lines received = modems.Lines(1);
  ASSERT_EQ(Names(received), (Lines{"CARXP", "CACYC", "CARXD", "CAMSG", "CARXD", "CACST"}));
  EXPECT_EQ(received[3], "CAMSG,BAD_CRC,2");
  const Lines cst = FieldsOf(received[5]);
  EXPECT_EQ(cst[1], "1") << "mode";
  EXPECT_EQ(cst[18], "3") << "frames";
  EXPECT_EQ(cst[19], "1") << "bad frames";
  EXPECT_EQ(cst[21], "07") << "SNR";
  EXPECT_EQ(modems.Lines(0, "CAACK"), (Lines{"CAACK,2,1,1,1", "CAACK,2,1,3,1"}));
  EXPECT_EQ(modems.modem(1).counts().damaged_frames, 1);
}

TEST(MicroModemPair, MeasuresTheTravelTimeOfAPing) {
  TwoModems modems;
  modems.travel_us = 1'234'567;
  modems.Give(0, "CCMPC,1,2");
  modems.Run(10);
  const Lines pinged = modems.Lines(1);
  ASSERT_EQ(Names(pinged), (Lines{"CAMPA", "CACST"}));
  EXPECT_EQ(pinged[0], "CAMPA,1,2");
  const Lines answered = modems.Lines(0);
  ASSERT_EQ(Names(answered), (Lines{"CAMPC", "CAMPR", "CACST"}));
  EXPECT_EQ(answered[1], "CAMPR,2,1,1.2346");
}

TEST(MicroModemPair, CarriesMiniPacketsToOneAndToAll) {
  TwoModems modems;
  modems.Give(0, "CCMUC,1,2,1Fff");
  modems.Give(0, "CCMUC,1,0,0001");
  modems.Give(0, "CCMUC,1,3,0002");
  EXPECT_EQ(modems.Lines(0), (Lines{"CAMUC,1,2,1Fff", "CAMUC,1,0,0001", "CAMUC,1,3,0002"}));
  modems.Run(10);
  EXPECT_EQ(modems.Lines(1, "CAMUA"), (Lines{"CAMUA,1,2,1fff", "CAMUA,1,0,0001"}));
  EXPECT_EQ(modems.modem(1).counts().overheard, 1);
}

TEST(MicroModemPair, TellsWhenAPacketBeganToArriveByItsClock) {
  const int64_t utc_us = *ToUtc({.year = 2026, .month = 11, .day = 21, .hour = 23, .minute = 59});
  TwoModems modems({.address = 1}, {.address = 2, .utc_at_zero_us = utc_us});
  modems.travel_us = 61'234'567;
  modems.Give(0, "CCMUC,1,2,0001");
  modems.Run(70);
  const Lines cst = modems.Lines(1, "CACST");
  ASSERT_EQ(cst.size(), 1U);
  EXPECT_EQ(FieldsOf(cst[0])[2], "000001.2345");
}

TEST(MicroModemPair, TellsThatAnnouncedDataDidNotCome) {
  TwoModems modems;
  modems.Give(0, "CCCYC,0,1,2,0,0,1");
  modems.Run(1.2);
  modems.water = [](int, auto*) { return false; };
  modems.Give(0, "CCTXD,1,2,0,aa");
  modems.Run(13);
  EXPECT_EQ(Names(modems.Lines(1)), (Lines{"CARXP", "CACYC", "CACST"}));
  modems.Run(5);
  const Lines lines = modems.Lines(1);
  ASSERT_EQ(Names(lines), (Lines{"CAMSG", "CACST"}));
  EXPECT_EQ(lines[0], "CAMSG,PACKET_TIMEOUT,14");
  EXPECT_EQ(FieldsOf(lines[1])[1], "2");
}

TEST(MicroModemPair, HearsNoDataAtRate0WhoseCyclePacketIsLost) {
  TwoModems modems;
  modems.water = [](int, std::vector<uint8_t>* bytes) { return bytes->size() > 9; };
  modems.Give(0, "CCCYC,0,1,2,0,1,1");
  modems.Run(1.2);
  modems.Give(0, "CCTXD,1,2,1,aa");
  modems.Run(30);
  EXPECT_EQ(modems.Lines(1), Lines{});
  EXPECT_EQ(modems.modem(1).counts().no_cycle, 1);
  EXPECT_EQ(Names(modems.Lines(0)),
            (Lines{"CACYC", "CATXP", "CATXF", "CADRQ", "CATXD", "CATXP", "CATXF"}));
}

TEST(MicroModemPair, SendsToAllWithoutAcknowledgements) {
  TwoModems modems;
  modems.Give(0, "CCCYC,0,1,0,2,1,1");
  modems.Give(0, "CCTXD,1,0,1,abcd");
  modems.Run(10);
  EXPECT_EQ(modems.Lines(1, "CARXD"), (Lines{"CARXD,1,0,1,1,abcd"}));
  EXPECT_TRUE(modems.sent(1).empty());
}

TEST(MicroModemPair, AcknowledgesNoFrameThatDoesNotAskForIt) {
  TwoModems modems;
  modems.Give(0, "CCCYC,0,1,2,2,1,2");
  modems.Give(0, "CCTXD,1,2,0,01");
  modems.Give(0, "CCTXD,1,2,1,02");
  modems.Run(10);
  EXPECT_EQ(modems.Lines(0, "CAACK"), (Lines{"CAACK,2,1,2,1"}));
}

TEST(MicroModemPair, AnswersNoPingThatIsForAll) {
  TwoModems modems;
  const auto ping = EncodeMicroModemPacket({.kind = MicroModemKind::kPing, .source = 1});
  const auto output = modems.modem(1).Receive({.bytes = ping}, 0);
  EXPECT_EQ(output.to_host, "");
  EXPECT_TRUE(modems.modem(1).Transmit(0).to_water.empty());
  EXPECT_EQ(modems.modem(1).counts().overheard, 1);
}

TEST(MicroModemPair, AwaitsDataOnlyUntilTheyCome) {
  TwoModems modems;
  modems.Give(0, "CCTXD,1,2,0,aa");
  modems.Give(0, "CCCYC,0,1,2,0,0,1");
  modems.Run(30);
  EXPECT_EQ(modems.Lines(1, "CAMSG"), Lines{});
}

TEST(MicroModemPair, AwaitsDataOfTheirOwnOnlyAtRate0) {
  for (const int rate : {0, 2}) {
    MicroModem modem({.address = 2});
    const auto cycle = EncodeMicroModemPacket(
        {.kind = MicroModemKind::kCycle, .source = 1, .rate = rate, .num_frames = 1});
    EXPECT_NE(modem.Receive({.bytes = cycle}, 0).to_host, "");
    EXPECT_EQ(modem.NextEvent_us().has_value(), rate == 0);
  }
}

TEST(MicroModemPair, AwaitsNothingAfterAReboot) {
  TwoModems modems;
  modems.Give(0, "CCCYC,0,1,2,0,0,1");
  modems.Run(1.5);
  modems.Give(1, "CCMSC,2,2,0");
  modems.Run(30);
  EXPECT_EQ(modems.Lines(1, "CAMSG"), Lines{});
}

TEST(MicroModemPair, DropsAnswersForWhichTheAirHasNoTime) {
  MicroModem modem({.address = 2});
  const auto ping =
      EncodeMicroModemPacket({.kind = MicroModemKind::kPing, .source = 1, .destination = 2});
  for (size_t i = 0; i < MicroModem::kMaxWaiting + 3; ++i) {
    EXPECT_NE(modem.Receive({.bytes = ping}, 0).to_host, "");
    EXPECT_EQ(modem.Transmit(0).to_water.size(), i == 0 ? 1U : 0U);
  }
  EXPECT_EQ(modem.counts().answers_dropped, 2) << "one is on the air, 8 wait";
}

TEST(MicroModemPair, IgnoresOtherProgramsAndItsOwnAddress) {
  TwoModems modems({.address = 2}, {.address = 2});
  modems.Give(0, "CCMUC,2,0,0001");
  modems.Run(5);
  EXPECT_EQ(modems.Lines(1), Lines{});
  EXPECT_EQ(modems.modem(1).counts().own, 1);
  const std::vector<uint8_t> foreign = {'p', 'i', 'n', 'g'};
  const auto output = modems.modem(1).Receive({.bytes = foreign}, modems.now_us());
  EXPECT_EQ(output.to_host, "");
  EXPECT_EQ(modems.modem(1).counts().foreign, 1);
}

TEST(MicroModemPair, SaysAsMuchAsItsHostHasAskedFor) {
  TwoModems modems;
  for (const char* key : {"CST", "RXP"}) modems.Give(1, std::string("CCCFG,") + key + ",0");
  for (const char* key : {"TXP", "TXF"}) modems.Give(0, std::string("CCCFG,") + key + ",0");
  modems.Lines(0);
  modems.Lines(1);
  modems.Give(0, "CCCYC,0,1,2,2,0,1");
  modems.Give(0, "CCTXD,1,2,0,01");
  modems.Run(10);
  EXPECT_EQ(Names(modems.Lines(0)), (Lines{"CACYC", "CADRQ", "CATXD"}));
  EXPECT_EQ(Names(modems.Lines(1)), (Lines{"CACYC", "CARXD"}));
}

// Whatever the network's own rate is: the packet holds nothing but itself, and names its rate.
TEST(MicroModemAir, IsAskedForTheRateOfThePacketAndNothingBeside) {
  TwoModems modems;
  modems.Give(0, "CCMUC,1,2,0123");
  modems.Run(5);
  const MicroModemSent& packet = modems.sent(0).at(0);
  EXPECT_EQ(packet.bytes.size(), 9U);
  EXPECT_EQ(packet.bps, 80);
  EXPECT_EQ(packet.air_us, 900'000);
  EXPECT_EQ(modems.Lines(1, "CAMUA"), (Lines{"CAMUA,1,2,0123"}));
}

TEST(MicroModemAir, LastsAsLongAsWhatTheNetworkPutsOnTheAir) {
  TwoModems modems({.address = 1, .more_bytes = 4});
  modems.Give(0, "CCMUC,1,2,0123");
  EXPECT_EQ(modems.sent(0).at(0).bytes.size(), 9U);
  EXPECT_EQ(modems.sent(0).at(0).air_us, 1'300'000);
}

TEST(MicroModem2, SendsFlexibleDataInOneSentence) {
  TwoModems modems({.address = 1, .version = 2}, {.address = 2, .version = 2});
  modems.Give(0, "CCTDP,2,1,1,0,0102ff");
  EXPECT_EQ(modems.Lines(0), (Lines{"CATDP,0,1,2,1,1,0,3", "CATXP,3"}));
  EXPECT_EQ(modems.sent(0).at(0).bps, 250);
  modems.Run(10);
  const Lines received = modems.Lines(1);
  ASSERT_EQ(Names(received), (Lines{"CARDP", "CACST"}));
  EXPECT_EQ(received[0], "CARDP,1,2,1,1,0,,1;3;0102ff");
  EXPECT_TRUE(received[1].starts_with("CACST,6,0,")) << received[1];
  EXPECT_EQ(FieldsOf(received[1]).size(), 31U) << "the version, 29 and the name";
  EXPECT_EQ(FieldsOf(received[1])[18], "5") << "FDP";
  const Lines sender = modems.Lines(0);
  ASSERT_EQ(Names(sender), (Lines{"CATXF", "CAACK", "CACST"}));
  EXPECT_EQ(sender[1], "CAACK,2,1,1,1");
}

TEST(MicroModem2, ReportsFlexibleDataThatArrivedDamaged) {
  TwoModems modems({.address = 1, .version = 2}, {.address = 2, .version = 2});
  modems.water = [](int, std::vector<uint8_t>* bytes) {
    bytes->back() ^= 1;
    return true;
  };
  modems.Give(0, "CCTDP,2,1,1,0,0102ff");
  modems.Run(10);
  const Lines received = modems.Lines(1);
  ASSERT_EQ(Names(received), (Lines{"CARDP", "CACST"}));
  EXPECT_EQ(received[0], "CARDP,1,2,1,1,0,,0;0;");
  EXPECT_TRUE(received[1].starts_with("CACST,6,1,")) << received[1];
  EXPECT_EQ(modems.Lines(0, "CAACK"), Lines{});
}

TEST(MicroModem2, RefusesFlexibleDataThatDoesNotFit) {
  TwoModems modems({.address = 1, .version = 2});
  for (const std::string& body :
       {std::string("CCTDP,2,1,1,0,"), "CCTDP,2,1,1,0," + Hex(101), std::string("CCTDP,2,9,1,0,00"),
        std::string("CCTDP,128,1,1,0,00"), std::string("CCTDP,2,1,1,0,0")}) {
    modems.Give(0, body);
    EXPECT_EQ(Names(modems.Lines(0)), Lines{"CAERR"}) << body;
  }
  TwoModems first_version;
  first_version.Give(0, "CCTDP,2,1,1,0,00");
  const Lines refused = first_version.Lines(0);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_TRUE(refused[0].ends_with("unknown sentence")) << refused[0];
}

TEST(MicroModem2, NamesItsFirmware) {
  TwoModems modems({.address = 1, .version = 2});
  modems.Give(0, "CCMSC,1,1,0");
  modems.Run(1);
  const Lines lines = modems.Lines(0, "CAREV");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(lines[1].ends_with(",AUV,2.0.17047")) << lines[1];
}

TEST(MicroModemAir, IsWaitedForByTheNextPacket) {
  TwoModems modems;
  for (int i = 0; i < 4; ++i) modems.Give(0, "CCMPC,1,2");
  EXPECT_EQ(modems.sent(0).size(), 1U);
  modems.Run(10);
  EXPECT_EQ(modems.sent(0).size(), 4U);
  EXPECT_EQ(modems.Lines(0, "CAMPR").size(), 4U);
}

}  // namespace shoal::micromodem_receiver_test
