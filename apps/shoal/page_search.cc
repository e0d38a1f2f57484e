#include "apps/shoal/page_search.h"

#include <algorithm>
#include <cstddef>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"

namespace shoal {

namespace {

constexpr std::string_view kIndexOfKeys = "reference/mission_keys.md";

/// Returns the anchor of a heading, as GitHub and scripts/docs make it.
std::string AnchorOf(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    if (IsNameCharacter(c) || c == '-') anchor += LowerCase(c);
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

/// Returns the cells between the '|' of a table's row; "\|" is part of a cell.
std::vector<std::string> CellsOf(std::string_view line) {
  std::vector<std::string> cells;
  std::string cell;
  for (size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') {
      cell += line[++i];
    } else if (line[i] == '|') {
      cells.push_back(PlainLine(Trimmed(cell)));
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  return cells;
}

bool IsRule(std::string_view line) { return line.find_first_not_of("|-: ") == line.npos; }

/// Reads the lines of one page.
class PageReader {
 public:
  PageReader(std::string_view page, std::vector<PageSection>* sections)
      : page_(page), sections_(sections) {}

  void Read(std::string_view line) {
    ++number_;
    if (line.starts_with("```")) is_code_ = !is_code_;
    if (!is_code_ && line.starts_with('#')) {
      BeginSection(line.substr(std::min(line.find_first_not_of('#'), line.size())));
      return;
    }
    if (number_ == 1) BeginSection(page_);
    sections_->back().lines.emplace_back(line);
    ReadRow(line);
  }

 private:
  void BeginSection(std::string_view heading) {
    const std::string text = PlainLine(Trimmed(heading));
    sections_->push_back({.page = std::string(page_),
                          .heading = text,
                          .anchor = AnchorOf(text),
                          .line = number_,
                          .lines = {},
                          .rows = {}});
    columns_.clear();
  }

  void ReadRow(std::string_view line) {
    if (is_code_ || !line.starts_with('|')) {
      columns_.clear();
      return;
    }
    std::vector<std::string> cells = CellsOf(line);
    if (columns_.empty()) {
      columns_ = std::move(cells);
      return;
    }
    if (IsRule(line)) return;
    PageRow row;
    for (size_t i = 0; i < std::min(cells.size(), columns_.size()); ++i) {
      if (!cells[i].empty()) row.cells.emplace_back(columns_[i], std::move(cells[i]));
    }
    sections_->back().rows.push_back(std::move(row));
  }

  std::string_view page_;
  std::vector<PageSection>* sections_;
  std::vector<std::string> columns_;
  int number_ = 0;
  bool is_code_ = false;
};

/// Returns how often `word` is in `text`, both in lower case, as a word of its own.
size_t CountOf(std::string_view text, std::string_view word) {
  size_t count = 0;
  for (size_t at = text.find(word); at != text.npos; at = text.find(word, at + word.size())) {
    const size_t end = at + word.size();
    const bool begins = at == 0 || !IsNameCharacter(text[at - 1]) || !IsNameCharacter(word.front());
    const bool ends =
        end == text.size() || !IsNameCharacter(text[end]) || !IsNameCharacter(word.back());
    count += begins && ends ? 1 : 0;
  }
  return count;
}

bool HasKey(const PageRow& row, const std::string& code) {
  constexpr size_t kKeyCells = 2;  // "| kind | key |": the key is in the second.
  const size_t end = std::min(row.cells.size(), kKeyCells);
  for (size_t i = 0; i < end; ++i) {
    const auto& [column, cell] = row.cells[i];
    if (i > 0 && column != "key") continue;
    if (LowerCase(cell).find(code) != std::string::npos) return true;
  }
  return false;
}

/// Returns the least of the counts of the words in a section; 0: it does not have all of them.
size_t CountOfAll(const PageSection& section, const std::vector<std::string_view>& words) {
  std::string text = LowerCase(section.heading);
  for (const std::string& line : section.lines) text += "\n" + LowerCase(line);
  size_t least = text.size();
  for (const std::string_view word : words) least = std::min(least, CountOf(text, word));
  return least;
}

std::vector<std::string_view> WordsOf(std::string_view text) {
  std::vector<std::string_view> words = TrimmedParts(text, ' ');
  std::erase(words, std::string_view());
  return words;
}

}  // namespace

std::string PlainLine(std::string_view line) {
  std::string plain;
  for (size_t i = 0; i < line.size(); ++i) {
    const size_t middle = line[i] == '[' ? line.find("](", i) : line.npos;
    const size_t end = middle == line.npos ? line.npos : line.find(')', middle);
    const std::string_view text = end == line.npos ? "" : line.substr(i + 1, middle - i - 1);
    if (!text.empty() && text.find('[') == text.npos) {
      if (plain.ends_with('!')) plain.back() = ' ';
      plain += text;
      i = end;
    } else if (line.substr(i, 2) == "**") {
      ++i;
    } else {
      plain += line[i];
    }
  }
  return plain;
}

void AppendSections(std::string_view page, std::string_view text,
                    std::vector<PageSection>* sections) {
  PageReader reader(page, sections);
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    reader.Read(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

PageFindings FindInPages(const std::vector<PageSection>& sections, std::string_view words) {
  const std::string wanted = LowerCase(Trimmed(words));
  PageFindings found;
  const std::vector<std::string_view> each = WordsOf(wanted);
  if (each.empty()) return found;
  std::vector<std::pair<size_t, const PageSection*>> counted;
  for (const PageSection& section : sections) {
    if (section.page == kIndexOfKeys) continue;
    for (const PageRow& row : section.rows) {
      if (HasKey(row, "`" + wanted + "`")) found.rows.push_back({&section, &row});
    }
    if (CountOf(LowerCase(section.heading), wanted) > 0) found.headings.push_back(&section);
    const size_t count = CountOfAll(section, each);
    if (count > 0) counted.emplace_back(count, &section);
  }
  std::ranges::stable_partition(found.rows, [](const FoundRow& one) {
    return one.row->cells.front().first.starts_with("key");
  });
  if (!found.rows.empty()) return {.rows = std::move(found.rows), .headings = {}, .texts = {}};
  if (!found.headings.empty()) return found;
  std::ranges::stable_sort(counted, [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [count, section] : counted) found.texts.push_back(section);
  return found;
}

}  // namespace shoal
