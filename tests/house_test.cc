// Rules of the project that a compiler does not check; docs/inside/design.md states their reasons.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/channels.h"

namespace shoal::house_test {

namespace fs = std::filesystem;

const fs::path kRoot = SHOAL_SOURCE_DIR;

struct Line {
  std::string where;  ///< "lib/bus/bus/bus.h:12"
  std::string file;   ///< "lib/bus/bus/bus.h"
  std::string text;   ///< Without a // comment.
};

/// Returns every line of the C++ files below `folder`, tests left out.
std::vector<Line> CodeBelow(const std::string& folder) {
  std::vector<Line> lines;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    const fs::path& path = entry.path();
    const std::string name = path.filename().string();
    const bool is_code = path.extension() == ".h" || path.extension() == ".cc";
    if (!is_code || name.ends_with("_test.cc")) continue;
    std::ifstream in(path);
    int number = 0;
    for (std::string text; std::getline(in, text);) {
      ++number;
      const std::string file = fs::relative(path, kRoot).string();
      lines.push_back({.where = file + ":" + std::to_string(number),
                       .file = file,
                       .text = text.substr(0, text.find("//"))});
    }
  }
  return lines;
}

std::vector<std::string> Offences(const std::vector<Line>& lines,
                                  const std::function<bool(const Line&)>& offends) {
  std::vector<std::string> found;
  for (const Line& line : lines) {
    if (offends(line)) found.push_back(line.where + ": " + line.text);
  }
  return found;
}

/// Returns the rooms of the pure floors, as cmake/Shoal.cmake lists them.
std::vector<std::string> PureFolders() {
  std::ifstream in(kRoot / "cmake/Shoal.cmake");
  constexpr std::string_view kList = "set(SHOAL_PURE_FLOORS ";
  std::vector<std::string> folders;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(kList)) continue;
    std::istringstream floors(line.substr(kList.size(), line.size() - kList.size() - 1));
    for (std::string floor; floors >> floor;) {
      for (const auto& room : fs::directory_iterator(kRoot / "lib" / floor)) {
        if (room.is_directory()) folders.push_back(fs::relative(room.path(), kRoot).string());
      }
    }
  }
  return folders;
}

const std::vector<std::string> kNone;

TEST(PureLibraries, AreThoseThatTheDesignNames) {
  const std::vector<std::string> folders = PureFolders();
  for (const char* name : {"lib/base/geometry", "lib/sea/acoustics", "lib/vehicle/control",
                           "lib/helm/behaviors", "lib/comms/routing"}) {
    EXPECT_NE(std::find(folders.begin(), folders.end(), name), folders.end()) << name;
  }
}

TEST(PureLibraries, KnowNoClockFileThreadOrEnvironment) {
  // <chrono> is allowed for its calendar, which is arithmetic; its clocks and time zones are not.
  const std::regex forbidden(
      R"(#include <(ctime|time\.h|sys/time\.h|random|fstream|filesystem|iostream|cstdio|thread|mutex|)"
      R"(atomic|future|unistd\.h|lcm/.*|fmt/.*)>|getenv|\bstd::rand\b|\w+_clock\b|)"
      R"(\bcurrent_zone\b|\bget_tzdb|#include "lib/(bus|mission|run|tools)/)");
  for (const std::string& folder : PureFolders()) {
    if (folder == "lib/base/check") continue;  // It prints broken invariants on standard error.
    EXPECT_EQ(Offences(CodeBelow(folder),
                       [&](const Line& line) { return std::regex_search(line.text, forbidden); }),
              kNone)
        << folder;
  }
}

/// Returns the C++ code of lib, apps and sim.
std::vector<Line> ProductCode() {
  std::vector<Line> lines;
  for (const char* folder : {"lib", "apps", "sim"}) {
    const std::vector<Line> below = CodeBelow(folder);
    lines.insert(lines.end(), below.begin(), below.end());
  }
  return lines;
}

