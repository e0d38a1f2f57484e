#include "apps/shoal/import_command.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "lib/check/result.h"
#include "lib/moos/alog.h"
#include "lib/moos/import.h"
#include "lib/moos/moos_file.h"
#include "shoal/node_report_t.hpp"

namespace shoal {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Result<std::string> ReadMoosFile(const std::string& path) {
  constexpr size_t kLargest_bytes = 10'000'000;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return Error{path + " is a directory; name the .moos file in it"};
  }
  const File file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (file == nullptr) return Error{path + " cannot be read: " + std::strerror(errno)};
  std::string text;
  std::array<char, 65536> buffer;
  while (const size_t size = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    text.append(buffer.data(), size);
    if (text.size() > kLargest_bytes) return Error{path + " is larger than 10 MB: no .moos file"};
  }
  if (std::ferror(file.get()) != 0) return Error{path + " cannot be read to its end"};
  return text;
}

/// Returns the error; nothing where the file is written. "x": an existing file is not changed.
std::optional<Error> WriteNewFile(const std::string& path, std::string_view text, int* code) {
  File file(std::fopen(path.c_str(), "wx"), &std::fclose);
  if (file == nullptr && errno == EEXIST) {
    *code = kExitUsage;
    return Error{path + " exists already; name another file, or remove it first"};
  }
  *code = kExitEnvironment;
  if (file == nullptr) return Error{"cannot write " + path + ": " + std::strerror(errno)};
  const bool is_written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  if (std::fclose(file.release()) == 0 && is_written) return std::nullopt;
  return Error{"cannot write " + path + " to its end: is the disk full?"};
}

int Fail(const std::string& problem, int code) {
  fmt::print(stderr, "shoal: {}\n", problem);
  return code;
}

}  // namespace

int RunImport(const ImportOptions& options) {
  std::vector<MoosSource> sources;
  for (const std::string& path : options.files) {
    Result<std::string> text = ReadMoosFile(path);
    if (!text.ok()) return Fail(text.error(), kExitUsage);
    if (ParseMoosFile(*text, path).blocks.empty()) {
      return Fail(path + " is no MOOS mission file: it has no ProcessConfig block", kExitUsage);
    }
    sources.push_back({.name = path, .text = std::move(*text)});
  }
  const MoosImport import = ImportMoos(sources);
  for (const std::string& warning : import.warnings) fmt::print(stderr, "{}\n", warning);
  if (options.out_path.empty()) {
    fmt::print("{}", import.mission);
    return kExitOk;
  }
  int code = kExitOk;
  if (const auto error = WriteNewFile(options.out_path, import.mission, &code)) {
    return Fail(error->message, code);
  }
  fmt::print(
      "{}: vehicles: {}, warnings: {}; its comments name every line that has no counterpart\n",
      options.out_path, import.num_vehicles, import.warnings.size());
  return kExitOk;
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
