// Modems as files, for tests only.
#pragma once

#include <string>

#include "lib/mission/file/load_modem.h"
#include "lib/mission/toml/table_writer.h"

namespace shoal {

/// Returns the modem as a file of its own. Loading that text gives an equal modem.
inline std::string ModemFileOf(const ModemPreset& modem) {
  TableWriter writer;
  ModemPreset copy = modem;
  Describe(writer, copy);
  return writer.TakeText();
}

}  // namespace shoal