TEST(Arithmetic, TakesElementaryFunctionsFromItsRoom) {
  const std::regex of_libm(R"(std::(a?(sin|cos|tan)h?|atan2|exp2?|expm1|log(2|10|1p)?|pow|)"
                           R"(cbrt|erfc?|[lt]gamma)\()");
  EXPECT_EQ(Offences(ProductCode(),
                     [&](const Line& line) {
                       return line.file.find("_testing.") == std::string::npos &&
                              std::regex_search(line.text, of_libm);
                     }),
            kNone);
}

/// True where `text` has a string literal that is a topic of the channel table, with or without the
/// underscore after which a vehicle's name follows.
bool WritesAChannelName(const std::string& text) {
  static const std::regex kLiteral(R"re("([A-Z][A-Z_]*)")re");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), kLiteral);
       it != std::sregex_iterator(); ++it) {
    std::string name = (*it)[1];
    if (name.ends_with('_')) name.pop_back();
    for (const ChannelRow& row : ChannelTable()) {
      if (row.topic == name) return true;
    }
  }
  return false;
}

TEST(ChannelNames, AreRecognizedInCode) {
  EXPECT_TRUE(WritesAChannelName(R"(if (channel == "NAV") return;)"));
  EXPECT_TRUE(WritesAChannelName(R"(f("x", "NODE_REPORT_"))"));
  EXPECT_FALSE(WritesAChannelName(R"(f("NAVY", "nav", "NODE_REPORT_ALPHA"))"));
}

TEST(ChannelNames, StandInChannelsAndNowhereElse) {
  EXPECT_EQ(Offences(ProductCode(),
                     [](const Line& line) {
                       // The table of the broker's rules names the channel of each rule;
                       // lib/bus/bus takes these names from there, since lib/comms/routing knows no
                       // bus.
                       return line.file != "lib/bus/bus/channels.h" &&
                              line.file != "lib/comms/routing/rules.h" &&
                              WritesAChannelName(line.text);
                     }),
            kNone);
}

TEST(Libraries, DoNotKnowTheApps) {
  EXPECT_EQ(Offences(CodeBelow("lib"),
                     [](const Line& line) {
                       return line.text.find("#include \"apps/") != std::string::npos ||
                              line.text.find("#include \"sim/") != std::string::npos;
                     }),
            kNone);
}

TEST(Apps, DoNotKnowEachOther) {
  EXPECT_EQ(Offences(CodeBelow("apps"),
                     [](const Line& line) {
                       const std::string app = line.file.substr(0, line.file.find('/', 5) + 1);
                       return line.text.find("#include \"apps/") != std::string::npos &&
                              line.text.find("#include \"" + app) == std::string::npos;
                     }),
            kNone);
}

