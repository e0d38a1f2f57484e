#include "lib/tools/moos/alog.h"

#include <fmt/format.h>

#include <iterator>

#include "lib/bus/bus/channels.h"
#include "lib/tools/moos/node_report_text.h"
#include "lib/tools/moos/numbers.h"

namespace shoal {
namespace {

/// Blanks separate the columns, so that none may have any.
std::string Column(std::string_view text) {
  std::string column(text);
  for (char& c : column) {
    if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7F) c = '_';
  }
  return column;
}

std::string_view SourceOf(std::string_view channel) {
  if (channel == topics::kNodeReportLocal) return "node_reporter";
  if (channel == topics::kNodeReportUnc) return "shore_broker";
  if (!VehicleOfChannel(channel, topics::kNodeReport).empty()) return "shore_broker";
  return "outside";
}

}  // namespace

std::string AlogHeader() {
  const std::string rule(72, '%');
  return rule + "\n%% LOGSTART        0\n" + rule + "\n";
}

void AppendAlogLine(int64_t event_utime, std::string_view channel, const node_report_t& report,
                    std::string* out) {
  fmt::format_to(std::back_inserter(*out), "{:<15} {:<20} {:<20} {}\n", SecondsText(event_utime),
                 Column(channel), SourceOf(channel), FormatNodeReport(report));
}

}  // namespace shoal
