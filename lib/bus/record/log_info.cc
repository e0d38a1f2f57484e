#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <unordered_map>

#include "lib/base/codec/little_endian.h"
#include "lib/base/schema/text.h"
#include "lib/base/text/terminal_text.h"
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
  std::set<const StructType*> types;  ///< As they are found; at the end their names.
  std::set<std::string> type_names;
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
  std::set<std::string> names = channel.type_names;
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

/// What LogInfo has found in a log.
struct LogInfoFound {
  std::string path;  ///< Of the log, as `damage` has it.
  std::map<std::string, ChannelSummary> channels;
  std::string damage;     ///< What ReportDamage writes.
  bool is_whole = false;  ///< Nothing of it is damaged.
};

constexpr size_t kMaxInfoText_bytes = 100'000;
constexpr size_t kMaxInfoNames = 1000;
constexpr size_t kMaxInfoChannels = 1'000'000;

LogInfoFound ReadInfo(LogReader* reader, const Schema& schema,
                      const std::function<void(double share)>& progress) {
  constexpr int64_t kEventsBetween = 4096;
  std::unordered_map<std::string, ChannelSummary> summaries;
  std::string key;
  for (int64_t i = 1; const auto event = reader->Next(); ++i) {
    key.assign(event->channel);
    Count(schema, *event, &summaries[key]);
    if (progress && i % kEventsBetween == 0) {
      progress(static_cast<double>(event->offset) / static_cast<double>(reader->size()));
    }
  }
  if (progress) progress(1);
  LogInfoFound found;
  found.path = reader->path();
  for (auto& [name, channel] : summaries) {
    for (const StructType* type : channel.types) channel.type_names.insert(DisplayName(*type));
    found.channels.emplace(name, std::move(channel));
  }
  std::ostringstream damage;
  found.is_whole = ReportDamage(*reader, damage) && reader->num_damages() == 0;
  found.damage = damage.str();
  return found;
}

void AppendNames(const std::set<std::string>& names, std::vector<uint8_t>* bytes) {
  AppendLittleEndian(static_cast<uint32_t>(names.size()), bytes);
  for (const std::string& name : names) AppendSizedText(name, bytes);
}

/// Takes a text. It is escaped for the terminal: an index may hold anything.
bool TakeShown(LittleEndianReader* reader, std::string* text) {
  if (!reader->TakeSizedText(text) || text->size() > kMaxInfoText_bytes) return false;
  *text = TerminalText(*text);
  return true;
}

bool TakeNames(LittleEndianReader* reader, std::set<std::string>* names) {
  uint32_t count = 0;
  if (!reader->Take(&count) || count > kMaxInfoNames) return false;
  for (uint32_t i = 0; i < count; ++i) {
    std::string name;
    if (!TakeShown(reader, &name)) return false;
    names->insert(std::move(name));
  }
  return true;
}

std::vector<uint8_t> InfoBytes(const LogInfoFound& found) {
  std::vector<uint8_t> bytes;
  AppendLittleEndian(static_cast<uint8_t>(found.is_whole), &bytes);
  AppendSizedText(found.path, &bytes);
  AppendSizedText(found.damage, &bytes);
  AppendLittleEndian(static_cast<uint32_t>(found.channels.size()), &bytes);
  for (const auto& [name, channel] : found.channels) {
    AppendSizedText(name, &bytes);
    for (const int64_t number : {channel.events, channel.bytes, channel.first_utime,
                                 channel.last_utime, channel.unknown, channel.undecodable}) {
      AppendLittleEndian(number, &bytes);
    }
    AppendNames(channel.type_names, &bytes);
    AppendNames(channel.unknown_types, &bytes);
    AppendSizedText(channel.first_fault, &bytes);
  }
  return bytes;
}

/// Reads what InfoBytes has written; nothing for bytes that InfoBytes cannot have written.
std::optional<LogInfoFound> InfoFrom(std::span<const uint8_t> bytes) {
  constexpr int64_t kMost = std::numeric_limits<int64_t>::max() / int64_t{kMaxInfoChannels};
  LittleEndianReader reader(bytes);
  LogInfoFound found;
  uint8_t is_whole = 0;
  uint32_t count = 0;
  if (!reader.Take(&is_whole) || is_whole > 1 || !reader.TakeSizedText(&found.path) ||
      !TakeShown(&reader, &found.damage) || !reader.Take(&count) || count > kMaxInfoChannels) {
    return std::nullopt;
  }
  found.is_whole = is_whole == 1;
  for (uint32_t i = 0; i < count; ++i) {
    std::string name;
    ChannelSummary channel;
    if (!reader.TakeSizedText(&name) || name.empty() || name.size() > kMaxLogChannelLength) {
      return std::nullopt;
    }
    for (int64_t* number : {&channel.events, &channel.bytes, &channel.first_utime,
                            &channel.last_utime, &channel.unknown, &channel.undecodable}) {
      if (!reader.Take(number)) return std::nullopt;
    }
    for (const int64_t number :
         {channel.events, channel.bytes, channel.unknown, channel.undecodable}) {
      if (number < 0 || number > kMost) return std::nullopt;
    }
    if (!TakeNames(&reader, &channel.type_names) || !TakeNames(&reader, &channel.unknown_types) ||
        !TakeShown(&reader, &channel.first_fault)) {
      return std::nullopt;
    }
    found.channels.emplace(std::move(name), std::move(channel));
  }
  return reader.num_left() == 0 ? std::optional(std::move(found)) : std::nullopt;
}

/// Returns the key of the part in the index: what is counted depends on the types that are known.
std::string InfoKey(const Schema& schema) {
  std::string names;
  for (const StructType& type : schema.types()) {
    names += fmt::format("{} {:x} ", DisplayName(type), type.fingerprint);
  }
  return fmt::format("2 {:016x}",
                     DigestOf({reinterpret_cast<const uint8_t*>(names.data()), names.size()}));
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

  const std::string key = InfoKey(*schema);
  std::optional<LogInfoFound> found;
  if (const auto kept =
          ReadIndexPart(*reader, IndexPart::kInfo, key, options.least_indexed_bytes)) {
    found = InfoFrom(*kept);
    if (found && !found->damage.empty() && found->path != reader->path()) found.reset();
  }
  if (!found) {
    found = ReadInfo(&*reader, *schema, options.progress);
    KeepIndexPart(*reader, IndexPart::kInfo, key, InfoBytes(*found), options.least_indexed_bytes);
  }

  int64_t num_events = 0;
  int64_t first_utime = std::numeric_limits<int64_t>::max();
  int64_t last_utime = std::numeric_limits<int64_t>::min();
  std::map<std::string, const ChannelSummary*> by_name;
  for (const auto& [name, channel] : found->channels) {
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
  err << found->damage;
  return found->is_whole ? kExitOk : kExitEnvironment;
}

}  // namespace shoal
