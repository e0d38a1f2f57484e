// Writes an MCAP file (mcap.dev/spec): chunks of messages without compression, each with an index
// of its messages; behind them a summary of schemas, channels, chunks and counts.
//
//   McapWriter writer("mission.mcap", "shoal 0.1.0");
//   const auto schema = writer.AddSchema("shoal.nav_t", descriptor_set);
//   const auto channel = writer.AddChannel(*schema, "NAV_ALPHA");
//   writer.Append(*channel, log_time_ns, [&](std::string* out) { *out += encoded; });
//   if (!writer.Close()) Fail(errno);
//
// Memory is bounded by one chunk, or one message where that is longer, and by the summary: about
// 100 bytes for each chunk, and 10 for each channel in it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/bus/os/text_file.h"

namespace shoal {

class McapWriter {
 public:
  static constexpr size_t kChunkSize = size_t{4} << 20;
  static constexpr size_t kMaxIds = 0xffff;  ///< Schemas, and channels.

  /// The file is made with the first chunk (lib/bus/os/text_file.h). `library` is what the file
  /// names as its writer.
  McapWriter(std::string path, std::string_view library);

  /// Returns the number of a new schema of encoding protobuf; nothing where there are kMaxIds.
  std::optional<uint16_t> AddSchema(std::string_view name, std::string_view descriptor_set);

  /// Returns the number of a new channel of that schema; nothing where there are kMaxIds.
  std::optional<uint16_t> AddChannel(uint16_t schema, std::string_view topic);

  /// Adds a message, the bytes that `write(std::string*)` appends. Returns false where the file
  /// cannot be written, as do all calls after that one; errno holds the reason.
  /// @pre AddChannel returned `channel`.
  template <class Write>
  [[nodiscard]] bool Append(uint16_t channel, uint64_t log_time_ns, const Write& write) {
    BeginMessage(channel, log_time_ns);
    write(&chunk_);
    return EndMessage();
  }

  /// Writes what is left, and the summary. Returns as Append does.
  [[nodiscard]] bool Close();

  uint64_t num_messages() const { return num_messages_; }
  uint64_t size_bytes() const { return position_; }  ///< Of the file, once it is closed.

 private:
  struct Channel {
    uint64_t num_messages = 0;
    std::vector<std::pair<uint64_t, uint64_t>> index;  ///< In this chunk: time, offset.
  };
  struct Times {
    uint64_t first_ns = 0;
    uint64_t last_ns = 0;
    bool is_set = false;
    void Add(uint64_t time_ns);
  };

  void BeginMessage(uint16_t channel, uint64_t log_time_ns);
  bool EndMessage();
  bool WriteChunk();
  bool Write(std::string_view bytes);
  std::string Summary() const;

  TextFile file_;
  uint64_t position_ = 0;  ///< Bytes given to file_.
  std::string chunk_;      ///< Records of the chunk that is being filled.
  size_t record_begin_ = 0;
  Times chunk_times_;
  Times times_;
  uint64_t num_messages_ = 0;
  uint32_t num_chunks_ = 0;
  uint16_t num_schemas_ = 0;
  std::vector<Channel> channels_;   ///< Channel 1 is the first.
  std::vector<uint16_t> in_chunk_;  ///< Channels with an index.
  std::string schema_records_;      ///< Of the summary.
  std::string channel_records_;
  std::string chunk_index_records_;
};

}  // namespace shoal
