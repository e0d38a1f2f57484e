#include "apps/shoal_campaign/campaign_page.h"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <ostream>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/os/text_file.h"
#include "lib/tools/report/report_page.h"

namespace shoal {

int WriteCampaignPage(const CampaignResults& results, const ReportTables& tables,
                      const std::string& dir, const std::string& path, std::ostream& err) {
  std::error_code error;
  std::filesystem::path absolute = std::filesystem::absolute(dir, error).lexically_normal();
  if (!absolute.has_filename()) absolute = absolute.parent_path();  // "runs/" and "runs" are one.
  const std::string shown_dir = error ? dir : absolute.string();
  if (TextFile(path, ReportPage(results, tables, shown_dir)).Flush()) return kExitOk;
  err << fmt::format("shoal: cannot write the page {}: {}; name another file: --html FILE\n", path,
                     ErrnoText(errno));
  return kExitEnvironment;
}

}  // namespace shoal