TEST(ExpensiveHeaders, AreIncludedWhereTheyMustBeAndNowhereElse) {
  std::vector<Line> lines;
  for (const char* folder : {"lib", "apps", "sim"}) {
    const std::vector<Line> more = CodeBelow(folder);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  EXPECT_EQ(Offences(lines,
                     [](const Line& line) {
                       return line.text.find("#include <CLI/") != std::string::npos &&
                              line.file != "lib/run/command_line/command.cc";
                     }),
            kNone);
  EXPECT_EQ(Offences(lines,
                     [](const Line& line) {
                       return line.text.find("#include <toml++/") != std::string::npos &&
                              line.file != "lib/mission/toml/parse.cc";
                     }),
            kNone);
}

TEST(Clocks, AreReadInOnePlace) {
  std::vector<Line> lines = CodeBelow("lib");
  const std::vector<Line> apps = CodeBelow("apps");
  lines.insert(lines.end(), apps.begin(), apps.end());
  const std::regex clock(R"(clock_gettime|gettimeofday|_clock::now|\btime\(nullptr\))");
  EXPECT_EQ(Offences(lines,
                     [&](const Line& line) {
                       return std::regex_search(line.text, clock) &&
                              line.file != "lib/run/run/run_app.cc";
                     }),
            kNone);
}

/// Returns the outermost class of which a line at namespace level defines a member; else nothing.
std::string ClassOfMember(const std::string& line) {
  static const std::regex definition(
      R"(^(?:\w[\w:<>,*&\[\] ]*[*& ])?([A-Z]\w*)::(?:[A-Z]\w*::)*(?:~?\w+|operator\S+)(?:\(| = |\{))");
  static const std::regex other(R"(^(?:using|return|typedef|friend|#)\b)");
  std::smatch match;
  if (line.find("::") == std::string::npos || std::regex_search(line, other) ||
      !std::regex_search(line, match, definition)) {
    return {};
  }
  return match[1];
}

TEST(MemberDefinition, IsFoundForAnyReturnType) {
  EXPECT_EQ(ClassOfMember("void Router::Route(int n) {"), "Router");
  EXPECT_EQ(ClassOfMember("std::optional<std::vector<int>> Router::Table::Find(int n) const {"),
            "Router");
  EXPECT_EQ(ClassOfMember("Router::Router(int n) : n_(n) {}"), "Router");
  EXPECT_EQ(ClassOfMember("Router::~Router() = default;"), "Router");
  EXPECT_EQ(ClassOfMember("const std::array<Router::Row, 2> Router::kRows = {{"), "Router");
  EXPECT_EQ(ClassOfMember("Router& Router::operator=(Router&& other) {"), "Router");
  EXPECT_EQ(ClassOfMember("const Router::Row* Router::Find(std::string_view name) {"), "Router");
}

TEST(MemberDefinition, IsNotAUseOrAFreeFunction) {
  EXPECT_EQ(ClassOfMember("Router::Row MakeRow(int n) {"), "");
  EXPECT_EQ(ClassOfMember("constexpr auto kFirst = Router::State::kFirst;"), "");
  EXPECT_EQ(ClassOfMember("  Router::Route(n);"), "");
  EXPECT_EQ(ClassOfMember("return Router::Route(n);"), "");
  EXPECT_EQ(ClassOfMember("std::string fmt::Format(int n) {"), "");
}

TEST(Classes, HaveOneSourceFile) {
  std::map<std::string, std::set<std::string>> files_of;
  for (const char* folder : {"lib", "apps", "sim"}) {
    for (const Line& line : CodeBelow(folder)) {
      if (!line.file.ends_with(".cc")) continue;
      const std::string name = ClassOfMember(line.text);
      if (!name.empty()) files_of[name].insert(line.file);
    }
  }
  ASSERT_GT(files_of.size(), 50u);
  std::vector<std::string> spread;
  for (const auto& [name, files] : files_of) {
    if (files.size() < 2) continue;
    std::string text = name + ":";
    for (const std::string& file : files) text += " " + file;
    spread.push_back(text);
  }
  EXPECT_EQ(spread, kNone);
}

/// Returns the pages that a line names: "docs/reference/fates.md", "README.md". Web addresses and
/// patterns
/// ("app_*.md") are none.
std::vector<std::string> PagesNamedIn(const std::string& line) {
  constexpr std::string_view kEnding = ".md";
  const auto is_of_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  std::vector<std::string> pages;
  for (size_t at = line.find(kEnding); at != line.npos; at = line.find(kEnding, at + 1)) {
    const size_t end = at + kEnding.size();
    if (end < line.size() && is_of_word(line[end])) continue;
    size_t begin = at;
    while (begin > 0 && (is_of_word(line[begin - 1]) || line[begin - 1] == '-' ||
                         line[begin - 1] == '.' || line[begin - 1] == '/')) {
      --begin;
    }
    while (begin < at && line[begin] == '/') ++begin;
    const std::string_view before = std::string_view(line).substr(0, begin);
    if (begin < at && !before.ends_with("://")) pages.push_back(line.substr(begin, end - begin));
  }
  return pages;
}

/// True if `page` is a file: seen from the root, from docs/, or from the folder of `file`, which
/// names it.
bool PageExists(const std::string& file, const std::string& page) {
  return fs::exists(kRoot / page) || fs::exists((kRoot / file).parent_path() / page) ||
         fs::exists(kRoot / "docs" / page);
}

/// True for texts of the project. Left out are other people's, the changelog, which names pages of
/// former versions, tests that invent names, and scripts/docs, whose own check reads links.
bool MayNamePages(const std::string& file) {
  static constexpr std::array kLeftOut = {"web/vendor/",
                                          "node_modules/",
                                          "tests/house_test.cc",
                                          "apps/viewer/page_files_test.cc",
                                          "apps/shoal/docs_command_test.cc",
                                          "apps/shoal/page_search_test.cc",
                                          "lib/run/command_line/own_files_test.cc",
                                          "scripts/docs"};
  static constexpr std::array kEndings = {".h",    ".cc",  ".c",   ".md",    ".lcm", ".toml", ".js",
                                          ".html", ".css", ".txt", ".cmake", ".py",  ".in",   ""};
  const std::string ending = fs::path(file).extension().string();
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end() &&
         std::none_of(kLeftOut.begin(), kLeftOut.end(),
                      [&](const char* part) { return file.find(part) != std::string::npos; });
}

/// Appends "file:line: page" for each page that a text of the project names and that is missing.
void AppendMissingPages(const fs::path& path, std::vector<std::string>* missing) {
  const std::string file = fs::relative(path, kRoot).string();
  if (!MayNamePages(file)) return;
  std::ifstream in(path);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    for (const std::string& page : PagesNamedIn(line)) {
      if (PageExists(file, page)) continue;
      missing->push_back(file + ":" + std::to_string(number) + ": " + page);
    }
  }
}

