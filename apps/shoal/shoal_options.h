// The command line of shoal: one subcommand per thing to do, each in a file of its own.
#pragma once

namespace shoal {

/// Parses and executes the command line, returns the exit code.
int RunShoalCommand(int argc, char** argv);

}  // namespace shoal
