// What holds for a Micro-Modem whatever its host and the network send. TwoModems itself checks
// that no packet begins while another of the same modem is on the air.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lib/sea/modem/two_modems.h"

namespace shoal::micromodem_property_test {

using Bytes = std::vector<uint8_t>;

std::string Digits(int low, int high) { return std::to_string(*rc::gen::inRange(low, high)); }

/// Something that a host of modem `own` might write, mostly sensible.
std::string AnySentence(int own) {
  const std::string from = std::to_string(own);
  const std::string addresses = from + "," + Digits(0, 4);
  switch (*rc::gen::inRange(0, 8)) {
    case 0:
      return "CCCYC,0," + addresses + "," + Digits(0, 7) + "," + Digits(0, 2) + "," + Digits(0, 4);
    case 1:
    case 2:
      return "CCTXD," + addresses + "," + Digits(0, 2) + "," +
             std::string(2 * *rc::gen::inRange<size_t>(0, 65), 'a');
    case 3:
      return "CCMPC," + addresses;
    case 4:
      return "CCMUC," + addresses + ",0" + Digits(100, 1000);
    case 5:
      return "CCMSC," + from + "," + from + ",0";
    case 6:
      return "CCCFG," + *rc::gen::element<std::string>("DTO", "PTO", "CST", "TXP") + "," +
             Digits(0, 4);
    default:
      return "CC" + *rc::gen::container<std::string>(rc::gen::inRange('!', '#')) + "," +
             Digits(0, 10);
  }
}

RC_GTEST_PROP(MicroModemProperty, EveryCycleThatIsAcceptedEndsInTime, ()) {
  TwoModems modems;
  modems.water = [](int, std::vector<uint8_t>* bytes) {
    if (*rc::gen::inRange(0, 4) == 0) return false;
    if (*rc::gen::inRange(0, 4) == 0) {
      (*bytes)[*rc::gen::inRange<size_t>(0, bytes->size())] ^= *rc::gen::arbitrary<uint8_t>();
    }
    return true;
  };
  modems.Give(0, "CCCFG,TXF,1");
  const int num_sentences = *rc::gen::inRange(1, 15);
  int64_t num_cycles = 0;
  int64_t num_ends = 0;
  const auto count = [&] {
    for (const std::string& line : modems.Lines(0)) {
      // A packet of a cycle that was received has "CACYC,0,2,...".
      if (line.starts_with("CACYC,0,1,")) ++num_cycles;
      const bool is_end_of_data = line.starts_with("CATXF,") && line != "CATXF,0";
      if (is_end_of_data || line.find(",CYCLE,") != std::string::npos ||
          line.find("DATA_TIMEOUT,4,no data for frame 1") != std::string::npos) {
        ++num_ends;
      }
    }
  };
  for (int i = 0; i < num_sentences; ++i) {
    const int host = *rc::gen::inRange(0, 2);
    modems.Give(host, AnySentence(host + 1));
    if (*rc::gen::arbitrary<bool>()) modems.Run(*rc::gen::inRange(0, 30) / 10.0);
    count();
  }
  modems.Run(60);  // Longer than DTO, the waiting packets and the data take together.
  count();
  RC_ASSERT(num_ends == num_cycles);
  for (int i : {0, 1}) {
    RC_ASSERT(!modems.modem(i).is_in_a_cycle());
    RC_ASSERT(!modems.modem(i).is_on_the_air());
    RC_ASSERT(!modems.modem(i).NextEvent_us());
    const MicroModemCounts& counts = modems.modem(i).counts();
    RC_ASSERT(counts.sent == std::ssize(modems.sent(i)));
  }
}

RC_GTEST_PROP(MicroModemProperty, AnyBytesFromTheHostAreTaken, ()) {
  const auto bytes =
      *rc::gen::container<std::string>(rc::gen::weightedElement<char>({{3, '$'},
                                                                       {3, ','},
                                                                       {3, '\r'},
                                                                       {2, 'C'},
                                                                       {1, 'F'},
                                                                       {1, 'G'},
                                                                       {1, '*'},
                                                                       {1, '0'},
                                                                       {1, '\0'},
                                                                       {1, '\xFF'}}));
  MicroModem modem({.address = 1});
  const auto output = modem.TakeBytes(bytes, 0);
  RC_ASSERT(modem.Transmit(0).to_water.empty());
  RC_ASSERT(output.to_host.empty() || output.to_host.ends_with("\r\n"));
}

RC_GTEST_PROP(MicroModemProperty, AnyBytesFromTheWaterAreCountedOnce, (Bytes bytes)) {
  if (!bytes.empty() && *rc::gen::arbitrary<bool>()) bytes[0] = 0x4D;
  MicroModem modem({.address = 1});
  const auto output = modem.Receive({.bytes = bytes,
                                     .start_us = *rc::gen::arbitrary<int64_t>(),
                                     .travel_us = *rc::gen::arbitrary<int64_t>()},
                                    *rc::gen::inRange<int64_t>(0, 1'000'000'000));
  const MicroModemCounts& counts = modem.counts();
  RC_ASSERT(counts.understood + counts.foreign + counts.damaged_headers + counts.own +
                counts.overheard + counts.no_cycle ==
            1);
  RC_ASSERT(output.to_host.empty() == (counts.understood == 0));
}

RC_GTEST_PROP(MicroModemProperty, IsTheSameHoweverOftenItIsAdvanced, ()) {
  MicroModem often({.address = 1});
  MicroModem seldom({.address = 1});
  std::string told_often;
  std::string told_seldom;
  const auto pass = [](const MicroModemOutput& output, std::string* lines) {
    *lines += output.to_host;
  };
  // One thing at a time, so that nothing waits for the air: packets start when their owner looks.
  int64_t now_us = 0;
  for (const char* line : {"$CCPDT,1,2,0,0,1383,1,1,1,0", "$CCCYC,0,1,2,2,0,1", "$CCTMQ,0"}) {
    pass(often.Take(line, now_us), &told_often);
    pass(seldom.Take(line, now_us), &told_seldom);
    const int64_t end_us = now_us + *rc::gen::inRange<int64_t>(0, 4'000'000);
    while (now_us < end_us) {
      now_us += 10'000;
      pass(often.Transmit(now_us), &told_often);
    }
    pass(seldom.Transmit(now_us), &told_seldom);
  }
  RC_ASSERT(told_often == told_seldom);
}

}  // namespace shoal::micromodem_property_test
