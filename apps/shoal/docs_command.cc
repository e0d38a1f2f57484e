#include "apps/shoal/docs_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/base/text/terminal_text.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/command_line/find_program.h"
#include "lib/run/command_line/own_files.h"
#include "lib/run/command_line/tool_commands.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// What fits on a screen or two; more is counted, and the place of the whole is printed anyway.
constexpr size_t kMaxRows = 12;
constexpr size_t kMaxLines = 40;
constexpr size_t kMaxSections = 3;
constexpr size_t kMaxPlaces = 10;

std::string PlaceOf(const PageSection& section, const std::string& docs_folder) {
  return fmt::format("{}:{}", (fs::path(docs_folder) / section.page).string(), section.line);
}

std::string HeadOf(const PageSection& section, const std::string& docs_folder) {
  return fmt::format("{}  ({})\n", section.heading, PlaceOf(section, docs_folder));
}

std::string MoreText(size_t number, size_t most, std::string_view what) {
  return number > most ? fmt::format("and {} {} more\n", number - most, what) : "";
}

std::string RowText(const FoundRow& found, const std::string& docs_folder) {
  std::string text = HeadOf(*found.section, docs_folder);
  for (const auto& [column, cell] : found.row->cells) {
    text +=
        column.empty() ? fmt::format("    {}\n", cell) : fmt::format("    {}: {}\n", column, cell);
  }
  return text;
}

std::string SectionText(const PageSection& section, const std::string& docs_folder) {
  std::string text = HeadOf(section, docs_folder);
  const size_t end = std::min(section.lines.size(), kMaxLines);
  for (size_t i = 0; i < end; ++i) text += PlainLine(section.lines[i]) + "\n";
  return text + MoreText(section.lines.size(), kMaxLines, "lines");
}

/// Returns the names of all keys and headings, for a word that no page has.
std::set<std::string> KnownWords(const std::vector<PageSection>& sections) {
  std::set<std::string> known;
  for (const PageSection& section : sections) {
    known.insert(LowerCase(section.heading));
    for (const PageRow& row : section.rows) {
      if (row.cells.empty() || row.cells.front().first != "key") continue;
      const std::string& cell = row.cells.front().second;
      for (size_t begin = cell.find('`'); begin != cell.npos; begin = cell.find('`', begin)) {
        const size_t end = cell.find('`', begin + 1);
        if (end == cell.npos) break;
        known.insert(LowerCase(cell.substr(begin + 1, end - begin - 1)));
        begin = end + 1;
      }
    }
  }
  return known;
}

std::string NotFoundText(const std::vector<PageSection>& sections, const std::string& words) {
  const std::set<std::string> known = KnownWords(sections);
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  return fmt::format("no page has {}{}; `shoal docs` lists the pages", Quoted(words),
                     DidYouMean(LowerCase(words), candidates));
}

bool IsEmpty(const PageFindings& findings) {
  return findings.rows.empty() && findings.headings.empty() && findings.texts.empty();
}

const PageSection* FirstOf(const PageFindings& findings) {
  if (!findings.rows.empty()) return findings.rows.front().section;
  if (!findings.headings.empty()) return findings.headings.front();
  return findings.texts.empty() ? nullptr : findings.texts.front();
}

/// Returns chapters and pages, as index.md lists them.
std::string ListOfPages(const std::vector<PageSection>& sections, const std::string& docs_folder) {
  std::string text;
  for (const PageSection& section : sections) {
    if (section.page != "index.md" || section.rows.empty()) continue;
    text += section.heading + "\n";
    for (const PageRow& row : section.rows) {
      for (const auto& [column, cell] : row.cells) {
        text += column == "page" ? fmt::format("    {:<28}", cell) : cell;
      }
      text += "\n";
    }
  }
  return text +
         fmt::format("\nThese pages are in {}; `shoal docs WORD` searches them.\n", docs_folder);
}

int Fail(const std::string& error, ExitCode code) {
  fmt::print(stderr, "shoal: {}\n", error);
  return code;
}

