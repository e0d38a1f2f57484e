// shoal-play, which `shoal play` becomes: publishes a recording on LCM.
#include "apps/shoal_play/play_options.h"
#include "lib/run/command_line/tool_commands.h"

int main(int argc, char** argv) {
  return shoal::RunToolCommand("play", argc, argv, shoal::AddPlayOptions);
}
