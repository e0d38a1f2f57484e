// A command that went out of the viewer, and what became of it.
#pragma once

#include <cstdint>
#include <string>

namespace shoal {

struct CommandRecord {
  int64_t id = 0;
  double t_s = 0;      ///< Mission time when it was sent.
  std::string text;    ///< "return to alpha"
  std::string state;   ///< sent, taken or refused
  std::string reason;  ///< Why it was refused.
};

}  // namespace shoal
