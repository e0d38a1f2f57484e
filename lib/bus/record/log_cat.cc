#include <fmt/format.h>

#include <ostream>
#include <set>

#include "lib/base/schema/text.h"
#include "lib/bus/record/event_line.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/message_types.h"

namespace shoal {

std::string EventLine(const Schema& schema, const LogEvent& event) {
  std::string line;
  AppendSeconds(event.utime, &line);
  line += ' ';
  AppendQuoted(event.channel, &line);
  Bytes storage;
  const RecognisedMessage message = RecogniseAsList(schema, event.data, &storage);
  if (message.type == nullptr) {
    return line +
           fmt::format(" ? ({}, {} bytes)", DescribeFingerprint(message.data), message.data.size());
  }
  line += ' ' + DisplayName(*message.type);
  if (message.fault) {
    return line + fmt::format(" ? (does not decode at byte {} of {}: {})", message.fault->offset,
                              message.data.size(), message.fault->what);
  }
  const bool repeats_time = UtimeOf(message) == event.utime;
  const std::string text =
      MessageText(schema, *message.type, message.data, repeats_time ? "utime" : "");
  return text.empty() ? line : line + ' ' + text;
}

int LogCat(const LogCatOptions& options, std::ostream& out, std::ostream& err) {
  const Result<Schema> schema = LoadMessageTypes(options.types);
  if (!schema.ok()) {
    err << schema.error() << '\n';
    return kExitUsage;
  }
  auto reader = OpenLog(options.path, options.skip_damage ? OnDamage::kSkip : OnDamage::kStop, err);
  if (!reader) return kExitEnvironment;
  int64_t num_lines = 0;
  bool is_read_to_end = false;
  std::set<std::string, std::less<>> channels;
  while (out && (!options.limit || num_lines < *options.limit)) {
    const auto event = reader->Next();
    is_read_to_end = !event;
    if (!event) break;
    if (!channels.contains(event->channel)) channels.emplace(event->channel);
    if (!IsSelected(options.selection, *event)) continue;
    out << EventLine(*schema, *event) << '\n';
    ++num_lines;
  }
  if (!ReportDamage(*reader, err)) return kExitEnvironment;
  if (!is_read_to_end) return kExitOk;
  return ReportUnmatched(*reader, options.selection, channels, err) ? kExitOk : kExitUsage;
}

}  // namespace shoal
