#include "lib/run/run/appcast.h"

namespace shoal {

appcast_t ToAppcast(const StatusPage& page, const std::string& app, int64_t utime, int64_t step) {
  appcast_t appcast;
  appcast.utime = utime;
  appcast.app = app;
  appcast.step = step;
  appcast.config_warnings = page.config_warnings;
  appcast.num_config_warnings = static_cast<int32_t>(page.config_warnings.size());
  appcast.run_warnings = page.run_warnings;
  appcast.num_run_warnings = static_cast<int32_t>(page.run_warnings.size());
  appcast.page = page.text;
  return appcast;
}

StatusPage PageOf(const appcast_t& appcast) {
  return {.config_warnings = appcast.config_warnings,
          .run_warnings = appcast.run_warnings,
          .text = appcast.page};
}

}  // namespace shoal
