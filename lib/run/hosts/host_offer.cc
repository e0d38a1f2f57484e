#include "lib/run/hosts/host_offer.h"

#include <fmt/format.h>
#include <sodium.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "lib/base/check/check.h"
#include "lib/base/text/numbers.h"
#include "lib/bus/os/read_file.h"
#include "lib/bus/os/text_file.h"
#include "lib/mission/file/load.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// Leaves room for the other parts of the offer.
constexpr size_t kMaxOffered_bytes = kLargestLinkMessage_bytes - (size_t{4} << 20);

constexpr std::string_view kFile = "file:";
constexpr std::string_view kSet = "set";
constexpr std::string_view kParticipant = "participant";
constexpr std::string_view kLine = "line";

/// Returns the folder that all `paths` lie in or below; empty where there is none but "/".
fs::path CommonFolder(const std::vector<fs::path>& paths) {
  fs::path common = paths.front().parent_path();
  const auto holds_all = [&](const fs::path& folder) {
    return std::all_of(paths.begin(), paths.end(), [&](const fs::path& path) {
      return path.lexically_relative(folder).begin()->string() != "..";
    });
  };
  while (common.has_relative_path() && !holds_all(common)) common = common.parent_path();
  return common;
}

bool StaysBelow(const fs::path& path) {
  return !path.empty() && path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

std::vector<std::string> TextsOf(const LinkMessage& message, std::string_view name) {
  std::vector<std::string> texts;
  for (const LinkPart& part : message.parts) {
    if (part.name == name) texts.emplace_back(part.data.begin(), part.data.end());
  }
  return texts;
}

}  // namespace

std::string MissionDigest(const Mission& mission, const std::vector<OfferedFile>& files) {
  SHOAL_CHECK(sodium_init() >= 0, "libsodium works on this machine");
  std::array<uint8_t, 32> digest{};
  crypto_generichash_state state;
  crypto_generichash_init(&state, nullptr, 0, digest.size());
  const auto add = [&](const std::string& text) {
    const std::string size = fmt::format("{} ", text.size());
    crypto_generichash_update(&state, reinterpret_cast<const uint8_t*>(size.data()), size.size());
    crypto_generichash_update(&state, reinterpret_cast<const uint8_t*>(text.data()), text.size());
  };
  Mission anywhere = mission;
  anywhere.hosts.clear();
  add(Explain(anywhere));
  for (const OfferedFile& file : files) {
    add(file.path);
    add(file.text);
  }
  crypto_generichash_final(&state, digest.data(), digest.size());
  std::string text(2 * digest.size() + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), digest.data(), digest.size());
  text.pop_back();
  return text;
}

Result<std::vector<OfferedFile>> FilesOfMission(const std::string& mission_file,
                                                const std::vector<std::string>& overrides) {
  std::error_code error;
  std::vector<fs::path> paths = {fs::absolute(mission_file, error).lexically_normal()};
  {
    const FilesRead read;
    const LoadedMission loaded = LoadMission(mission_file, overrides);
    if (!loaded.errors.empty()) return Error{loaded.errors.front()};
    for (const std::string& path : read.paths()) {
      paths.push_back(fs::absolute(path, error).lexically_normal());
    }
  }
  const fs::path folder = CommonFolder(paths);
  std::vector<OfferedFile> files;
  size_t bytes = 0;
  for (const fs::path& path : paths) {
    const FileText read = ReadRegularFile(path.string());
    if (!read.problem.empty()) {
      return Error{fmt::format("{}: {}; a mission for hosts is a file, and no pipe", path.string(),
                               read.problem)};
    }
    bytes += read.text.size();
    files.push_back({.path = path.lexically_relative(folder).string(), .text = read.text});
  }
  if (bytes > kMaxOffered_bytes) {
    return Error{fmt::format("{}: the mission's files have {} MiB; a host takes {}", mission_file,
                             bytes >> 20, kMaxOffered_bytes >> 20)};
  }
  return files;
}

Result<std::string> WriteOfferedFiles(const std::vector<OfferedFile>& files,
                                      const std::string& folder) {
  for (const OfferedFile& file : files) {
    if (!StaysBelow(file.path)) {
      return Error{fmt::format("the file '{}' would lie outside of the host's folder", file.path)};
    }
    const fs::path path = fs::path(folder) / file.path;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (!TextFile(path.string(), file.text).Flush()) {
      return Error{fmt::format("cannot write {}: is the disk full?", path.string())};
    }
  }
  if (files.empty()) return Error{"an offer without a mission file"};
  return (fs::path(folder) / files.front().path).string();
}

LinkMessage ToLinkMessage(const HostOffer& offer, int64_t mission_id) {
  LinkMessage message{.kind = LinkKind::kOffer, .mission_id = mission_id};
  message.AddText("build", offer.build);
  message.AddText("host", offer.host);
  message.AddText("digest", offer.digest);
  message.AddText("layout", Name(offer.layout));
  message.AddText("grouping", Name(offer.grouping));
  message.AddText("timeout_s", fmt::format("{}", offer.timeout_s));
  message.AddText("secret", SecretText(offer.secret));
  for (const std::string& each : offer.overrides) message.AddText(kSet, each);
  for (const std::string& each : offer.participants) message.AddText(kParticipant, each);
  for (const OfferedFile& file : offer.files) {
    message.AddText(std::string(kFile) + file.path, file.text);
  }
  return message;
}

Result<HostOffer> OfferOf(const LinkMessage& message) {
  HostOffer offer;
  offer.build = message.TextOf("build");
  offer.host = message.TextOf("host");
  offer.digest = message.TextOf("digest");
  offer.layout = message.TextOf("layout") == Name(Layout::kCommunities) ? Layout::kCommunities
                                                                        : Layout::kShared;
  offer.timeout_s = ReadNumber<double>(message.TextOf("timeout_s")).value_or(0);
  offer.overrides = TextsOf(message, kSet);
  offer.participants = TextsOf(message, kParticipant);
  for (const LinkPart& part : message.parts) {
    if (!part.name.starts_with(kFile)) continue;
    offer.files.push_back({.path = part.name.substr(kFile.size()),
                           .text = std::string(part.data.begin(), part.data.end())});
  }
  const Result<MissionSecret> secret = ParseSecret(message.TextOf("secret"));
  if (!secret.ok() || offer.files.empty() || offer.participants.empty() || offer.timeout_s <= 0) {
    return Error{"an offer without a mission file, participants, time-out or secret"};
  }
  const Result<Grouping> grouping = ParseGrouping(message.TextOf("grouping"));
  if (!grouping.ok()) return Error{grouping.error()};
  offer.grouping = *grouping;
  offer.secret = *secret;
  return offer;
}

LinkMessage ToLinkMessage(const HostExit& exit, int64_t mission_id) {
  LinkMessage message{.kind = LinkKind::kExit, .mission_id = mission_id};
  message.AddText("name", exit.name);
  message.AddText("pid", std::to_string(exit.pid));
  message.AddText("clean", exit.clean ? "yes" : "no");
  message.AddText("how", exit.how);
  for (const std::string& line : exit.last_lines) message.AddText(kLine, line);
  return message;
}

HostExit ExitOf(const LinkMessage& message) {
  return {.name = message.TextOf("name"),
          .pid = ReadNumber<int64_t>(message.TextOf("pid")).value_or(0),
          .clean = message.TextOf("clean") == "yes",
          .how = message.TextOf("how"),
          .last_lines = TextsOf(message, kLine)};
}

}  // namespace shoal
