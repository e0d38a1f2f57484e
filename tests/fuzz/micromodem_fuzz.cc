// A Micro-Modem, for any bytes from its host and from the water: it must not crash, must write
// readable sentences and send one packet at a time.
//
// An input is made of pieces: a byte of choices, a length, a byte, and that number of bytes.
// Choices modulo 4: the host's bytes; bytes from the water; the same with a header that is right;
// time, its length in tenths of a second. All of it goes to a raw modem too.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/check.h"
#include "lib/base/codec/crc32.h"
#include "lib/base/codec/nmea_sentence.h"
#include "lib/sea/modem/micromodem.h"
#include "lib/sea/modem/raw_modem.h"

namespace shoal {
namespace {

class Owner {
 public:
  void TakePiece(uint8_t choices, std::span<const uint8_t> bytes) {
    switch (choices % 4) {
      case 0:
        Check(
            modem_.TakeBytes({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, now_us_));
        break;
      case 1:
        Receive(bytes);
        break;
      case 2:
        Receive(WithRightHeader(bytes));
        break;
      default:
        now_us_ += static_cast<int64_t>(bytes.size()) * 100'000;
        Check(modem_.Advance(now_us_));
        break;
    }
    Check(modem_.Transmit(now_us_));
  }

  void CheckTheEnd() {
    now_us_ += int64_t{20'000} * 1'000'000;  // Timeouts are at most an hour.
    while (modem_.is_on_the_air() || modem_.is_in_a_cycle()) {
      SHOAL_CHECK(modem_.NextEvent_us().has_value(), "what has begun will end");
      now_us_ = std::max(now_us_, *modem_.NextEvent_us());
      Check(modem_.Transmit(now_us_));
    }
  }

 private:
  void Receive(std::span<const uint8_t> bytes) {
    Check(modem_.Receive({.bytes = bytes, .start_us = now_us_, .travel_us = 400'000}, now_us_));
  }

  static std::vector<uint8_t> WithRightHeader(std::span<const uint8_t> bytes) {
    std::vector<uint8_t> packet(bytes.begin(), bytes.end());
    packet.resize(std::max<size_t>(packet.size(), 40));
    packet[0] = 0x4D;
    const bool is_data = packet[1] >> 4 == static_cast<uint8_t>(MicroModemKind::kData);
    const size_t length = 7 + (is_data ? 2 * (packet[4] & 0xFU) : 0U);
    const uint32_t checksum = Crc32(std::span<const uint8_t>(packet).first(length));
    packet[length] = static_cast<uint8_t>(checksum & 0xFF);
    packet[length + 1] = static_cast<uint8_t>(checksum >> 8 & 0xFF);
    return packet;
  }

  void Check(const MicroModemOutput& output) {
    std::string_view rest = output.to_host;
    while (!rest.empty()) {
      const size_t end = rest.find("\r\n");
      SHOAL_CHECK(end != rest.npos, "each sentence ends with CR and LF");
      const auto sentence = ParseNmea(rest.substr(0, end));
      SHOAL_CHECK(sentence && sentence->has_checksum, "every sentence to the host can be read");
      rest.remove_prefix(end + 2);
    }
    SHOAL_CHECK(output.to_water.size() <= 1, "one packet at a time");
    for (const MicroModemSent& sent : output.to_water) {
      SHOAL_CHECK(now_us_ >= free_us_ && sent.air_us > 0, "no packet begins while one is sent");
      free_us_ = now_us_ + sent.air_us;
      MicroModemPacket packet;
      SHOAL_CHECK(DecodeMicroModemPacket(sent.bytes, &packet) == MicroModemVerdict::kUnderstood,
                  "modems understand each other");
    }
  }

  MicroModem modem_{{.address = 1}};
  int64_t now_us_ = 0;
  int64_t free_us_ = 0;
};

}  // namespace
}  // namespace shoal

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::span<const uint8_t> input(data, size);
  shoal::RawModemReader raw({.max_bytes = 100});
  for (const std::vector<uint8_t>& payload : raw.Take(input)) {
    SHOAL_CHECK(!payload.empty() && payload.size() <= 100, "payloads are within the limit");
  }
  shoal::Owner owner;
  while (input.size() >= 2) {
    const uint8_t choices = input[0];
    const size_t length = std::min<size_t>(input[1], input.size() - 2);
    owner.TakePiece(choices, input.subspan(2, length));
    input = input.subspan(2 + length);
  }
  owner.CheckTheEnd();
  return 0;
}