TEST(NamedPages, AreFoundInCommentsAndLinks) {
  using Pages = std::vector<std::string>;
  EXPECT_EQ(PagesNamedIn("// As munet.md G13 has it; docs/reference/fates.md. And x.mdb."),
            (Pages{"munet.md", "docs/reference/fates.md"}));
  EXPECT_EQ(PagesNamedIn("[rooms](../lib/README.md#rooms), \"/docs/reference/channels.md\""),
            (Pages{"../lib/README.md", "docs/reference/channels.md"}));
  EXPECT_EQ(PagesNamedIn("docs/app_*.md, <name>.md, https://example.org/README.md"), Pages());
}

TEST(NamedPages, AreMissedWhereThereIsNoSuchFile) {
  EXPECT_TRUE(PageExists("lib/base/check/result.h", "docs/inside/design.md"));
  EXPECT_TRUE(PageExists("docs/inside/design.md", "style.md"));
  EXPECT_TRUE(PageExists("docs/inside/design.md", "../../lib/README.md"));
  EXPECT_TRUE(PageExists("lib/mission/file/rows_test.cc", "missions/mission_file.md"));
  EXPECT_FALSE(PageExists("lib/mission/file/rows_test.cc", "mission_file.md"));
  EXPECT_FALSE(PageExists("lib/base/check/result.h", "docs/no_such_page.md"));
  EXPECT_FALSE(PageExists("lib/vehicle/guidance/path_golden_test.cc", "munet.md"));
}

TEST(NamedPages, Exist) {
  std::vector<std::string> missing;
  for (const char* file : {"README.md", "CONTRIBUTING.md"}) {
    AppendMissingPages(kRoot / file, &missing);
  }
  for (const char* folder : {"apps", "campaigns", "cmake", "docs", "examples", "lcmtypes", "lib",
                             "missions", "packaging", "python", "scripts", "sim", "tests", "web"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (entry.is_regular_file()) AppendMissingPages(entry.path(), &missing);
    }
  }
  std::sort(missing.begin(), missing.end());
  EXPECT_EQ(missing, kNone);
}

}  // namespace shoal::house_test
