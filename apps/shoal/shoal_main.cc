// shoal: runs missions, sends commands to them, and reads their logs. See shoal --help.
#include "apps/shoal/shoal_options.h"

int main(int argc, char** argv) { return shoal::RunShoalCommand(argc, argv); }
