// The words of the project are the field's: nodes publish and subscribe, vehicles receive reports,
// functions return, errors state. This test finds the old ones; docs/inside/style.md names the new
// ones. What must stay stands in tests/words_allowed.txt.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shoal::words_test {

namespace fs = std::filesystem;

const fs::path kRoot = SHOAL_SOURCE_DIR;

constexpr std::array kPlaces = {
    "lib",  "apps", "sim",   "tests",  "examples",  "scripts",      "lcmtypes",       "missions",
    "docs", "web",  "cmake", "python", "README.md", "CHANGELOG.md", "CONTRIBUTING.md"};

// Other people's files, data, and the two files that name the words.
constexpr std::array kLeftOut = {"web/vendor",          "tests/golden",
                                 "tests/fuzz/corpus",   "node_modules",
                                 "tests/words_test.cc", "tests/words_allowed.txt",
                                 ".mypy_cache",         "tests/fuzz/make_micromodem_corpus.py"};

const std::set<std::string, std::less<>> kWords = {
    "say",      "says",      "said",     "saying",  "hear",   "hears",   "heard",    "hearing",
    "tell",     "tells",     "told",     "telling", "who",    "whom",    "nobody",   "everybody",
    "somebody", "anybody",   "mend",     "mends",   "mended", "mending", "stranger", "strangers",
    "speak",    "speaks",    "speaking", "spoken",  "speech", "talk",    "talks",    "talked",
    "talking",  "talkative", "obey",     "obeys"};

constexpr std::array kPhrases = {"so many", "so much", "through the water", "hardly meant"};

// "Who" is right of people.
constexpr std::array kPeople = {"people who", "person who",     "users who",
                                "user who",   "those who",      "readers who",
                                "reader who", "developers who", "anyone who"};

/// Returns the first word or phrase of the list in a line, or an empty text. Names with '_' are one
/// word.
std::string OldWordIn(const std::string& line) {
  std::string text(line);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string_view people : kPeople) {
    for (size_t at = text.find(people); at != text.npos; at = text.find(people)) {
      text.replace(at, people.size(), " ");
    }
  }
  for (const std::string_view phrase : kPhrases) {
    if (text.find(phrase) != text.npos) return std::string(phrase);
  }
  const auto is_of_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  for (auto begin = text.begin(); begin != text.end();) {
    begin = std::find_if(begin, text.end(), is_of_word);
    const auto end = std::find_if_not(begin, text.end(), is_of_word);
    const std::string_view word(begin, end);
    if (kWords.contains(word)) return std::string(word);
    begin = end;
  }
  return {};
}

/// Pairs of a file and a part of a line that may stay.
std::vector<std::pair<std::string, std::string>> Allowed() {
  std::vector<std::pair<std::string, std::string>> allowed;
  std::ifstream in(kRoot / "tests/words_allowed.txt");
  for (std::string line; std::getline(in, line);) {
    const size_t colon = line.find(": ");
    if (line.empty() || line.starts_with('#') || colon == line.npos) continue;
    allowed.emplace_back(line.substr(0, colon), line.substr(colon + 2));
  }
  return allowed;
}

bool IsRead(const std::string& file) {
  constexpr std::array kEndings = {".h",   ".cc",    ".c",    ".md",  ".lcm", ".toml",
                                   ".js",  ".mjs",   ".html", ".css", ".in",  ".cmake",
                                   ".txt", ".proto", ".json", ".py",  ""};
  const std::string ending = fs::path(file).extension().string();
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end() &&
         std::none_of(kLeftOut.begin(), kLeftOut.end(),
                      [&](const char* part) { return file.find(part) != std::string::npos; });
}

void AppendOldWords(const fs::path& path,
                    const std::vector<std::pair<std::string, std::string>>& allowed,
                    std::vector<std::string>* found) {
  const std::string file = fs::relative(path, kRoot).string();
  if (!IsRead(file)) return;
  std::ifstream in(path);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::string word = OldWordIn(line);
    if (word.empty()) continue;
    if (std::any_of(allowed.begin(), allowed.end(), [&](const auto& each) {
          return each.first == file && line.find(each.second) != line.npos;
        })) {
      continue;
    }
    found->push_back(file + ":" + std::to_string(number) + ": '" + word + "' in: " + line);
  }
}

TEST(OldWords, AreFoundInProseAndLeftAloneInNames) {
  EXPECT_EQ(OldWordIn("// The broker says what it Heard."), "says");
  EXPECT_EQ(OldWordIn("it heard bravo"), "heard");
  EXPECT_EQ(OldWordIn("Sent through the water."), "through the water");
  EXPECT_EQ(OldWordIn("the vehicle who sent it"), "who");
  EXPECT_EQ(OldWordIn("for users who know MOOS"), "");
  EXPECT_EQ(OldWordIn("contact.is_heard = whole(mission_told);"), "");
}

TEST(OldWords, StandNowhere) {
  const auto allowed = Allowed();
  std::vector<std::string> found;
  for (const char* place : kPlaces) {
    const fs::path path = kRoot / place;
    if (fs::is_regular_file(path)) {
      AppendOldWords(path, allowed, &found);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(path)) {
      if (entry.is_regular_file()) AppendOldWords(entry.path(), allowed, &found);
    }
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, std::vector<std::string>());
}

}  // namespace shoal::words_test
