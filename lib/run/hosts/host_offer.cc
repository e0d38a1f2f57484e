#include "lib/run/hosts/host_offer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sodium.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/text/numbers.h"
#include "lib/base/text/terminal_text.h"
#include "lib/bus/os/files_below.h"
#include "lib/bus/os/read_file.h"
#include "lib/bus/os/text_file.h"
#include "lib/mission/file/load.h"
#include "lib/mission/model/names.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// Leaves room for the other parts of the offer.
constexpr size_t kMaxOffered_bytes = kLargestLinkMessage_bytes - (size_t{4} << 20);

constexpr std::string_view kFile = "file:";
constexpr std::string_view kSet = "set";
constexpr std::string_view kParticipant = "participant";
constexpr std::string_view kLine = "line";
constexpr size_t kMaxLines = 10;  ///< Of what a process wrote last; ChildExit has fewer.
/// Of a reason or line: so that a message of them keeps within the limits of its kind.
constexpr size_t kMaxText_bytes = size_t{64} << 10;

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
    // By a relative path, so that absolute ones are those that the mission itself has.
    const fs::path relative =
        fs::absolute(mission_file, error).lexically_relative(fs::current_path(error));
    const LoadedMission loaded = LoadMission(relative.string(), overrides);
    if (!loaded.errors.empty()) return Error{loaded.errors.front()};
    for (const std::string& path : read.paths()) {
      if (fs::path(path).is_absolute()) {
        return Error{fmt::format(
            "{}: it names {} by an absolute path, which on a host is another file or none: copy "
            "the file into the mission file's folder, and name it relative to that",
            mission_file, path)};
      }
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

Result<Mission> LoadOffered(const HostOffer& offer, const std::string& folder) {
  const Result<std::string> file = WriteOfferedFiles(offer.files, folder);
  if (!file.ok()) return Error{file.error()};
  const OnlyFilesBelow bounds(folder);
  LoadedMission loaded = LoadMission(*file, offer.overrides);
  if (!loaded.errors.empty()) {
    return Error{"it does not load there: " + TerminalLine(loaded.errors.front())};
  }
  if (MissionDigest(loaded.mission, offer.files) != offer.digest) {
    return Error{"it is another mission there than at home: its digest differs"};
  }
  return std::move(loaded.mission);
}

Result<std::vector<RosterEntry>> OfferedRoster(const HostOffer& offer, const Mission& mission,
                                               bool allow_programs) {
  std::set<std::string_view> wanted(offer.participants.begin(), offer.participants.end());
  if (wanted.size() != offer.participants.size()) {
    return Error{"it offers a participant twice"};
  }
  std::vector<RosterEntry> roster;
  for (RosterEntry& entry : MakeRoster(mission, false)) {
    if (wanted.erase(entry.name) == 0) continue;
    if (!entry.app.empty() && entry.vehicle.empty()) {
      return Error{fmt::format(
          "{} runs at home: a host runs the processes of vehicles, and [[participant]] programs",
          entry.name)};
    }
    if (entry.host != offer.host) {
      return Error{
          fmt::format("the mission does not place {} on host {}: [[host]] vehicles, "
                      "[[host]] participants and --on do",
                      entry.name, offer.host)};
    }
    if (!entry.command.empty() && !allow_programs) {
      return Error{fmt::format(
          "participant {} runs a program of the mission's own ({}); a host runs such programs only "
          "where it was started with --allow-programs",
          entry.name, TerminalLine(fmt::format("{}", fmt::join(entry.command, " "))))};
    }
    roster.push_back(std::move(entry));
  }
  if (!wanted.empty()) {
    return Error{fmt::format("it has {} of the {} participants that this host is to run",
                             roster.size(), offer.participants.size())};
  }
  return roster;
}

LinkMessage ToLinkMessage(const HostOffer& offer, int64_t mission_id) {
  LinkMessage message{.kind = LinkKind::kOffer, .mission_id = mission_id};
  message.AddText("version", offer.build.version);
  message.AddText("build", offer.build.build);
  message.AddText("arithmetic", offer.build.arithmetic);
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

BuildFacts BuildOf(const LinkMessage& offer) {
  return {.version = offer.TextOf("version"),
          .build = offer.TextOf("build"),
          .arithmetic = offer.TextOf("arithmetic")};
}

Result<HostOffer> OfferOf(const LinkMessage& message) {
  HostOffer offer;
  offer.build = BuildOf(message);
  offer.host = message.TextOf("host");
  offer.digest = message.TextOf("digest");
  const std::string layout = message.TextOf("layout");
  offer.layout = layout == Name(Layout::kCommunities) ? Layout::kCommunities : Layout::kShared;
  if (layout != Name(offer.layout)) return Error{fmt::format("an offer of layout '{}'", layout)};
  if (std::string problem = NameProblem(offer.host); !problem.empty()) {
    return Error{fmt::format("an offer for a host '{}': {}", offer.host, problem)};
  }
  offer.timeout_s = ReadNumber<double>(message.TextOf("timeout_s")).value_or(0);
  // A longer one would keep the host busy with a home that is gone. NaN is in no range.
  if (!(offer.timeout_s >= kShortestHostTimeout_s && offer.timeout_s <= kLongestHostTimeout_s)) {
    return Error{fmt::format("an offer with timeout_s = {}; it is {} to {} s",
                             message.TextOf("timeout_s"), kShortestHostTimeout_s,
                             kLongestHostTimeout_s)};
  }
  offer.overrides = TextsOf(message, kSet);
  offer.participants = TextsOf(message, kParticipant);
  for (const LinkPart& part : message.parts) {
    if (!part.name.starts_with(kFile)) continue;
    offer.files.push_back({.path = part.name.substr(kFile.size()),
                           .text = std::string(part.data.begin(), part.data.end())});
  }
  const std::vector<std::string> secrets = TextsOf(message, "secret");
  const Result<MissionSecret> secret = ParseSecret(secrets.empty() ? "" : secrets.front());
  if (!secret.ok() || offer.files.empty() || offer.participants.empty()) {
    return Error{"an offer without a mission file, participants or secret"};
  }
  const Result<Grouping> grouping = ParseGrouping(message.TextOf("grouping"));
  if (!grouping.ok()) return Error{grouping.error()};
  offer.grouping = *grouping;
  offer.secret = *secret;
  return offer;
}

LinkMessage RefusalOf(int64_t mission_id, std::string_view why) {
  LinkMessage refusal{.kind = LinkKind::kRefuse, .mission_id = mission_id};
  refusal.AddText("why", why.substr(0, kMaxText_bytes));
  return refusal;
}

LinkMessage ToLinkMessage(const HostExit& exit, int64_t mission_id) {
  LinkMessage message{.kind = LinkKind::kExit, .mission_id = mission_id};
  message.AddText("name", exit.name);
  message.AddText("pid", std::to_string(exit.pid));
  message.AddText("clean", exit.clean ? "yes" : "no");
  message.AddText("how", exit.how.substr(0, kMaxText_bytes));
  for (size_t i = 0; i < std::min(kMaxLines, exit.last_lines.size()); ++i) {
    message.AddText(kLine, exit.last_lines[i].substr(0, kMaxText_bytes));
  }
  return message;
}

HostExit ExitOf(const LinkMessage& message) {
  std::vector<std::string> lines = TextsOf(message, kLine);
  if (lines.size() > kMaxLines) lines.resize(kMaxLines);
  for (std::string& line : lines) line = TerminalLine(line);
  return {.name = message.TextOf("name"),
          .pid = ReadNumber<int64_t>(message.TextOf("pid")).value_or(0),
          .clean = message.TextOf("clean") == "yes",
          .how = message.TextOf("how"),
          .last_lines = std::move(lines)};
}

}  // namespace shoal
