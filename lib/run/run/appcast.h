// A status page as the message that carries it.
#pragma once

#include <cstdint>
#include <string>

#include "lib/run/run/status_page.h"
#include "shoal/appcast_t.hpp"

namespace shoal {

[[nodiscard]] appcast_t ToAppcast(const StatusPage& page, const std::string& app, int64_t utime,
                                  int64_t step);

/// Returns the page that ToAppcast was given.
[[nodiscard]] StatusPage PageOf(const appcast_t& appcast);

}  // namespace shoal
