#include "lib/mission/netsim/netsim_wire.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/mission/netsim/netsim_testing.h"

namespace shoal::netsim_wire_test {

/// The request of netsim's documentation, without its end.
const std::string kExample =
    "NETSIM|netsim.protobuf.NetSimManagerRequest|"
    "CEISOgiz5AMRQ4tUIbbq10EZQUDRT0vLUUAhQylH7tbMYcApMzMzMzMz0z8x65lyHNEpUj85AAAAAAAALkA=";

NetsimRequest Parsed(const std::string& line) {
  const auto parsed = ParseRequestLine(line);
  EXPECT_TRUE(std::holds_alternative<NetsimRequest>(parsed)) << line;
  return std::holds_alternative<NetsimRequest>(parsed) ? std::get<NetsimRequest>(parsed)
                                                       : NetsimRequest{};
}

NotARequest Refused(const std::string& line) {
  const auto parsed = ParseRequestLine(line);
  EXPECT_TRUE(std::holds_alternative<NotARequest>(parsed)) << line;
  return std::holds_alternative<NotARequest>(parsed) ? std::get<NotARequest>(parsed)
                                                     : NotARequest::kBlank;
}

TEST(ParseRequestLine, ReadsTheExampleOfTheDocumentation) {
  const NetsimRequest request = Parsed(kExample);
  EXPECT_EQ(request.id, 66);
  EXPECT_TRUE(request.is_whole);
  ASSERT_EQ(request.navs.size(), 1U);
  const NetsimNav& nav = request.navs[0];
  EXPECT_EQ(nav.modem_tcp_port, 62003);
  EXPECT_NEAR(nav.time_s, 1605032069.321, 1e-6);
  EXPECT_NEAR(nav.lat_deg, 71.17647166666667, 1e-12);
  EXPECT_NEAR(nav.lon_deg, -142.40123666666668, 1e-12);
  EXPECT_EQ(nav.depth_m, 0.3);
  EXPECT_NEAR(nav.speed_mps, 0.0011086027241532469, 1e-18);
  EXPECT_EQ(nav.heading_deg, 15);
}

TEST(ParseRequestLine, NeedsNoPadding) {
  EXPECT_EQ(Parsed(kExample.substr(0, kExample.size() - 1)).id, 66);
}

TEST(ParseRequestLine, ReportsWhyALineHoldsNoRequest) {
  EXPECT_EQ(Refused(""), NotARequest::kBlank);
  EXPECT_EQ(Refused("hello"), NotARequest::kNoMessage);
  EXPECT_EQ(Refused("A|B"), NotARequest::kNoMessage);
  EXPECT_EQ(Refused("NETSIM|netsim.protobuf.NetSimManagerRequest"), NotARequest::kNoMessage);
  EXPECT_EQ(Refused("netsim" + kExample.substr(6)), NotARequest::kNoMessage);
  EXPECT_EQ(Refused("NETSIM||"), NotARequest::kUnknownMessage);
  EXPECT_EQ(Refused(LineOf({8, 5}, "netsim.protobuf.NetSimManagerResponse")),
            NotARequest::kUnknownMessage);
  EXPECT_EQ(Refused(LineOf({8, 5}, "netsim.protobuf.netsimmanagerrequest")),
            NotARequest::kUnknownMessage);
  EXPECT_EQ(Refused(kExample + "|"), NotARequest::kBadBase64);
  EXPECT_EQ(Refused(kExample + " "), NotARequest::kBadBase64);
  EXPECT_EQ(Refused(LineOf({8})), NotARequest::kBadProtobuf);
  EXPECT_EQ(Refused(LineOf({8, 5, 18, 9})), NotARequest::kBadProtobuf);
  EXPECT_EQ(Refused(LineOf({})), NotARequest::kNoId);
  EXPECT_EQ(Refused(LineOf({18, 0})), NotARequest::kNoId);
}

TEST(ParseRequestLine, NoticesWhatANavLacks) {
  const NetsimRequest request = Parsed(LineOf({8, 5, 18, 0}));
  EXPECT_FALSE(request.is_whole);
  ASSERT_EQ(request.navs.size(), 1U);
  EXPECT_EQ(request.navs[0].modem_tcp_port, 0);
  EXPECT_TRUE(std::isnan(request.navs[0].lat_deg));
  EXPECT_TRUE(std::isnan(request.navs[0].heading_deg));
}

TEST(ParseRequestLine, ReadsStats) {
  const NetsimRequest request = Parsed(LineOf({8, 5, 26, 6, 8, 1, 16, 2, 24, 1}));
  EXPECT_TRUE(request.is_whole);
  ASSERT_EQ(request.stats.size(), 1U);
  EXPECT_EQ(request.stats[0].modem_tcp_port, 1);
  EXPECT_EQ(request.stats[0].tx_modem_tcp_port, 2);
  EXPECT_TRUE(request.stats[0].packet_success);
  EXPECT_FALSE(request.stats[0].modem);
}

/// Varints of the fields of mm_stats that are required, each with its own number as its value.
std::vector<uint8_t> ModemStatistics() {
  std::vector<uint8_t> message;
  for (uint8_t field = 1; field <= 29; ++field) {
    if (field == 4 || (field >= 7 && field <= 12)) continue;
    const bool is_double = field == 26;
    const int key = field * 8 + (is_double ? 1 : 0);
    message.push_back(static_cast<uint8_t>((key & 0x7F) | (key > 0x7F ? 0x80 : 0)));
    if (key > 0x7F) message.push_back(static_cast<uint8_t>(key >> 7));
    if (is_double) {
      message.insert(message.end(), 8, 0);
    } else {
      message.push_back(field);
    }
  }
  return message;
}

NetsimRequest WithModemStatistics(const std::vector<uint8_t>& statistics) {
  std::vector<uint8_t> stats = {8, 1, 16, 2, 24, 1, 34, static_cast<uint8_t>(statistics.size())};
  stats.insert(stats.end(), statistics.begin(), statistics.end());
  std::vector<uint8_t> message = {8, 5, 26, static_cast<uint8_t>(stats.size())};
  message.insert(message.end(), stats.begin(), stats.end());
  return Parsed(LineOf(message));
}

TEST(ParseRequestLine, ReadsTheStatisticsOfAModem) {
  const NetsimRequest request = WithModemStatistics(ModemStatistics());
  EXPECT_TRUE(request.is_whole);
  ASSERT_EQ(request.stats.size(), 1U);
  ASSERT_TRUE(request.stats[0].modem);
  const NetsimModemStats& modem = *request.stats[0].modem;
  EXPECT_EQ(modem.mode, 1);
  EXPECT_EQ(modem.rate, 13);
  EXPECT_EQ(modem.source, 14);
  EXPECT_EQ(modem.destination, 15);
  EXPECT_EQ(modem.num_frames, 18);
  EXPECT_EQ(modem.num_bad_frames, 19);
  EXPECT_EQ(modem.snr_in_db, 21);
  EXPECT_EQ(modem.snr_out_db, 22);
  EXPECT_EQ(modem.mse_equalizer_db, 24);
}

TEST(ParseRequestLine, NoticesWhatStatsLack) {
  EXPECT_FALSE(Parsed(LineOf({8, 5, 26, 4, 8, 1, 16, 2})).is_whole);
  std::vector<uint8_t> statistics = ModemStatistics();
  statistics.erase(statistics.begin(), statistics.begin() + 2);
  EXPECT_FALSE(WithModemStatistics(statistics).is_whole);
}

TEST(ResponseLine, IsOneLineOfBothFields) {
  const std::string front = "NETSIM|netsim.protobuf.NetSimManagerResponse|";
  EXPECT_EQ(ResponseLine(65, NetsimStatus::kAccepted), front + "CEEQAQ==\n");
  EXPECT_EQ(ResponseLine(0, NetsimStatus::kAccepted), front + "CAAQAQ==\n");
  EXPECT_EQ(ResponseLine(-1, NetsimStatus::kOutOfDefinedRegion), front + "CP///////////wEQBA==\n");
}

}  // namespace shoal::netsim_wire_test
