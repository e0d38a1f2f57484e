#include "lib/bus/record/message_types.h"

#include <fmt/format.h>

#include <cstdio>

#include "lcmtypes/lcm_sources.h"
#include "lib/bus/bus/fate_columns.h"
#include "lib/bus/bus/pulse_columns.h"
#include "lib/bus/bus/seal.h"
#include "lib/bus/record/file_window.h"

namespace shoal {

namespace {

constexpr uint64_t kMaxLcmFileSize = 1 << 20;

Result<std::string> ReadLcmFile(const std::string& path) {
  Result<FileWindow> file = FileWindow::Open(path);
  if (!file.ok()) return Error{file.error()};
  if (file->size() > kMaxLcmFileSize) return Error{path + ": too long for an .lcm file"};
  const auto bytes = file->At(0, static_cast<size_t>(file->size()));
  if (!file->error().empty()) return Error{"cannot read " + path + ": " + file->error()};
  return std::string(bytes.begin(), bytes.end());
}

}  // namespace

Result<Schema> LoadMessageTypes(const std::vector<std::string>& lcm_files) {
  std::vector<LcmSource> sources;
  for (const std::string_view text : LcmSources()) {
    sources.push_back({.file = "(shoal's own types)", .text = std::string(text)});
  }
  for (const std::string& path : lcm_files) {
    Result<std::string> text = ReadLcmFile(path);
    if (!text.ok()) return Error{text.error()};
    sources.push_back({.file = path, .text = std::move(*text)});
  }
  Result<Schema> schema = Schema::Build(sources);
  if (schema.ok()) {
    for (const std::string& note : schema->left_out()) fmt::print(stderr, "warning: {}\n", note);
  }
  return schema;
}

RecognisedMessage Recognise(const Schema& schema, std::span<const uint8_t> logged) {
  const auto recognise = [&](std::span<const uint8_t> data) {
    RecognisedMessage message{.data = data, .type = nullptr, .fault = std::nullopt};
    if (const auto fingerprint = FingerprintOf(data)) {
      message.type = schema.FindByFingerprint(*fingerprint);
    }
    if (message.type != nullptr) message.fault = FindWireFault(schema, *message.type, data);
    return message;
  };
  const Unsealed unsealed = Unseal(logged);
  RecognisedMessage message = recognise(unsealed.message);
  if (message.fault && unsealed.seal) {  // what looks like a seal may be the message's own bytes
    const RecognisedMessage whole = recognise(logged);
    if (whole.IsDecodable()) return whole;
  }
  return message;
}

RecognisedMessage RecogniseAsList(const Schema& schema, std::span<const uint8_t> logged,
                                  Bytes* storage) {
  RecognisedMessage message = Recognise(schema, logged);
  if (!message.IsDecodable()) return message;
  const auto take = [&](std::span<const uint8_t> list, int64_t fingerprint) {
    if (list.data() == message.data.data()) return false;
    message.data = list;
    message.type = schema.FindByFingerprint(fingerprint);
    return true;
  };
  if (!take(WithFatesAsList(message.data, storage), comms_fates_t::getHash())) {
    take(WithPulsesAsList(message.data, storage), comms_pulses_t::getHash());
  }
  return message;
}

std::string DisplayName(const StructType& type) {
  return type.package == "shoal" ? type.name : type.FullName();
}

std::string DescribeFingerprint(std::span<const uint8_t> message) {
  const auto fingerprint = FingerprintOf(message);
  return fingerprint ? fmt::format("fingerprint 0x{:016x}", static_cast<uint64_t>(*fingerprint))
                     : "no fingerprint";
}

std::optional<int64_t> UtimeOf(const RecognisedMessage& message) {
  const auto& members = message.type->members;
  if (members.empty() || members[0].name != "utime" || members[0].primitive != Primitive::kInt64 ||
      !members[0].dimensions.empty()) {
    return std::nullopt;
  }
  return FingerprintOf(message.data.subspan(8));  // a big-endian int64_t, too
}

}  // namespace shoal
