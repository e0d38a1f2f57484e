#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <set>
#include <unordered_map>

#include "lib/base/schema/text.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/message_types.h"

namespace shoal {

namespace {

struct ChannelSummary {
  int64_t events = 0;
  int64_t bytes = 0;
  int64_t first_utime = 0;
  int64_t last_utime = 0;
  std::set<const StructType*> types;
  std::set<std::string> unknown_types;
  int64_t unknown = 0;
  int64_t undecodable = 0;
  std::string first_fault;
};

void Count(const Schema& schema, const LogEvent& event, ChannelSummary* channel) {
  if (channel->events == 0) channel->first_utime = channel->last_utime = event.utime;
  channel->first_utime = std::min(channel->first_utime, event.utime);
  channel->last_utime = std::max(channel->last_utime, event.utime);
  ++channel->events;
  channel->bytes += static_cast<int64_t>(event.data.size());
  const RecognisedMessage message = Recognise(schema, event.data);
  if (message.type == nullptr) {
    constexpr size_t kMaxListed = 4;
    ++channel->unknown;
    if (channel->unknown_types.size() < kMaxListed) {
      channel->unknown_types.insert(DescribeFingerprint(message.data));
    }
    return;
  }
  channel->types.insert(message.type);
  if (message.fault && channel->undecodable++ == 0) {
    channel->first_fault =
        fmt::format("in the event at byte {}: {}", event.offset, message.fault->what);
  }
}

std::string SecondsText(int64_t utime) {
  std::string text;
  AppendSeconds(utime, &text);
  return text;
}

std::string TypeNames(const ChannelSummary& channel) {
  std::set<std::string> names;
  for (const StructType* type : channel.types) names.insert(DisplayName(*type));
  if (channel.unknown > 0) names.insert("?");
  return fmt::format("{}", fmt::join(names, ","));
}

/// Events per second between the first and the last.
std::string RateText(const ChannelSummary& channel) {
  const double span_s =
      (static_cast<double>(channel.last_utime) - static_cast<double>(channel.first_utime)) / 1e6;
  if (span_s <= 0) return "-";
  return fmt::format("{:.3f}", static_cast<double>(channel.events - 1) / span_s);
}

void PrintTable(const std::map<std::string, const ChannelSummary*>& channels, std::ostream& out) {
  size_t channel_width = 7;
  size_t type_width = 4;
  for (const auto& [name, channel] : channels) {
    channel_width = std::max(channel_width, name.size());
    type_width = std::max(type_width, TypeNames(*channel).size());
  }
  out << fmt::format("\n{:<{}}  {:<{}} {:>9} {:>9} {:>11} {:>11} {:>11}\n", "channel",
                     channel_width, "type", type_width, "events", "Hz", "first_s", "last_s",
                     "bytes");
  for (const auto& [name, channel] : channels) {
    out << fmt::format("{:<{}}  {:<{}} {:>9} {:>9} {:>11} {:>11} {:>11}\n", name, channel_width,
                       TypeNames(*channel), type_width, channel->events, RateText(*channel),
                       SecondsText(channel->first_utime), SecondsText(channel->last_utime),
                       channel->bytes);
  }
}

void PrintNotes(const std::map<std::string, const ChannelSummary*>& channels, std::ostream& out) {
  for (const auto& [name, channel] : channels) {
    if (channel->unknown > 0) {
      out << fmt::format("{}: {} events of unknown type, {} (give its .lcm file)\n", name,
                         channel->unknown, fmt::join(channel->unknown_types, ", "));
    }
    if (channel->undecodable > 0) {
      out << fmt::format("{}: {} events do not decode, the first {}\n", name, channel->undecodable,
                         channel->first_fault);
    }
  }
}

}  // namespace

int LogInfo(const LogInfoOptions& options, std::ostream& out, std::ostream& err) {
  const Result<Schema> schema = LoadMessageTypes(options.types);
  if (!schema.ok()) {
    err << schema.error() << '\n';
    return kExitUsage;
  }
  auto reader = OpenLog(options.path, OnDamage::kSkip, err);
  if (!reader) return kExitEnvironment;

  std::unordered_map<std::string, ChannelSummary> summaries;
  std::string key;
  while (const auto event = reader->Next()) {
    key.assign(event->channel);
    Count(*schema, *event, &summaries[key]);
  }

  int64_t num_events = 0;
  int64_t first_utime = std::numeric_limits<int64_t>::max();
  int64_t last_utime = std::numeric_limits<int64_t>::min();
  std::map<std::string, const ChannelSummary*> by_name;
  for (const auto& [name, channel] : summaries) {
    std::string shown;
    AppendQuoted(name, &shown);
    by_name.emplace(shown, &channel);
    num_events += channel.events;
    first_utime = std::min(first_utime, channel.first_utime);
    last_utime = std::max(last_utime, channel.last_utime);
  }
  out << fmt::format("{}: {} events, {} channels, {} bytes", options.path, num_events,
                     by_name.size(), reader->size());
  if (num_events > 0) {
    out << fmt::format(", {} s to {} s", SecondsText(first_utime), SecondsText(last_utime));
  }
  out << '\n';
  if (num_events > 0) PrintTable(by_name, out);
  PrintNotes(by_name, out);
  const bool is_whole = ReportDamage(*reader, err) && reader->num_damages() == 0;
  return is_whole ? kExitOk : kExitEnvironment;
}

}  // namespace shoal
