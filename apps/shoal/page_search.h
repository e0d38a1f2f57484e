// Finds what the pages of docs/ state about a key, a heading or a word.
//
//   std::vector<PageSection> sections;
//   AppendSections("missions/networks.md", text, &sections);
//   const PageFindings found = FindInPages(sections, "comms_range");
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shoal {

/// A row of a table: the names of its columns, each with the text of its cell. Links have become
/// their texts, and empty cells are left out.
struct PageRow {
  std::vector<std::pair<std::string, std::string>> cells;
};

/// A heading of a page, and what is below it up to the next heading of any level.
struct PageSection {
  std::string page;     ///< Path below docs/, "missions/networks.md".
  std::string heading;  ///< Without '#': "[comms]".
  std::string anchor;   ///< As a browser has it: "comms".
  int line = 0;         ///< Of the heading, from 1.
  std::vector<std::string> lines;
  std::vector<PageRow> rows;  ///< Of all its tables.
};

/// Appends the sections of a page. Lines of code count as text, and as neither headings nor tables.
void AppendSections(std::string_view page, std::string_view text,
                    std::vector<PageSection>* sections);

struct FoundRow {
  const PageSection* section;
  const PageRow* row;
};

/// Points into the sections. At most one of the lists has elements: the most exact kind of answer.
struct PageFindings {
  std::vector<FoundRow> rows;                ///< Tables whose first or second cell is this key;
                                             ///< first those whose column is called "key".
  std::vector<const PageSection*> headings;  ///< Sections with these words in the heading.
  std::vector<const PageSection*> texts;     ///< Sections with all words, most frequent first.
};

/// Letters may be of either case. `words`: one key ("comms_range", "[[event]]"), or several words
/// with blanks between them. The index of keys, reference/mission_keys.md, does not count.
[[nodiscard]] PageFindings FindInPages(const std::vector<PageSection>& sections,
                                       std::string_view words);

/// Returns a line without the marks of Markdown: links become their texts, "**x**" becomes x.
[[nodiscard]] std::string PlainLine(std::string_view line);

}  // namespace shoal
