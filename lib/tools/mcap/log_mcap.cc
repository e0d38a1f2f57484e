#include "lib/tools/mcap/log_mcap.h"

#include <fmt/format.h>

#include <cerrno>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "lib/base/schema/text.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/message_types.h"
#include "lib/bus/record/valid_utf8.h"
#include "lib/run/command_line/version.h"
#include "lib/tools/mcap/mcap_writer.h"
#include "lib/tools/mcap/proto_message.h"
#include "lib/tools/mcap/proto_schema.h"
#include "lib/tools/mcap/shown_messages.h"

namespace shoal {

namespace {

/// One conversion.
class McapConversion {
 public:
  McapConversion(const LogMcapOptions& options, const Schema& schema, LogReader* reader,
                 std::ostream& out, std::ostream& err)
      : options_(options),
        schema_(schema),
        reader_(*reader),
        out_(out),
        err_(err),
        writer_(options.out_path, fmt::format("shoal {}", kVersion)),
        encoder_(schema),
        shown_(schema) {}

  int Run() {
    std::set<std::string, std::less<>> channels;
    auto event = reader_.Next();
    if (!event && !ReportDamage(reader_, err_)) return kExitEnvironment;
    for (; event; event = reader_.Next()) {
      if (!channels.contains(event->channel)) channels.emplace(event->channel);
      if (!IsSelected(options_.selection, *event)) continue;
      if (!Add(*event)) return Fail();
    }
    if (!writer_.Close()) return Fail();
    Report();
    const bool is_whole = ReportDamage(reader_, err_);
    if (!is_whole) return kExitEnvironment;
    return ReportUnmatched(reader_, options_.selection, channels, err_) ? kExitOk : kExitUsage;
  }

 private:
  /// Times are nanoseconds in a uint64_t.
  static constexpr int64_t kLatest_us = INT64_MAX / 1000;

  bool Add(const LogEvent& event) {
    const RecognisedMessage message = RecogniseAsList(schema_, event.data, &storage_);
    if (!message.IsDecodable()) return LeaveOut(event, "unknown type, or bytes that do not decode");
    if (event.utime < 0 || event.utime > kLatest_us) {
      return LeaveOut(event, "MCAP has no such time: its times are nanoseconds from 0 on");
    }
    const std::optional<uint16_t> channel = ChannelOf(event.channel, *message.type);
    if (!channel) return false;
    const uint64_t time_ns = static_cast<uint64_t>(event.utime) * 1000;
    const auto encode = [&](std::string* out) {
      encoder_.Append(*message.type, message.data, out);
    };
    if (!writer_.Append(*channel, time_ns, encode)) return false;
    if (options_.only_log) return true;
    return shown_.Add(event, message, [&](ShownKind kind, std::string_view topic, const auto& add) {
      const std::optional<uint16_t> shown_channel = ShownChannelOf(kind, topic);
      return shown_channel && writer_.Append(*shown_channel, time_ns, add);
    });
  }

  bool LeaveOut(const LogEvent& event, std::string_view why) {
    ++left_out_[{std::string(event.channel), why}];
    return true;
  }

  std::optional<uint16_t> ChannelOf(std::string_view channel, const StructType& type) {
    // Logs have the same channels again and again, of one type each.
    key_.assign(channel);
    auto& of_name = channels_[key_];
    for (const auto& [of_type, id] : of_name) {
      if (of_type == &type) return id;
    }
    const auto schema = SchemaOf(type);
    const auto id = schema ? AddChannel(*schema, ValidUtf8(channel)) : std::nullopt;
    if (id) of_name.emplace_back(&type, *id);
    return id;
  }

  std::optional<uint16_t> SchemaOf(const StructType& type) {
    const auto [it, is_new] = schemas_.try_emplace(&type);
    if (!is_new) return it->second;
    const auto files = ProtoFilesOf(schema_, type);
    if (!files.ok()) {
      problem_ = files.error();
      return std::nullopt;
    }
    it->second = writer_.AddSchema(type.FullName(), EncodeFileDescriptorSet(*files));
    if (!it->second) problem_ = "more types than an MCAP file can have; select channels: --channel";
    return it->second;
  }

  std::optional<uint16_t> AddChannel(uint16_t schema, std::string_view topic) {
    const auto id = writer_.AddChannel(schema, topic);
    if (!id) {
      problem_ = fmt::format(
          "more than {} channels, which an MCAP file cannot have; select some: "
          "--channel",
          McapWriter::kMaxIds);
    }
    return id;
  }

  std::optional<uint16_t> ShownChannelOf(ShownKind kind, std::string_view topic) {
    key_.assign(topic);
    const auto [it, is_new] = shown_channels_.try_emplace(key_);
    if (!is_new) return it->second;
    const auto [schema, is_new_schema] = shown_schemas_.try_emplace(kind);
    if (is_new_schema) {
      const FoxgloveSchema text = kind == ShownKind::kLocation ? LocationFixSchema()
                                  : kind == ShownKind::kPose   ? PoseInFrameSchema()
                                                               : LogSchema();
      schema->second = writer_.AddSchema(text.name, text.descriptor_set);
    }
    if (schema->second) it->second = AddChannel(*schema->second, topic);
    return it->second;
  }

  int Fail() {
    const int error = errno;
    if (!problem_.empty()) {
      err_ << options_.path << ": " << problem_ << '\n';
      return kExitUsage;
    }
    err_ << fmt::format("cannot write {}: {}\n", options_.out_path, ErrnoText(error));
    return kExitEnvironment;
  }

  void Report() {
    out_ << fmt::format("{}: {} messages, {} bytes\n", options_.out_path, writer_.num_messages(),
                        writer_.size_bytes());
    for (const auto& [key, count] : left_out_) {
      std::string shown;
      AppendQuoted(key.first, &shown);
      err_ << fmt::format("{}: {} messages left out: {}\n", shown, count, key.second);
    }
  }

  const LogMcapOptions& options_;
  const Schema& schema_;
  LogReader& reader_;
  std::ostream& out_;
  std::ostream& err_;
  McapWriter writer_;
  ProtoEncoder encoder_;
  McapShownMessages shown_;
  std::string problem_;  ///< Why the log cannot become an MCAP file.
  std::string key_;
  std::unordered_map<std::string, std::vector<std::pair<const StructType*, uint16_t>>> channels_;
  std::map<const StructType*, std::optional<uint16_t>> schemas_;
  std::unordered_map<std::string, std::optional<uint16_t>> shown_channels_;
  std::map<ShownKind, std::optional<uint16_t>> shown_schemas_;
  Bytes storage_;  ///< Of the message at hand.
  std::map<std::pair<std::string, std::string_view>, int64_t> left_out_;
};

}  // namespace

int LogMcap(const LogMcapOptions& options, std::ostream& out, std::ostream& err) {
  const Result<Schema> schema = LoadMessageTypes(options.types);
  if (!schema.ok()) {
    err << schema.error() << '\n';
    return kExitUsage;
  }
  if (IsLogItself(options.path, options.out_path, err)) return kExitUsage;
  auto reader = OpenLog(options.path, options.skip_damage ? OnDamage::kSkip : OnDamage::kStop, err);
  if (!reader) return kExitEnvironment;
  return McapConversion(options, *schema, &*reader, out, err).Run();
}

}  // namespace shoal
