// `shoal docs KEY|WORDS`: what the pages of docs/ state about it, and where.
#pragma once

#include <string>
#include <vector>

#include "apps/shoal/page_search.h"
#include "lib/base/check/result.h"

namespace shoal {

struct DocsOptions {
  std::vector<std::string> words;  ///< None: the list of pages.
  bool open = false;               ///< In a browser, as a page of the site where it is installed.
};

/// Reads all pages of a folder and those below, sorted by path: missions/ before all others, since
/// the keys of mission files are looked up most often. The error: index.md is not in it.
[[nodiscard]] Result<std::vector<PageSection>> ReadPages(const std::string& docs_folder);

/// Returns the answer for a terminal, for words with findings; `docs_folder` begins each path.
[[nodiscard]] std::string DocsText(const PageFindings& findings, const std::string& docs_folder);

/// Returns the file to open for the first of the findings (without any: index.md), with its anchor:
/// the site's page where the site is in `docs_folder`/html, else the text that the page is made of.
[[nodiscard]] std::string PlaceToOpen(const PageFindings& findings, const std::string& docs_folder);

/// Prints the answer, or opens its place. Returns the exit code.
int RunDocs(const DocsOptions& options);

}  // namespace shoal
