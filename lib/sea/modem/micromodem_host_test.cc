// What a modem answers its host, by itself.
#include <gtest/gtest.h>

#include "lib/base/time/utc_time.h"
#include "lib/sea/modem/two_modems.h"

namespace shoal::micromodem_host_test {

using Lines = std::vector<std::string>;

/// One modem of address 1 on 21 November 2026, 02:25:24, and its host.
class MicroModemHost : public testing::Test {
 protected:
  Lines Ask(const std::string& body) {
    modems.Give(0, body);
    return modems.Lines(0);
  }
  std::string AskForOne(const std::string& body) {
    const Lines lines = Ask(body);
    EXPECT_EQ(lines.size(), 1U) << body;
    return lines.empty() ? "" : lines[0];
  }
  MicroModem& modem() { return modems.modem(0); }

  static constexpr CalendarTime kStart = {
      .year = 2026, .month = 11, .day = 21, .hour = 2, .minute = 25, .second = 24};
  TwoModems modems{{.address = 1, .utc_at_zero_us = ToUtc(kStart).value_or(0)}};
};

TEST_F(MicroModemHost, GetsItsSettingsBackAsItSetThem) {
  EXPECT_EQ(AskForOne("CCCFG,SRC,5"), "CACFG,SRC,5");
  EXPECT_EQ(modem().address(), 5);
  EXPECT_EQ(AskForOne("CCCFQ,SRC"), "CACFG,SRC,5");
  EXPECT_EQ(AskForOne("CCCFG,psk.packet.mod_hdr_version,1"), "CACFG,psk.packet.mod_hdr_version,1");
  EXPECT_EQ(AskForOne("CCCFQ,psk.packet.mod_hdr_version"), "CACFG,psk.packet.mod_hdr_version,1");
  EXPECT_EQ(Ask("CCCFQ,ALL").size(), 15U);
  EXPECT_EQ(Ask("CCCFQ,TOP").back(), "CACFG,psk.packet.mod_hdr_version,1");
}

TEST_F(MicroModemHost, GetsTheFirstSettingsBackWithAll) {
  Ask("CCCFG,SRC,5");
  Ask("CCCFG,TAT,20");
  Ask("CCCFG,mine,1");
  EXPECT_EQ(AskForOne("CCCFG,ALL,0"), "CACFG,ALL,0");
  EXPECT_EQ(AskForOne("CCCFQ,TAT"), "CACFG,TAT,50");
  EXPECT_EQ(modem().address(), 1);
  EXPECT_EQ(Ask("CCCFQ,ALL").size(), 14U);
}

TEST_F(MicroModemHost, FillsNoMemoryWithKeys) {
  for (int i = 0; i < 100; ++i) Ask("CCCFG,key" + std::to_string(i) + ",1");
  EXPECT_EQ(Ask("CCCFQ,ALL").size(), 14 + MicroModemSettings::kMaxOtherKeys);
  EXPECT_EQ(AskForOne("CCCFG,key0,2"), "CACFG,key0,2");
}

TEST_F(MicroModemHost, SeesTheModemComeUpAgainAfterAReboot) {
  EXPECT_EQ(AskForOne("CCMSC,1,1,0"), "CAMSC,1,1,0");
  modems.Run(0.19);
  EXPECT_EQ(modems.Lines(0), Lines{});
  modems.Run(0.02);
  EXPECT_EQ(modems.Lines(0), (Lines{"CAREV,022524,INIT,0.94.0.00", "CAREV,022524,AUV,0.94.0.00"}));
  Ask("CCCFG,REV,0");
  Ask("CCMSC,1,1,0");
  modems.Run(1);
  EXPECT_EQ(modems.Lines(0), Lines{});
}

TEST_F(MicroModemHost, SetsTheClockAndReadsIt) {
  EXPECT_EQ(AskForOne("CCTMQ,0"), "CATMQ,2026-11-21T02:25:24Z,RTC,RTC");
  modems.Run(2.5);
  EXPECT_EQ(AskForOne("CCTMQ,0"), "CATMQ,2026-11-21T02:25:26Z,RTC,RTC");
  EXPECT_EQ(AskForOne("CCCLK,2027,1,2,3,4,5"), "CACLK,2027,1,2,3,4,5");
  EXPECT_EQ(AskForOne("CCCLK,2026,12,31,23,59,60"), "CACLK,2027,1,1,0,0,0");
  EXPECT_EQ(AskForOne("CCCLK,2199,12,31,23,59,58"), "CACLK,2199,12,31,23,59,58");
  EXPECT_EQ(AskForOne("CCTMS,2028-02-29T12:00:00Z,0"), "CATMS,0,2028-02-29T12:00:00Z");
  modems.Run(1);
  EXPECT_EQ(AskForOne("CCTMQ,0"), "CATMQ,2028-02-29T12:00:01Z,RTC,RTC");
  modem().SetClock(0, modems.now_us());
  EXPECT_EQ(AskForOne("CCTMQ,0"), "CATMQ,1970-01-01T00:00:00Z,RTC,RTC");
}

TEST_F(MicroModemHost, IsToldWhatIsWrongWithASentence) {
  const std::pair<const char*, const char*> wrong[] = {
      {"CCXYZ,1", "1,unknown sentence"},
      {"CCTDP,2,1,0,0,aabb", "1,unknown sentence"},
      {"GPRMC", "1,unknown sentence"},
      {"CCCFG,SRC,128", "2,SRC takes 0 to 127"},
      {"CCCFG,ALL,1", "2,ALL takes only 0"},
      {"CCCFG,SRC", "2,field 2 must be there"},
      {"CCCFG,,1", "2,field 1 must be a key, as SRC"},
      {"CCCLK,2200,1,1,0,0,0", "2,field 1 must be 1970 to 2199"},
      {"CCCLK,2200,6,1,0,0,0", "2,field 1 must be 1970 to 2199"},
      {"CCTMS,2200-06-01T00:00:00Z,0",
       "2,field 1 must be a time as 2026-11-21T02:25:24Z, 1970 to 2199"},
      {"CCCFQ,nothing", "2,field 1 must be ALL or TOP or a key that is set"},
      {"CCMSC,1,2,0", "2,field 2 must be 1"},
      {"CCCLK,2026,2,29,0,0,0", "2,field 3 must be a day of that month"},
      {"CCCLK,2026,13,29,0,0,0", "2,field 2 must be 1 to 12"},
      {"CCTMS,yesterday,0", "2,field 1 must be a time as 2026-11-21T02:25:24Z, 1970 to 2199"},
      {"CCCYC,0,2,1,0,0,1", "2,field 2 must be 1"},
      {"CCCYC,0,1,128,0,0,1", "2,field 3 must be 0 to 127"},
      {"CCCYC,0,1,2,6,0,1", "2,field 4 must be 0 to 5"},
      {"CCCYC,0,1,2,0,2,1", "2,field 5 must be 0 to 1"},
      {"CCCYC,0,1,2,2,0,4", "2,field 6 must be 1 to 3"},
      {"CCTXD,2,1,0,aa", "2,field 1 must be 1"},
      {"CCTXD,1,2,0,aab", "2,field 4 must be hex digits of at most 256 bytes"},
      {"CCTXD,1,2,0,xy", "2,field 4 must be hex digits of at most 256 bytes"},
      {"CCMPC,1,0", "2,field 2 must be 1 to 127"},
      {"CCMUC,1,2,2000", "2,field 3 must be 0000 to 1fff"},
      {"CCMUC,1,2,123", "2,field 3 must be 0000 to 1fff"},
      {"CCPDT,1,2,0,0,-1", "2,field 5 must be 1 to 60000"},
      {"CCPNT,1,2,0,", "2,field 4 must be 1 to 60000"},
  };
  for (const auto& [body, reason] : wrong) {
    EXPECT_EQ(AskForOne(body), std::string("CAERR,022524,NMEA,") + reason) << body;
  }
  EXPECT_EQ(modem().counts().sentences_refused, std::ssize(wrong));
  EXPECT_EQ(modem().counts().sentences_answered, 0);
}

TEST_F(MicroModemHost, GetsNoAnswerToALineThatIsNoSentence) {
  const std::string lines[] = {"",
                               "$",
                               "CCCFQ,ALL",
                               "$CCCFQ,ALL*00\r\n",
                               "$CC\x01*33",
                               "\r\n",
                               "$CCCFQ,ALL*3",
                               std::string(2000, '$'),
                               "$CCCFG,A," + std::string(2000, 'x')};
  for (const std::string& line : lines) {
    EXPECT_EQ(modem().Take(line, 0).to_host, "") << line;
  }
  EXPECT_EQ(modem().counts().lines_dropped, std::ssize(lines));
  EXPECT_EQ(modem().Take("$CCCFQ,SRC", 0).to_host, "$CACFG,SRC,1*33\r\n") << "no checksum is fine";
}

TEST_F(MicroModemHost, MayCutItsStreamAnywhere) {
  const std::string stream =
      "\r\n$CCCFQ,SRC*3A\r\n$CCCFQ,TAT\n" + std::string(3000, 'x') + "\r$CCCFQ,BND\r$CCCFQ";
  const std::string expected = "$CACFG,SRC,1*33\r\n$CACFG,TAT,50*04\r\n$CACFG,BND,1*39\r\n";
  for (const size_t step : {1, 2, 7, 4000}) {
    MicroModem other({.address = 1});
    std::string lines;
    for (size_t i = 0; i < stream.size(); i += step) {
      lines += other.TakeBytes(std::string_view(stream).substr(i, step), 0).to_host;
    }
    EXPECT_EQ(lines, expected) << step;
    EXPECT_EQ(other.counts().lines_dropped, 1) << step;
  }
}

TEST_F(MicroModemHost, MayGiveDataBeforeTheCycle) {
  EXPECT_EQ(AskForOne("CCTXD,1,2,0,aabb"), "CATXD,1,2,0,2");
  EXPECT_EQ(Ask("CCCYC,0,1,2,0,0,1"), (Lines{"CACYC,0,1,2,0,0,1", "CATXP,0"}));
  modems.Run(10);
  EXPECT_EQ(modems.Lines(0), (Lines{"CATXF,0", "CATXP,2", "CATXF,2"}));
  EXPECT_EQ(modems.Lines(1, "CARXD"), (Lines{"CARXD,1,2,0,1,aabb"}));
}

TEST_F(MicroModemHost, IsAskedForTheFramesThatItHasNotGivenBefore) {
  Ask("CCTXD,1,2,0,01");
  EXPECT_EQ(Ask("CCCYC,0,1,2,2,0,2"), (Lines{"CACYC,0,1,2,2,0,2", "CADRQ,022524,1,2,0,64,2"}));
}

TEST_F(MicroModemHost, FindsOldDataForgotten) {
  Ask("CCTXD,1,2,0,01");
  modems.Run(2.5);
  EXPECT_EQ(Ask("CCCYC,0,1,2,2,0,1"), (Lines{"CACYC,0,1,2,2,0,1", "CADRQ,022526,1,2,0,64,1"}));
}

TEST_F(MicroModemHost, IsToldOfEarlyDataThatDoesNotFitTheCycle) {
  Ask("CCTXD,1,3,0,01");
  Ask("CCTXD,1,2,0," + std::string(130, 'a'));
  EXPECT_EQ(Names(Ask("CCCYC,0,1,2,2,0,1")), (Lines{"CACYC", "CAERR", "CAERR", "CADRQ"}));
  for (int i = 0; i < 8; ++i) Ask("CCTXD,1,2,0,01");
}

TEST_F(MicroModemHost, FillsNoMemoryWithEarlyData) {
  for (int i = 0; i < 8; ++i) EXPECT_EQ(AskForOne("CCTXD,1,2,0,01"), "CATXD,1,2,0,1");
  EXPECT_EQ(AskForOne("CCTXD,1,2,0,01"), "CAERR,022524,BUSY,3,frames without a cycle: send CCCYC");
}

TEST_F(MicroModemHost, EndsACycleEarlyWithAnEmptyFrame) {
  Ask("CCCYC,0,1,2,2,0,3");
  Ask("CCTXD,1,2,0,0102");
  EXPECT_EQ(Ask("CCTXD,1,2,0,"), (Lines{"CATXD,1,2,0,0", "CATXP,2"}));
  modems.Run(5);
  EXPECT_EQ(modems.Lines(0), (Lines{"CATXF,2"}));
  EXPECT_EQ(modems.Lines(1, "CACYC"), (Lines{"CACYC,0,1,2,2,0,1"}));
  Ask("CCCYC,0,1,2,2,0,3");
  EXPECT_EQ(Ask("CCTXD,1,2,0,"),
            (Lines{"CATXD,1,2,0,0", "CAERR,022529,CYCLE,4,no data and nothing sent"}));
  EXPECT_FALSE(modem().is_in_a_cycle());
}

TEST_F(MicroModemHost, IsWaitedForOnlySoLong) {
  Ask("CCCYC,0,1,2,2,0,1");
  modems.Run(1.9);
  EXPECT_TRUE(modem().is_in_a_cycle());
  modems.Run(0.2);
  EXPECT_EQ(modems.Lines(0), (Lines{"CAERR,022526,DATA_TIMEOUT,4,no data for frame 1"}));
  EXPECT_FALSE(modem().is_in_a_cycle());
}

TEST_F(MicroModemHost, HasTheFramesSentThatItGaveInTime) {
  Ask("CCCYC,0,1,2,2,0,2");
  Ask("CCTXD,1,2,0,0102");
  modems.Run(5);
  EXPECT_EQ(modems.Lines(0),
            (Lines{"CAERR,022526,DATA_TIMEOUT,4,no data for frame 2", "CATXP,2", "CATXF,2"}));
}

TEST_F(MicroModemHost, MayBeginAnotherCycleInsteadOfGivingData) {
  Ask("CCCYC,0,1,2,2,0,2");
  Ask("CCTXD,1,2,0,0102");
  EXPECT_EQ(Ask("CCCYC,0,1,3,2,1,1"), (Lines{"CAERR,022524,CYCLE,5,given up for another CCCYC",
                                             "CACYC,0,1,3,2,1,1", "CADRQ,022524,1,3,1,64,1"}));
  EXPECT_EQ(AskForOne("CCTXD,1,2,0,01"), "CAERR,022524,NMEA,2,field 2 must be 3");
  EXPECT_EQ(Ask("CCTXD,1,3,1,0304"), (Lines{"CATXD,1,3,1,2", "CATXP,2"}));
}

TEST_F(MicroModemHost, BeginsNoCycleWhileOneIsOnTheAir) {
  Ask("CCCYC,0,1,2,2,0,1");
  Ask("CCTXD,1,2,0,0102");
  EXPECT_EQ(AskForOne("CCCYC,0,1,2,2,0,1"),
            "CAERR,022524,BUSY,3,a cycle is under way: wait for CATXF");
  modems.Run(5);
  EXPECT_EQ(Names(Ask("CCCYC,0,1,2,2,0,1")), (Lines{"CATXF", "CACYC", "CADRQ"}));
}

TEST_F(MicroModemHost, EndsEverythingWithAReboot) {
  Ask("CCCYC,0,1,2,0,0,1");
  Ask("CCMPC,1,2");
  EXPECT_EQ(Ask("CCMSC,1,1,0"), (Lines{"CAMSC,1,1,0", "CAERR,022524,CYCLE,5,given up for CCMSC"}));
  modems.Run(10);
  EXPECT_EQ(Names(modems.Lines(0)), (Lines{"CAREV", "CAREV", "CATXF"}));
  EXPECT_EQ(modems.sent(0).size(), 1U);
}

TEST_F(MicroModemHost, FindsEarlyDataForgottenAfterAReboot) {
  Ask("CCTXD,1,2,0,01");
  Ask("CCMSC,1,1,0");
  EXPECT_EQ(Names(Ask("CCCYC,0,1,2,2,0,1")), (Lines{"CACYC", "CADRQ"}));
}

TEST_F(MicroModemHost, MayBeginACycleWhileThatOfBeforeTheRebootIsOnTheAir) {
  Ask("CCCYC,0,1,2,2,0,1");
  Ask("CCTXD,1,2,0,0102");
  Ask("CCMSC,1,1,0");
  EXPECT_EQ(Names(Ask("CCCYC,0,1,2,2,0,1")), (Lines{"CACYC", "CADRQ"}));
  modems.Run(1);
  EXPECT_EQ(Names(modems.Lines(0)), (Lines{"CAREV", "CAREV", "CATXF"}));
  EXPECT_TRUE(modem().is_in_a_cycle());
  EXPECT_EQ(Names(Ask("CCTXD,1,2,0,0304")), (Lines{"CATXD", "CATXP"}));
}

TEST_F(MicroModemHost, HearsTheEndOfDataThatARebootFindsOnTheAir) {
  Ask("CCCYC,0,1,2,2,0,1");
  Ask("CCTXD,1,2,0,0102");
  EXPECT_EQ(Ask("CCMSC,1,1,0"), (Lines{"CAMSC,1,1,0"}));
  modems.Run(10);
  EXPECT_EQ(Names(modems.Lines(0)), (Lines{"CAREV", "CAREV", "CATXF"}));
}

TEST_F(MicroModemHost, IsToldWhenTooMuchWaitsForTheAir) {
  for (size_t i = 0; i <= MicroModem::kMaxWaiting; ++i) Ask("CCMPC,1,2");
  EXPECT_EQ(AskForOne("CCMPC,1,2"), "CAERR,022524,BUSY,3,too much is waiting for the air");
  EXPECT_EQ(AskForOne("CCMUC,1,2,0001"), "CAERR,022524,BUSY,3,too much is waiting for the air");
}

TEST_F(MicroModemHost, HearsNothingFromTranspondersThatAreNotThere) {
  EXPECT_EQ(AskForOne("CCPDT,1,2,0,0,1383,1,1,1,0"), "SNPDT,1,2,0,0,1383,1,1,1,0");
  modems.Run(2);
  EXPECT_EQ(modems.Lines(0), (Lines{"SNTTA,0.0,0.0,0.0,0.0,022525.38"}));
}

TEST(MicroModemTransponders, AreHeardWhereTheyAnswerInTime) {
  TwoModems modems({.address = 1, .transponder_travel_s = {0.25, {}, 0.75}});
  modems.Give(0, "CCPNT,26000,5,5,1000,25000,0,0,0,1");
  modems.Run(2);
  EXPECT_EQ(modems.Lines(0),
            (Lines{"SNPNT,26000,5,5,1000,25000,0,0,0,1", "SNTTA,0.2500,0.0,0.0,0.0,000001.00"}));
}

}  // namespace shoal::micromodem_host_test
