#include "lib/run/moos_text/alog.h"

#include <fmt/format.h>

#include <iterator>
#include <span>

#include "lib/bus/bus/channels.h"
#include "lib/run/moos_text/node_report_text.h"
#include "lib/run/moos_text/numbers.h"

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

LogLines NodeReportsAsAlog() {
  const auto append = [](int64_t event_utime, std::string_view channel,
                         std::span<const uint8_t> message, std::string* out) {
    node_report_t report;
    if (report.decode(message.data(), 0, static_cast<int>(message.size())) < 0) return;
    AppendAlogLine(event_utime, channel, report, out);
  };
  return {.type = "node_report_t", .extension = ".alog", .header = AlogHeader(), .append = append};
}

}  // namespace shoal
