// The recorded dialogue of Goby's Micro-Modem driver, in a form that another modem's can be
// compared with.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "lib/sea/modem/two_modems.h"

namespace shoal {

/// The ports of the two modems in netsim/micromodem_mm1.json.
inline constexpr int kRecordedPorts[] = {62000, 62001};

/// Returns a line without what a clock or an acoustic model decides. Of CACST there remain mode,
/// clock mode, rate, addresses, PSK error, packet type, frames and bad frames, and their places.
inline std::string ComparableLine(const std::string& line) {
  std::vector<std::string> fields = FieldsOf(line);
  static const std::regex clock(R"(\d{6}(\.\d{2,4})?)");
  static const std::regex number(R"(-?\d+(\.\d+)?)");
  std::string text;
  for (size_t i = 0; i < fields.size(); ++i) {
    const bool is_measured = fields[0] == "CACST" && ((i > 3 && i < 13) || i > 19);
    if (is_measured) {
      EXPECT_TRUE(std::regex_match(fields[i], number)) << line;
      fields[i] = "measured";
    } else if (std::regex_match(fields[i], clock)) {
      fields[i] = "clock";
    }
    text += (i == 0 ? "" : ",") + fields[i];
  }
  return text;
}

/// Returns the sentence of a recorded line, without $ and checksum.
inline std::string RecordedBody(const nlohmann::json& row) {
  const auto line = row["line"].get<std::string>();
  return line.substr(1, line.find('*') - 1);
}

}  // namespace shoal
