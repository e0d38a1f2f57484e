// Which way the file of a track counts depths, as a mission file has it and the readers take it.
#pragma once

namespace shoal {

/// Which way a file counts what it has of the vertical.
enum class DepthPositive {
  kByForm,  ///< Columns of a table down, <ele> of GPX up.
  kDown,
  kUp,
};

}  // namespace shoal
