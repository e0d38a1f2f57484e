#include "lib/bus/bus/wire_check.h"

#include <gtest/gtest.h>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"

namespace shoal::wire_check_test {

template <class T>
Bytes Encoded(const T& message) {
  Bytes bytes;
  EncodeInto(message, &bytes);
  return bytes;
}

node_report_t Report() {
  node_report_t report{};
  report.name = std::string("alpha");
  report.num_extra = 1;
  report.extra.resize(1);
  report.extra[0].key = std::string("k");
  return report;
}

TEST(WireLengthsAreSane, PassesWholeMessagesOfEveryKind) {
  EXPECT_TRUE(WireLengthsAreSane(nav_t::getHash(), Encoded(nav_t{})));
  EXPECT_TRUE(WireLengthsAreSane(node_report_t::getHash(), Encoded(Report())));
  EXPECT_TRUE(WireLengthsAreSane(comms_fates_t::getHash(), Encoded(comms_fates_t{})));
}

TEST(WireLengthsAreSane, RefusesMessagesThatAreTooShortOrTooLong) {
  for (Bytes bytes : {Encoded(nav_t{}), Encoded(Report())}) {
    const auto fingerprint = static_cast<int64_t>(
        bytes.size() == Encoded(nav_t{}).size() ? nav_t::getHash() : node_report_t::getHash());
    bytes.push_back(0);
    EXPECT_FALSE(WireLengthsAreSane(fingerprint, bytes));
    bytes.pop_back();
    EXPECT_TRUE(WireLengthsAreSane(fingerprint, bytes));
    while (!bytes.empty()) {
      bytes.pop_back();
      EXPECT_FALSE(WireLengthsAreSane(fingerprint, bytes)) << bytes.size();
    }
  }
}

TEST(WireLengthsAreSane, RefusesOtherTypesAndUnknownFingerprints) {
  EXPECT_FALSE(WireLengthsAreSane(nav_t::getHash(), Encoded(actuators_t{})));
  EXPECT_FALSE(WireLengthsAreSane(12345, Encoded(nav_t{})));
}

TEST(Decode, RefusesAFalseArrayLength) {
  comms_fates_t fates;
  Bytes bytes = Encoded(comms_fates_t{});
  ASSERT_TRUE(Decode(bytes, &fates));
  ASSERT_EQ(bytes.size(), 20U);
  bytes[16] = 0x7f;  // num_fates
  EXPECT_FALSE(Decode(bytes, &fates));
  bytes[16] = 0xff;
  EXPECT_FALSE(Decode(bytes, &fates));
}

TEST(Decode, RefusesAStringThatCouldNotBeEncodedAgain) {
  node_report_t report = Report();
  Bytes bytes = Encoded(report);
  ASSERT_TRUE(Decode(bytes, &report));
  ASSERT_EQ(bytes[22], 'p');  // of "alpha", behind fingerprint, utime and the string's length
  bytes[22] = 0;
  EXPECT_FALSE(Decode(bytes, &report));
}

}  // namespace shoal::wire_check_test
