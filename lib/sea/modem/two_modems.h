// Two Micro-Modems in water that the test rules, and their hosts' eyes and mouths.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lib/sea/modem/micromodem.h"

namespace shoal {

class TwoModems {
 public:
  static constexpr int64_t kTick_us = 10'000;

  explicit TwoModems(MicroModemOptions first = {.address = 1},
                     MicroModemOptions second = {.address = 2})
      : modems_{MicroModem(first), MicroModem(second)} {}

  int64_t travel_us = 400'000;
  std::optional<double> snr_db = {};
  /// May change the bytes of a packet; returns false to lose it.
  std::function<bool(int from, std::vector<uint8_t>* bytes)> water = [](int, auto*) {
    return true;
  };

  MicroModem& modem(int index) { return modems_[static_cast<size_t>(index)]; }
  int64_t now_us() const { return now_us_; }
  /// All that each has sent, in order.
  const std::vector<MicroModemSent>& sent(int index) const {
    return sent_[static_cast<size_t>(index)];
  }

  /// The host of this modem writes "CCMPC,1,2".
  void Give(int index, const std::string& body) {
    Pass(index, modem(index).Take(NmeaSentence(body), now_us_));
    Pass(index, modem(index).Transmit(now_us_));
  }

  void Run(double duration_s) {
    const int64_t end_us = now_us_ + static_cast<int64_t>(duration_s * 1e6);
    while (now_us_ < end_us) {
      now_us_ += kTick_us;
      for (int index : {0, 1}) Pass(index, modem(index).Transmit(now_us_));
      Deliver();
    }
  }

  /// Returns what the modem has written since the last call: bodies, without checksum.
  std::vector<std::string> Lines(int index) {
    return std::exchange(lines_[static_cast<size_t>(index)], {});
  }

  /// Returns the same, of sentences with this address only: "CAACK".
  std::vector<std::string> Lines(int index, const std::string& address) {
    std::vector<std::string> lines = Lines(index);
    std::erase_if(lines, [&](const std::string& line) { return !line.starts_with(address); });
    return lines;
  }

 private:
  struct UnderWay {
    int to = 0;
    std::vector<uint8_t> bytes;
    int64_t start_us = 0;
    int64_t end_us = 0;
  };

  void Pass(int index, const MicroModemOutput& output) {
    size_t begin = 0;
    for (size_t end; (end = output.to_host.find("\r\n", begin)) != std::string::npos;) {
      const std::string line = output.to_host.substr(begin, end - begin);
      EXPECT_TRUE(ParseNmea(line) && ParseNmea(line)->has_checksum) << line;
      lines_[static_cast<size_t>(index)].push_back(line.substr(1, line.find('*') - 1));
      begin = end + 2;
    }
    EXPECT_EQ(begin, output.to_host.size()) << "each sentence ends with CR and LF";
    for (const MicroModemSent& sent : output.to_water) Transmit(index, sent);
  }

  void Transmit(int from, const MicroModemSent& sent) {
    auto& all = sent_[static_cast<size_t>(from)];
    int64_t& free_us = free_us_[static_cast<size_t>(from)];
    EXPECT_GE(now_us_, free_us) << "a second packet while one is on the air";
    EXPECT_GT(sent.air_us, 0);
    free_us = now_us_ + sent.air_us;
    all.push_back(sent);
    std::vector<uint8_t> bytes = sent.bytes;
    if (!water(from, &bytes)) return;
    const int64_t start_us = now_us_ + travel_us;
    under_way_.push_back({1 - from, std::move(bytes), start_us, start_us + sent.air_us});
  }

  void Deliver() {
    std::vector<UnderWay> arrived;
    std::erase_if(under_way_, [&](const UnderWay& packet) {
      if (packet.end_us > now_us_) return false;
      arrived.push_back(packet);
      return true;
    });
    for (const UnderWay& packet : arrived) {
      const MicroModemArrival arrival = {.bytes = packet.bytes,
                                         .start_us = packet.start_us,
                                         .travel_us = travel_us,
                                         .snr_db = snr_db};
      Pass(packet.to, modem(packet.to).Receive(arrival, now_us_));
      Pass(packet.to, modem(packet.to).Transmit(now_us_));
    }
  }

  std::array<MicroModem, 2> modems_;
  std::array<std::vector<std::string>, 2> lines_;
  std::array<std::vector<MicroModemSent>, 2> sent_;
  std::array<int64_t, 2> free_us_ = {};
  std::vector<UnderWay> under_way_;
  int64_t now_us_ = 0;
};

/// Returns the sentences' names: CARXP, CACYC ...
inline std::vector<std::string> Names(const std::vector<std::string>& lines) {
  std::vector<std::string> names;
  for (const std::string& line : lines) names.push_back(line.substr(0, line.find(',')));
  return names;
}

/// Returns the fields of a sentence, its name first.
inline std::vector<std::string> FieldsOf(const std::string& line) {
  const auto sentence = ParseNmea("$" + line);
  if (!sentence) return {};
  std::vector<std::string> fields = {sentence->address};
  fields.insert(fields.end(), sentence->fields.begin(), sentence->fields.end());
  return fields;
}

}  // namespace shoal
