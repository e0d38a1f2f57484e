// The value of a rule in a message that changes it.
#pragma once

#include "lib/comms/routing/control.h"
#include "shoal/unc_control_t.hpp"

namespace shoal {

[[nodiscard]] inline ControlValue ValueOf(const unc_control_t& control) {
  ControlValue value = control.text;
  value.number = control.value;
  return value;
}

inline void SetValue(const ControlValue& value, unc_control_t* control) {
  control->value = value.number;
  control->text = value.text;
}

}  // namespace shoal
