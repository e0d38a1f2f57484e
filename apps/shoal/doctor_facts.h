// Gathers the facts that `shoal doctor` judges: the only part of it that accesses the machine.
#pragma once

#include "apps/shoal/doctor.h"

namespace shoal {

/// Gathers all facts. Claims the ports of a mission for the rest of this process's life.
[[nodiscard]] DoctorFacts CollectDoctorFacts();

}  // namespace shoal