/// Turns this process into the desktop's program for files.
int OpenPlace(const std::string& place) {
  const char* path = std::getenv("PATH");
  const std::string opener = FindExecutable("xdg-open", path == nullptr ? "" : path);
  if (!opener.empty()) return BecomeProgram(opener, {"file://" + place});
  return Fail(
      fmt::format("xdg-open is missing (sudo apt install xdg-utils). The page is {}", place),
      kExitEnvironment);
}

}  // namespace

Result<std::vector<PageSection>> ReadPages(const std::string& docs_folder) {
  std::vector<std::string> pages;
  std::error_code error;
  for (fs::recursive_directory_iterator at(docs_folder, error), end; !error && at != end;
       at.increment(error)) {
    if (at->path().extension() == ".md") {
      pages.push_back(at->path().lexically_relative(docs_folder).string());
    }
  }
  if (std::ranges::find(pages, "index.md") == pages.end()) {
    return Error{fmt::format("{} has no pages of shoal: index.md is missing", docs_folder)};
  }
  std::ranges::sort(pages, {}, [](const std::string& page) {
    return std::pair(!page.starts_with("missions/"), page);
  });
  std::vector<PageSection> sections;
  for (const std::string& page : pages) {
    std::ifstream in(fs::path(docs_folder) / page);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    AppendSections(page, text, &sections);
  }
  return sections;
}

std::string DocsText(const PageFindings& findings, const std::string& docs_folder) {
  std::vector<std::string> parts;
  for (size_t i = 0; i < std::min(findings.rows.size(), kMaxRows); ++i) {
    parts.push_back(RowText(findings.rows[i], docs_folder));
  }
  for (size_t i = 0; i < std::min(findings.headings.size(), kMaxSections); ++i) {
    parts.push_back(SectionText(*findings.headings[i], docs_folder));
  }
  std::string more = MoreText(findings.rows.size(), kMaxRows, "tables");
  const auto list = [&](const std::vector<const PageSection*>& all, size_t begin) {
    std::string places;
    const size_t end = std::min(all.size(), begin + kMaxPlaces);
    for (size_t i = begin; i < end; ++i) places += HeadOf(*all[i], docs_folder);
    return places + MoreText(all.size(), end, "sections");
  };
  if (findings.headings.size() > kMaxSections) more = list(findings.headings, kMaxSections);
  if (!findings.texts.empty()) more = list(findings.texts, 0);
  if (!more.empty()) parts.push_back(std::move(more));
  return TerminalText(fmt::format("{}", fmt::join(parts, "\n")));
}

std::string PlaceToOpen(const PageFindings& findings, const std::string& docs_folder) {
  const PageSection* section = FirstOf(findings);
  const fs::path page = section == nullptr ? "index.md" : section->page;
  const std::string anchor = section == nullptr ? "" : "#" + section->anchor;
  fs::path site = fs::path(docs_folder) / "html/docs" / page;
  site.replace_extension(".html");
  std::error_code error;
  if (fs::exists(site, error)) return site.string() + anchor;
  return (fs::path(docs_folder) / page).string();
}

int RunDocs(const DocsOptions& options) {
  const std::optional<std::string> index = FindOwnFile("docs/index.md", ExecutableDirectory());
  if (!index) {
    return Fail(
        "the pages of shoal are not on this machine: they come with the package "
        "(share/doc/shoal) and with the sources (docs/)",
        kExitEnvironment);
  }
  const std::string folder = fs::path(*index).parent_path().string();
  const Result<std::vector<PageSection>> sections = ReadPages(folder);
  if (!sections.ok()) return Fail(sections.error(), kExitEnvironment);
  const std::string words = fmt::format("{}", fmt::join(options.words, " "));
  const PageFindings findings = FindInPages(*sections, words);
  if (!words.empty() && IsEmpty(findings)) {
    return Fail(NotFoundText(*sections, words), kExitUsage);
  }
  if (options.open) return OpenPlace(PlaceToOpen(findings, folder));
  fmt::print("{}", words.empty() ? ListOfPages(*sections, folder) : DocsText(findings, folder));
  return kExitOk;
}

}  // namespace shoal
