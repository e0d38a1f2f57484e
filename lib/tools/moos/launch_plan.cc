#include "lib/tools/moos/launch_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/mission/toml/suggest.h"
#include "lib/tools/moos/moos_file.h"

namespace shoal {
namespace {

constexpr size_t kMostFiles = 400;

bool IsPlanned(const LaunchFile& file) {
  return file.source.ends_with(".moos") || file.source.ends_with(".bhv");
}

}  // namespace

void LaunchPlanDraft::TakeNsplug(const ShellWords& words, int line, ShellRun* run) {
  if (words.size() < 2) return run->Note(line, "nsplug has no two files");
  LaunchFile file{.source = words[0], .target = words[1], .defines = {}};
  bool is_forced = false;
  for (size_t i = 2; i < words.size(); ++i) {
    const std::string& word = words[i];
    is_forced = is_forced || word == "-f" || word == "--force";
    if (word.starts_with("--macros=")) AddMacros(word.substr(word.find('=') + 1), line, run, &file);
    if (word.starts_with('-')) {
      TakeOption(words, i, &file);
      continue;
    }
    if (word.starts_with('>') || word == "&") break;
    const size_t equals = word.find('=');
    if (equals == 0) continue;
    file.defines.insert_or_assign(word.substr(0, equals), equals == word.npos
                                                              ? std::string(kBareMacro)
                                                              : word.substr(equals + 1));
  }
  if (!is_forced && run->Find(file.target)) {
    run->Note(line, fmt::format("{} is there: without --force nsplug asks whether to replace it; "
                                "here it is replaced",
                                Quoted(file.target)));
  }
  AddFile(std::move(file));
}

void LaunchPlanDraft::TakeOption(const ShellWords& words, size_t at, LaunchFile* file) {
  constexpr std::string_view kPath = "--path=";
  std::string_view word = words[at];
  if (word == "-l" || word == "--lenient") file->options.is_lenient = true;
  if (word == "-s" || word == "--strict") file->options.is_strict = true;
  const bool has_next = at + 1 < words.size();
  if ((word == "-p" || word == "--path") && has_next) file->options.paths.push_back(words[at + 1]);
  if (!word.starts_with(kPath)) return;
  for (word.remove_prefix(kPath.size()); !word.empty();) {
    const size_t end = std::min(word.find(':'), word.size());
    if (end > 0) file->options.paths.emplace_back(word.substr(0, end));
    word.remove_prefix(std::min(end + 1, word.size()));
  }
}

/// Lines NAME=VALUE of a file; what the command line gives, wins.
void LaunchPlanDraft::AddMacros(const std::string& name, int line, ShellRun* run,
                                LaunchFile* file) {
  constexpr size_t kMostMacros = 10'000;
  const std::string* made = run->FindMade(name);
  const auto found = made == nullptr ? run->Find(name) : std::nullopt;
  if (made == nullptr && !found) {
    return run->Note(line, fmt::format("{} is not there", Quoted(name)));
  }
  std::string_view rest = found ? std::string_view(found->text) : *made;
  while (!rest.empty()) {
    if (file->defines.size() >= kMostMacros) {
      return run->Note(line, fmt::format("{} has more than {} macros", Quoted(name), kMostMacros));
    }
    const size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view text = Trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const size_t equals = text.find('=');
    const bool is_remark = text.starts_with('#') || text.starts_with("//");
    if (is_remark || equals == text.npos || equals == 0) continue;
    std::string_view value = Trimmed(text.substr(equals + 1));
    if (value.size() >= 2 && value.starts_with('"') && value.ends_with('"')) {
      value = value.substr(1, value.size() - 2);
    }
    file->defines.emplace(Trimmed(text.substr(0, equals)), value);
  }
}

void LaunchPlanDraft::TakePoke(const ShellWords& words, int line, const ShellRun& run) {
  constexpr size_t kMostPokes = 200;
  MoosButton poke{.key = "upokedb",
                  .label = "",
                  .origins = fmt::format("{}:{}", run.script().name, line),
                  .posts = {}};
  for (const std::string& word : words) {
    if (word.starts_with('>') || word == "&") break;
    if (word.starts_with('-') || word.ends_with(".moos")) continue;
    const size_t equals = word.find('=');
    if (equals == word.npos || equals == 0) continue;
    const bool is_text = word[equals - 1] == ':';
    if (is_text && word.find(":=", equals + 1) != word.npos) continue;  // It refuses that.
    poke.posts.emplace_back(word.substr(0, equals - (is_text ? 1 : 0)), word.substr(equals + 1));
  }
  if (!poke.posts.empty() && plan_.pokes.size() < kMostPokes) {
    plan_.pokes.push_back(std::move(poke));
  }
}

void LaunchPlanDraft::AddFile(LaunchFile file) {
  if (!IsPlanned(file)) return;
  if (LaunchFile* earlier = FindFile(file)) {
    *earlier = std::move(file);
    return;
  }
  if (plan_.files.size() < kMostFiles) plan_.files.push_back(std::move(file));
}

void LaunchPlanDraft::AddPlain(const std::string& name, const ShellRun& run) {
  LaunchFile file{.source = name, .target = FileName(name), .defines = {}};
  if (!IsPlanned(file) || FindFile(file) != nullptr || !run.Find(name)) return;
  if (plan_.files.size() < kMostFiles) plan_.files.push_back(std::move(file));
}

LaunchFile* LaunchPlanDraft::FindFile(const LaunchFile& file) {
  for (LaunchFile& earlier : plan_.files) {
    if (FileName(earlier.target) == FileName(file.target)) return &earlier;
  }
  return nullptr;
}

}  // namespace shoal
