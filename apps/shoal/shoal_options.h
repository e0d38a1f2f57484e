// The command line of shoal: its subcommands are in files of their own.
#pragma once

namespace shoal {

/// Parses and executes the command line, returns the exit code.
int RunShoalCommand(int argc, char** argv);

}  // namespace shoal
