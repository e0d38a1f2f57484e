// The recorder. Subscribes to everything, writes one log in mission time. See recorder --help.
#include "apps/recorder/recorder_app.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

const AppInfo kInfo = {
    .name = "recorder",
    .purpose = "Records a mission: every message, none missing, in mission time.",
    .per_vehicle = false,
    .example =
        "# The recorder has no block in the mission file; start it with\n"
        "#   shoal run FILE --record DIR\n",
};

}  // namespace

int RunRecorder(int argc, char** argv) {
  return RunMissionApp(kInfo, argc, argv, [](const auto& mission, auto& bus, const auto& options) {
    return std::make_unique<RecorderApp>(RecorderOptions{.path = options.log_path,
                                                         .start_utime = mission.start_utime,
                                                         .channels = options.log_channels},
                                         bus);
  });
}

}  // namespace shoal
