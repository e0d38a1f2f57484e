// What a filter assumes of how its vehicle moves beside what it measures.
#pragma once

namespace shoal {

struct FilterOptions;
struct Remus100;

/// Makes the filter assume how the vehicle's model slides in turns, and how much sway that leaves.
void AssumeMotionOf(const Remus100& auv, FilterOptions* options);

}  // namespace shoal
