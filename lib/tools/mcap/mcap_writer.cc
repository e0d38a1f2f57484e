#include "lib/tools/mcap/mcap_writer.h"

#include <algorithm>
#include <cstring>

#include "lib/base/check/check.h"
#include "lib/tools/mcap/crc32.h"
#include "lib/tools/mcap/proto_wire.h"

namespace shoal {

namespace {

constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";

/// Op codes of records.
enum class McapRecord : uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0b,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

constexpr size_t kRecordHeaderSize = 1 + 8;  // op code, length

void AppendSizedText(std::string_view text, std::string* out) {
  AppendLittleEndian(static_cast<uint32_t>(text.size()), out);
  *out += text;
}

/// Begins a record, and returns where it does.
size_t BeginRecord(McapRecord record, std::string* out) {
  const size_t begin = out->size();
  out->push_back(static_cast<char>(record));
  AppendLittleEndian(uint64_t{0}, out);
  return begin;
}

/// Fills in the length of the record that begins there.
void EndRecord(size_t begin, std::string* out) {
  const uint64_t length = out->size() - begin - kRecordHeaderSize;
  std::memcpy(out->data() + begin + 1, &length, sizeof length);
}

template <class WriteContent>
void AppendRecord(McapRecord record, std::string* out, const WriteContent& write) {
  const size_t begin = BeginRecord(record, out);
  write();
  EndRecord(begin, out);
}

/// Appends a length in bytes (uint32) and what `write` appends.
template <class WriteContent>
void AppendSized32(std::string* out, const WriteContent& write) {
  const size_t begin = out->size();
  AppendLittleEndian(uint32_t{0}, out);
  write();
  const auto length = static_cast<uint32_t>(out->size() - begin - sizeof(uint32_t));
  std::memcpy(out->data() + begin, &length, sizeof length);
}

/// What a file begins with.
std::string McapBegin(std::string_view library) {
  std::string begin(kMcapMagic);
  AppendRecord(McapRecord::kHeader, &begin, [&] {
    AppendSizedText("", &begin);  // profile: none of those that MCAP knows
    AppendSizedText(library, &begin);
  });
  return begin;
}

}  // namespace

void McapWriter::Times::Add(uint64_t time_ns) {
  first_ns = is_set ? std::min(first_ns, time_ns) : time_ns;
  last_ns = is_set ? std::max(last_ns, time_ns) : time_ns;
  is_set = true;
}

McapWriter::McapWriter(std::string path, std::string_view library)
    : file_(std::move(path), McapBegin(library)), position_(McapBegin(library).size()) {
  chunk_.reserve(kChunkSize + kChunkSize / 4);
}

std::optional<uint16_t> McapWriter::AddSchema(std::string_view name,
                                              std::string_view descriptor_set) {
  if (num_schemas_ == kMaxIds) return std::nullopt;
  const uint16_t id = ++num_schemas_;
  std::string record;
  AppendRecord(McapRecord::kSchema, &record, [&] {
    AppendLittleEndian(id, &record);
    AppendSizedText(name, &record);
    AppendSizedText("protobuf", &record);
    AppendSizedText(descriptor_set, &record);
  });
  chunk_ += record;
  schema_records_ += record;
  return id;
}

std::optional<uint16_t> McapWriter::AddChannel(uint16_t schema, std::string_view topic) {
  if (channels_.size() == kMaxIds) return std::nullopt;
  channels_.emplace_back();
  const auto id = static_cast<uint16_t>(channels_.size());
  std::string record;
  AppendRecord(McapRecord::kChannel, &record, [&] {
    AppendLittleEndian(id, &record);
    AppendLittleEndian(schema, &record);
    AppendSizedText(topic, &record);
    AppendSizedText("protobuf", &record);
    AppendLittleEndian(uint32_t{0}, &record);  // metadata: none
  });
  chunk_ += record;
  channel_records_ += record;
  return id;
}

void McapWriter::BeginMessage(uint16_t channel, uint64_t log_time_ns) {
  SHOAL_CHECK(channel >= 1 && channel <= channels_.size(), "a message's channel was added");
  Channel& to = channels_[channel - 1u];
  if (to.index.empty()) in_chunk_.push_back(channel);
  to.index.emplace_back(log_time_ns, chunk_.size());
  chunk_times_.Add(log_time_ns);
  record_begin_ = BeginRecord(McapRecord::kMessage, &chunk_);
  AppendLittleEndian(channel, &chunk_);
  AppendLittleEndian(static_cast<uint32_t>(to.num_messages), &chunk_);  // the sequence number
  AppendLittleEndian(log_time_ns, &chunk_);
  AppendLittleEndian(log_time_ns, &chunk_);  // the time of publication
  ++to.num_messages;
  ++num_messages_;
}

bool McapWriter::EndMessage() {
  EndRecord(record_begin_, &chunk_);
  return chunk_.size() < kChunkSize || WriteChunk();
}

bool McapWriter::Write(std::string_view bytes) {
  position_ += bytes.size();
  return file_.Append([&](std::string* out) { *out += bytes; });
}

bool McapWriter::WriteChunk() {
  const uint64_t chunk_begin = position_;
  const uint64_t size = chunk_.size();
  std::string head;
  const size_t record = BeginRecord(McapRecord::kChunk, &head);
  AppendLittleEndian(chunk_times_.first_ns, &head);
  AppendLittleEndian(chunk_times_.last_ns, &head);
  AppendLittleEndian(size, &head);
  AppendLittleEndian(ExtendCrc32(0, chunk_), &head);
  AppendSizedText("", &head);  // compression: none
  AppendLittleEndian(size, &head);
  const uint64_t content = head.size() - record - kRecordHeaderSize + size;
  std::memcpy(head.data() + record + 1, &content, sizeof content);
  const uint64_t chunk_length = head.size() + size;

  std::ranges::sort(in_chunk_);
  std::string indexes;
  std::string index_offsets;
  for (const uint16_t id : in_chunk_) {
    AppendLittleEndian(id, &index_offsets);
    AppendLittleEndian(chunk_begin + chunk_length + indexes.size(), &index_offsets);
    auto& index = channels_[id - 1u].index;
    AppendRecord(McapRecord::kMessageIndex, &indexes, [&] {
      AppendLittleEndian(id, &indexes);
      AppendSized32(&indexes, [&] {
        for (const auto& [time_ns, offset] : index) {
          AppendLittleEndian(time_ns, &indexes);
          AppendLittleEndian(offset, &indexes);
        }
      });
    });
    index.clear();
  }
  AppendRecord(McapRecord::kChunkIndex, &chunk_index_records_, [&] {
    std::string* out = &chunk_index_records_;
    AppendLittleEndian(chunk_times_.first_ns, out);
    AppendLittleEndian(chunk_times_.last_ns, out);
    AppendLittleEndian(chunk_begin, out);
    AppendLittleEndian(chunk_length, out);
    AppendSizedText(index_offsets, out);
    AppendLittleEndian(uint64_t{indexes.size()}, out);
    AppendSizedText("", out);
    AppendLittleEndian(size, out);
    AppendLittleEndian(size, out);
  });
  if (chunk_times_.is_set) {
    times_.Add(chunk_times_.first_ns);
    times_.Add(chunk_times_.last_ns);
  }
  const bool is_written = Write(head) && Write(chunk_) && Write(indexes);
  ++num_chunks_;
  chunk_.clear();
  if (chunk_.capacity() > 2 * kChunkSize) chunk_ = {};  // it held a message of many megabytes
  in_chunk_.clear();
  chunk_times_ = {};
  return is_written;
}

std::string McapWriter::Summary() const {
  struct Group {
    McapRecord record;
    size_t begin;
    size_t size;
  };
  std::vector<Group> groups;
  std::string out;
  const auto add = [&](McapRecord record, const std::string& records) {
    if (!records.empty()) groups.push_back({record, out.size(), records.size()});
    out += records;
  };
  std::string statistics;
  AppendRecord(McapRecord::kStatistics, &statistics, [&] {
    AppendLittleEndian(num_messages_, &statistics);
    AppendLittleEndian(num_schemas_, &statistics);
    AppendLittleEndian(static_cast<uint32_t>(channels_.size()), &statistics);
    AppendLittleEndian(uint32_t{0}, &statistics);  // attachments
    AppendLittleEndian(uint32_t{0}, &statistics);  // metadata
    AppendLittleEndian(num_chunks_, &statistics);
    AppendLittleEndian(times_.first_ns, &statistics);
    AppendLittleEndian(times_.last_ns, &statistics);
    AppendSized32(&statistics, [&] {
      for (size_t i = 0; i < channels_.size(); ++i) {
        AppendLittleEndian(static_cast<uint16_t>(i + 1), &statistics);
        AppendLittleEndian(channels_[i].num_messages, &statistics);
      }
    });
  });
  add(McapRecord::kSchema, schema_records_);
  add(McapRecord::kChannel, channel_records_);
  add(McapRecord::kStatistics, statistics);
  add(McapRecord::kChunkIndex, chunk_index_records_);

  const uint64_t summary_begin = position_;
  const uint64_t offsets_begin = summary_begin + out.size();
  for (const Group& group : groups) {
    AppendRecord(McapRecord::kSummaryOffset, &out, [&] {
      out.push_back(static_cast<char>(group.record));
      AppendLittleEndian(summary_begin + group.begin, &out);
      AppendLittleEndian(uint64_t{group.size}, &out);
    });
  }
  AppendRecord(McapRecord::kFooter, &out, [&] {
    AppendLittleEndian(summary_begin, &out);
    AppendLittleEndian(offsets_begin, &out);
    AppendLittleEndian(uint32_t{0}, &out);
  });
  // The CRC is of all that comes before it, its record's own header included.
  const size_t crc_begin = out.size() - sizeof(uint32_t);
  const uint32_t crc = ExtendCrc32(0, std::string_view(out).substr(0, crc_begin));
  std::memcpy(out.data() + crc_begin, &crc, sizeof crc);
  out += kMcapMagic;
  return out;
}

bool McapWriter::Close() {
  bool is_written = chunk_.empty() || WriteChunk();
  std::string end;
  AppendRecord(McapRecord::kDataEnd, &end, [&] { AppendLittleEndian(uint32_t{0}, &end); });
  is_written = is_written && Write(end);
  return is_written && Write(Summary()) && file_.Flush();
}

}  // namespace shoal
