// Reads acoustic modems from files, data/modems/*.toml; docs/communication/acoustics_models.md has
// their keys.
//
//   LoadedModem loaded = LoadModem("data/modems/nanomodem_v3.toml");
//   if (!loaded.errors.empty()) { print them; exit 2; }
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/toml/fields.h"
#include "lib/sea/acoustics/modem_preset.h"

namespace shoal {

struct LoadedModem {
  ModemPreset modem;                  ///< Usable only where `errors` is empty.
  std::vector<std::string> errors;    ///< "file:line:column: what is wrong", in file order.
  std::vector<std::string> warnings;  ///< The same for what is legal but suspicious.
};

/// Reads `path`.
[[nodiscard]] LoadedModem LoadModem(const std::string& path);

/// The same for text that is already in memory; `name` stands for the file in messages.
[[nodiscard]] LoadedModem LoadModemText(std::string_view text, const std::string& name);

/// The whole file of a modem. Every number must have its source.
void Describe(Fields& file, ModemPreset& modem);

}  // namespace shoal
