#include "lib/sea/modem/micromodem_settings.h"

#include <array>
#include <string>

#include "lib/sea/modem/micromodem_rate.h"
#include "lib/sea/modem/sentence_text.h"

namespace shoal {
namespace {

struct Key {
  std::string_view name;
  int MicroModemSettings::*value;
  int low;
  int high;
};

// In the order in which a modem lists them.
constexpr std::array<Key, 14> kKeys = {{
    {"SRC", &MicroModemSettings::src, 0, kMaxMicroModemAddress},
    {"CST", &MicroModemSettings::cst, 0, 1},
    {"XST", &MicroModemSettings::xst, 0, 1},
    {"REV", &MicroModemSettings::rev, 0, 1},
    {"RXP", &MicroModemSettings::rxp, 0, 1},
    {"TAT", &MicroModemSettings::tat, 0, 100'000},
    {"BND", &MicroModemSettings::bnd, 0, 7},
    {"CTO", &MicroModemSettings::cto, 1, 3600},
    {"DTO", &MicroModemSettings::dto, 1, 3600},
    {"PTO", &MicroModemSettings::pto, 1, 3600},
    {"AGC", &MicroModemSettings::agc, 0, 100'000},
    {"AGN", &MicroModemSettings::agn, 0, 100'000},
    {"TXP", &MicroModemSettings::txp, 0, 1},
    {"TXF", &MicroModemSettings::txf, 0, 1},
}};

std::string SetOtherKey(std::string_view key, std::string_view value,
                        MicroModemSettings* settings) {
  const size_t max_bytes = MicroModemSettings::kMaxTextBytes;
  if (key.empty()) return "field 1 must be a key, as SRC";
  if (key.size() > max_bytes || value.size() > max_bytes) {
    return "key and value have at most " + std::to_string(max_bytes) + " letters";
  }
  auto& others = settings->others;
  const std::string name(key);
  if (!others.contains(name) && others.size() >= MicroModemSettings::kMaxOtherKeys) {
    return "no room for more keys: CCCFG ALL 0 forgets them";
  }
  others[name] = value;
  return {};
}

}  // namespace

std::string SetMicroModemKey(std::string_view key, std::string_view value, int first_address,
                             MicroModemSettings* settings) {
  if (key == "ALL") {
    if (value != "0") return "ALL takes only 0";
    *settings = {};
    settings->src = first_address;
    return {};
  }
  for (const Key& known : kKeys) {
    if (known.name != key) continue;
    const auto number = ParseDigits(value);
    if (!number || *number < known.low || *number > known.high) {
      return std::string(key) + " takes " + std::to_string(known.low) + " to " +
             std::to_string(known.high);
    }
    settings->*known.value = *number;
    return {};
  }
  return SetOtherKey(key, value, settings);
}

std::vector<std::pair<std::string, std::string>> FindMicroModemKeys(
    std::string_view key, const MicroModemSettings& settings) {
  const bool wants_all = key == "ALL" || key == "TOP";
  std::vector<std::pair<std::string, std::string>> found;
  for (const Key& known : kKeys) {
    if (wants_all || known.name == key) {
      found.emplace_back(known.name, std::to_string(settings.*known.value));
    }
  }
  for (const auto& [name, value] : settings.others) {
    if (wants_all || name == key) found.emplace_back(name, value);
  }
  return found;
}

}  // namespace shoal
