// The mission file's words for where a part comes from.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "lib/mission/model/mission.h"

namespace shoal {

constexpr std::array<std::pair<std::string_view, Provider>, 3> kProviders = {{
    {"shoal", Provider::kShoal},
    {"hand", Provider::kHand},
    {"none", Provider::kNone},
}};

}  // namespace shoal
