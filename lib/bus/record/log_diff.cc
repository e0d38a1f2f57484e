#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <utility>

#include "lib/base/schema/text.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/event_line.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/message_types.h"

namespace shoal {

namespace {

/// Events per channel: of the first and of the second log.
using Counts = std::map<std::string, std::pair<int64_t, int64_t>, std::less<>>;

bool AreEqual(const Schema& schema, const LogEvent& a, const LogEvent& b) {
  if (a.utime != b.utime || a.channel != b.channel) return false;
  if (std::ranges::equal(a.data, b.data)) return true;
  Bytes storage_a;
  Bytes storage_b;
  return std::ranges::equal(RecogniseAsList(schema, a.data, &storage_a).data,
                            RecogniseAsList(schema, b.data, &storage_b).data);
}

bool IsLeftOut(const LogDiffOptions& options, std::string_view channel) {
  return std::ranges::any_of(options.without, [&](const std::string& glob) {
    return Matches(glob, std::string(channel));
  });
}

/// Notes the arithmetic that a log was computed with, which its first COMMS_RULES states.
void TakeArithmetic(const LogEvent& event, std::string* arithmetic) {
  if (!arithmetic->empty() || event.channel != topics::kCommsRules) return;
  if (broker_rules_t rules{}; Decode(event.data, &rules)) *arithmetic = rules.arithmetic;
}

/// Where two messages of one channel and time differ.
struct FieldDifference {
  std::string field;
  std::string a;
  std::string b;
};

std::string ByteText(std::span<const uint8_t> data, size_t at) {
  return at < data.size() ? fmt::format("0x{:02x}", data[at]) : "(ends)";
}

FieldDifference FindDifference(const Schema& schema, const LogEvent& event_a,
                               const LogEvent& event_b) {
  Bytes storage_a;
  Bytes storage_b;
  const RecognisedMessage a = RecogniseAsList(schema, event_a.data, &storage_a);
  const RecognisedMessage b = RecogniseAsList(schema, event_b.data, &storage_b);
  if (a.IsDecodable() && b.IsDecodable()) {
    if (a.type != b.type) return {"type", DisplayName(*a.type), DisplayName(*b.type)};
    const std::vector<Leaf> leaves_a = Leaves(schema, *a.type, a.data);
    const std::vector<Leaf> leaves_b = Leaves(schema, *b.type, b.data);
    // Arrays of different lengths differ in the length already, which is before them.
    for (size_t i = 0; i < std::min(leaves_a.size(), leaves_b.size()); ++i) {
      if (leaves_a[i].text != leaves_b[i].text) {
        return {DisplayName(*a.type) + " " + leaves_a[i].path, leaves_a[i].text, leaves_b[i].text};
      }
    }
  }
  const auto [at_a, at_b] = std::ranges::mismatch(a.data, b.data);
  const auto at = static_cast<size_t>(at_a - a.data.begin());
  return {fmt::format("byte {} of the message", at), ByteText(a.data, at), ByteText(b.data, at)};
}

/// Writes the values of both logs under one another, each behind its file's name.
void PrintBoth(const LogDiffOptions& options, const std::string& a, const std::string& b,
               std::ostream& out) {
  const size_t width = std::max(options.path_a.size(), options.path_b.size()) + 1;
  out << fmt::format("  {:<{}} {}\n  {:<{}} {}\n", options.path_a + ":", width, a,
                     options.path_b + ":", width, b);
}

void PrintDifference(const Schema& schema, const LogDiffOptions& options, int64_t step,
                     const std::optional<LogEvent>& a, const std::optional<LogEvent>& b,
                     std::ostream& out) {
  const LogEvent& event = a ? *a : *b;
  std::string place = fmt::format("step {}, ", step);
  AppendSeconds(event.utime, &place);
  place += " s";
  if (a && b && a->utime == b->utime && a->channel == b->channel) {
    place += ", ";
    AppendQuoted(event.channel, &place);
    const FieldDifference difference = FindDifference(schema, *a, *b);
    out << "first difference: " << place << ", " << difference.field << '\n';
    PrintBoth(options, difference.a, difference.b, out);
    return;
  }
  const auto line = [&](const std::optional<LogEvent>& each) {
    return each ? EventLine(schema, *each) : "(ends here)";
  };
  out << "first difference: " << place << ", "
      << (a && b ? "other messages follow" : "one log ends") << '\n';
  PrintBoth(options, line(a), line(b), out);
}

void PrintCounts(const LogDiffOptions& options, const Counts& counts, std::ostream& out) {
  bool is_any_unlike = false;
  for (const auto& [channel, count] : counts) {
    if (count.first == count.second) continue;
    if (!is_any_unlike) out << "different numbers of events:\n";
    is_any_unlike = true;
    std::string shown;
    AppendQuoted(channel, &shown);
    out << fmt::format("  {}: {} in {}, {} in {}\n", shown, count.first, options.path_a,
                       count.second, options.path_b);
  }
  if (!is_any_unlike) out << "every channel has the same number of events in both logs\n";
}

}  // namespace

int LogDiff(const LogDiffOptions& options, std::ostream& out, std::ostream& err) {
  const Result<Schema> schema = LoadMessageTypes(options.types);
  if (!schema.ok()) {
    err << schema.error() << '\n';
    return kExitUsage;
  }
  auto reader_a = OpenLog(options.path_a, OnDamage::kStop, err);
  auto reader_b = OpenLog(options.path_b, OnDamage::kStop, err);
  if (!reader_a || !reader_b) return kExitEnvironment;

  Counts counts;
  int64_t num_events = 0;
  int64_t num_steps = 0;
  std::optional<int64_t> last_utime;
  bool is_different = false;
  std::string arithmetic_a;
  std::string arithmetic_b;
  const auto next_compared = [&](LogReader* reader, std::string* arithmetic) {
    while (true) {
      auto event = reader->Next();
      if (event) TakeArithmetic(*event, arithmetic);
      if (!event || !IsLeftOut(options, event->channel)) return event;
    }
  };
  while (true) {
    const auto a = next_compared(&*reader_a, &arithmetic_a);
    const auto b = next_compared(&*reader_b, &arithmetic_b);
    if (!reader_a->error().empty() || !reader_b->error().empty()) break;
    if (!a && !b) break;
    const auto count = [&](const std::optional<LogEvent>& event) -> auto& {
      auto found = counts.find(event->channel);
      if (found == counts.end()) found = counts.try_emplace(std::string(event->channel)).first;
      return found->second;
    };
    if (a) ++count(a).first;
    if (b) ++count(b).second;
    if (is_different) continue;
    const int64_t utime = a ? a->utime : b->utime;
    if (last_utime != utime) ++num_steps;
    last_utime = utime;
    ++num_events;
    if (!a || !b || !AreEqual(*schema, *a, *b)) {
      is_different = true;
      PrintDifference(*schema, options, num_steps - 1, a, b, out);
    }
  }
  const bool is_a_whole = ReportDamage(*reader_a, err);
  const bool is_b_whole = ReportDamage(*reader_b, err);
  if (!is_a_whole || !is_b_whole) return kExitEnvironment;
  if (!arithmetic_a.empty() && !arithmetic_b.empty() && arithmetic_a != arithmetic_b) {
    out << "the logs are of builds with another arithmetic, which give other logs:\n";
    std::string shown_a;
    std::string shown_b;
    AppendQuoted(arithmetic_a, &shown_a);
    AppendQuoted(arithmetic_b, &shown_b);
    PrintBoth(options, shown_a, shown_b, out);
  }
  if (is_different) {
    PrintCounts(options, counts, out);
    return kLogsDiffer;
  }
  out << fmt::format("equal: {} events in {} steps\n", num_events, num_steps);
  return kExitOk;
}

}  // namespace shoal
