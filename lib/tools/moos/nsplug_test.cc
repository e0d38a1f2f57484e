#include "lib/tools/moos/nsplug.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lib/tools/moos/launch_script.h"
#include "tests/golden/read_golden.h"

namespace shoal::nsplug_test {

using Files = std::map<std::string, std::string>;

FindMoosFile Finder(const Files& files) {
  return [&files](std::string_view name, std::string_view) -> std::optional<MoosSource> {
    const auto at = files.find(std::string(name));
    if (at == files.end()) return std::nullopt;
    return MoosSource{.name = at->first, .text = at->second};
  };
}

/// Returns the lines that are the file's own, one below the other.
std::string Own(const PluggedText& text) {
  std::string own;
  for (const PluggedLine& line : text.lines) {
    if (line.reason.empty()) own += line.text + "\n";
  }
  return own;
}

std::string Plugged(const std::string& text, const MoosDefines& defines = {},
                    const Files& files = {}) {
  return Own(Plug({.name = "a", .text = text}, defines, Finder(files)));
}

/// Returns the reasons of lines at which something is lost.
std::vector<std::string> Losses(const std::string& text, const Files& files = {}) {
  std::vector<std::string> losses;
  for (const PluggedLine& line : Plug({.name = "a", .text = text}, {}, Finder(files)).lines) {
    if (!line.reason.empty() && line.is_loss) losses.push_back(line.origin + " " + line.reason);
  }
  return losses;
}

TEST(Plug, PutsValuesInThePlaceOfMacros) {
  EXPECT_EQ(Plugged("speed = $(V)\ngroup = %(TEAM)_x\n", {{"V", "1.5"}, {"TEAM", "red"}}),
            "speed = 1.5\ngroup = RED_x\n");
  EXPECT_EQ(Plugged("a = $(V:=2)$(W:=3)%(X:=yes)", {{"V", "1"}}), "a = 13YES\n");
  EXPECT_EQ(Plugged("a = $(V) $[W] $(", {}), "a = $(V) $[W] $(\n");
}

TEST(Plug, TakesADefineOfTheFileInThePlaceOfAGivenValueAndWarns) {
  EXPECT_EQ(Plugged("#define V 3\na = $(V)\n"), "a = 3\n");
  const PluggedText text = Plug({.name = "a", .text = "#define V 3\na = $(V)\n"}, {{"V", "4"}}, {});
  EXPECT_EQ(Own(text), "a = 3\n");
  EXPECT_TRUE(text.lines[0].is_loss);
  EXPECT_EQ(text.lines[0].reason, "is taken from here on, and not '4' as before");
  EXPECT_EQ(Losses("#define\n#define a,b 2\n").size(), 2U);
}

TEST(Plug, KeepsALineWithOneMacroThatHasNoValueAsItIsWritten) {
  const PluggedText text =
      Plug({.name = "a", .text = "a = $(V), $(W)\nb = $(V) // $(W)\n"}, {{"V", "1"}}, {});
  EXPECT_EQ(Own(text), "a = $(V), $(W)\nb = $(V)\n");
  EXPECT_EQ(text.lines[0].unknown, "$(W)");
  EXPECT_EQ(text.lines[1].unknown, "$(W)");
}

/// Reads a file of a golden case; nothing where it is not there.
std::optional<std::string> ReadCase(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

/// Returns the arguments as a script has them: what is in quotes stays, $ is not a variable.
std::string AsShell(const std::string& arguments) {
  std::string text;
  bool is_quoted = false;
  for (const char c : arguments) {
    if (c == '\'') is_quoted = !is_quoted;
    if (c == '$' && !is_quoted) text += '\\';
    text += c;
  }
  return text;
}

TEST(Plug, MakesOfEveryGoldenCaseWhatNsplugWroteAndNamesWhatItRefused) {
  namespace fs = std::filesystem;
  size_t num_cases = 0;
  for (const auto& entry : fs::directory_iterator(GoldenPath("moos_import/nsplug"))) {
    SCOPED_TRACE(entry.path().filename());
    ++num_cases;
    // Beside the file that asks; files that were there before nsplug ran are there too.
    const FindMoosFile find = [&](std::string_view name,
                                  std::string_view from) -> std::optional<MoosSource> {
      const fs::path place = fs::path(from).parent_path() / name;
      auto text = ReadCase(entry.path() / place);
      if (!text) text = ReadCase(entry.path() / "before" / place);
      if (!text) return std::nullopt;
      return MoosSource{.name = place.string(), .text = *text};
    };
    const LaunchPlan plan = ReadLaunchScript(
        {.name = "launch.sh", .text = "nsplug " + AsShell(*ReadCase(entry.path() / "args"))}, find);
    ASSERT_EQ(plan.files.size(), 1U);
    const LaunchFile& file = plan.files.front();
    EXPECT_EQ(file.target, "targ.bhv");
    const auto source = find(file.source, "launch.sh");
    const bool is_written = fs::exists(entry.path() / "expected.bhv");
    if (!source) {
      EXPECT_EQ(entry.path().filename(), "80-input-missing");  // What reads the plan names it.
      EXPECT_FALSE(is_written);
      continue;
    }
    const PluggedText text = Plug(*source, file.defines, find, file.options);
    if (is_written) {
      // The second run drops the comments and the blanks, as the first did.
      EXPECT_EQ(Own(text), Plugged(*ReadCase(entry.path() / "expected.bhv")));
      continue;
    }
    const bool is_named =
        std::any_of(text.lines.begin(), text.lines.end(),
                    [](const PluggedLine& line) { return !line.reason.empty() && line.is_loss; });
    EXPECT_TRUE(is_named || !plan.notes.empty());
  }
  EXPECT_EQ(num_cases, 58U);
}

TEST(Plug, NamesWhatStrictRefuses) {
  const PluggedText text =
      Plug({.name = "a", .text = "x = 1\ny = $(V)\n"}, {}, {}, {.is_strict = true});
  ASSERT_EQ(text.lines.size(), 2U);
  EXPECT_EQ(text.lines[1].reason,
            "is without a value for $(V): with --strict nsplug writes nothing of this file, whose "
            "other lines count here");
  EXPECT_TRUE(text.lines[1].is_loss);
}

TEST(Plug, FindsIncludedFilesInFoldersOfTheCommandLine) {
  const Files files = {{"far/p", "x\n"}};
  EXPECT_EQ(Own(Plug({.name = "a", .text = "#include p\n"}, {}, Finder(files),
                     {.paths = {"near", "far"}})),
            "x\n");
}

TEST(Plug, WarnsOfASectionThatIsNotThere) {
  const Files files = {{"p", "<tag><one>\n1\n<two>\n"}};
  EXPECT_EQ(Losses("#include p <two>\n", files),
            (std::vector<std::string>{
                "a:1 is without effect: p has no line <tag><two>; its sections: one"}));
}

TEST(Plug, KeepsTheBranchThatIsTheCase) {
  const std::string text =
      "#ifdef MODE SIM\na\n#elseifdef MODE REAL\nb\n#else\nc\n#endif\n#ifndef MODE\nd\n#endif\n";
  EXPECT_EQ(Plugged(text, {{"MODE", "SIM"}}), "a\n");
  EXPECT_EQ(Plugged(text, {{"MODE", "REAL"}}), "b\n");
  EXPECT_EQ(Plugged(text, {{"MODE", "\"\""}}), "c\n");
  EXPECT_EQ(Plugged(text), "c\nd\n");
  EXPECT_EQ(Plugged("#ifdef A || B 2\nx\n#endif\n", {{"B", "2"}}), "x\n");
  EXPECT_EQ(Plugged("#ifdef A && B 2\nx\n#endif\n", {{"B", "2"}}), "");
  EXPECT_EQ(Plugged("#ifdef A && B 2\nx\n#endif\n", {{"A", ""}, {"B", "2"}}), "x\n");
}

TEST(Plug, NestsBranches) {
  const std::string text =
      "#ifdef A\n#ifdef B\nab\n#else\na\n#endif\n#else\n#ifdef B\nb\n#endif\n#endif\nz\n";
  EXPECT_EQ(Plugged(text, {{"A", "1"}, {"B", "1"}}), "ab\nz\n");
  EXPECT_EQ(Plugged(text, {{"A", "1"}}), "a\nz\n");
  EXPECT_EQ(Plugged(text, {{"B", "1"}}), "b\nz\n");
  EXPECT_EQ(Plugged(text), "z\n");
}

TEST(Plug, NamesWhatIsLeftOutWithoutCallingItALoss) {
  const PluggedText text = Plug({.name = "a", .text = "x\n#ifdef A\ny\n#endif\n"}, {}, {});
  ASSERT_EQ(text.lines.size(), 2U);
  EXPECT_EQ(text.lines[1].origin, "a:2");
  EXPECT_TRUE(text.lines[1].reason.starts_with("is not the case")) << text.lines[1].reason;
  EXPECT_FALSE(text.lines[1].is_loss);
}

TEST(Plug, RefusesBranchesWithoutABeginningOrAnEnd) {
  EXPECT_EQ(
      Losses("#endif\n#else\n#ifdef A\n#else\n#else\n#ifdef\n"),
      (std::vector<std::string>{
          "a:1 is without #ifdef", "a:2 is without #ifdef",
          "a:5 is without effect: an #else is before it", "a:6 is without the name of a macro",
          "a:6 is not closed: write #endif", "a:3 is not closed: write #endif"}));
}

TEST(Plug, PutsIncludedLinesInTheirPlaceWithTheirOrigin) {
  const Files files = {{"p", "#define V 2\nin = $(V)\n"}};
  const PluggedText text =
      Plug({.name = "dir/a", .text = "one\n#include \"p\"\ntwo = $(V)\n"}, {}, Finder(files));
  EXPECT_EQ(Own(text), "one\nin = 2\ntwo = 2\n");
  ASSERT_EQ(text.lines.size(), 5U);
  EXPECT_EQ(text.lines[3].origin, "p:2");
  EXPECT_EQ(text.lines[4].origin, "dir/a:3");
  EXPECT_LT(text.lines[3].number, text.lines[4].number);
}

TEST(Plug, TakesOnlyThePartBehindATag) {
  const Files files = {{"p", "zero\n<tag><one>\n1\n<tag><two>\n2\n22\n"}};
  EXPECT_EQ(Plugged("#include p <two>\n", {}, files), "2\n22\n");
  EXPECT_EQ(Plugged("#include <p>\n", {}, {{"p", "x\n"}}), "x\n");
}

TEST(Plug, ReplacesMacrosInTheNamesOfIncludedFiles) {
  EXPECT_EQ(Plugged("#include p_$(V).bhv\n", {{"V", "a"}}, {{"p_a.bhv", "x\n"}}), "x\n");
}

TEST(Plug, RefusesAFileThatIncludesItself) {
  const Files files = {{"a", ""}, {"b", "#include c\n"}, {"c", "c1\n#include b\nc2\n"}};
  EXPECT_EQ(Losses("#include b\n#include a\n", files),
            (std::vector<std::string>{"c:2 is in a circle: the file includes itself",
                                      "a:2 is in a circle: the file includes itself"}));
  EXPECT_EQ(Plugged("#include b\n", {}, files), "c1\nc2\n");
}

TEST(Plug, NamesAFileThatIsNotThere) {
  EXPECT_EQ(Losses("#include no.bhv\n"),
            (std::vector<std::string>{
                "a:1 is for nsplug, and no file 'no.bhv' is there or below: name its "
                "folder with --path"}));
}

TEST(Plug, EndsWithFilesThatIncludeOneAnotherTwice) {
  Files files;
  for (int i = 0; i < 30; ++i) {
    const std::string next = "f" + std::to_string(i + 1);
    files["f" + std::to_string(i)] = "#include " + next + "\n#include " + next + "\n";
  }
  const PluggedText text = Plug({.name = "a", .text = "#include f0\n"}, {}, Finder(files));
  EXPECT_LT(text.lines.size(), 3'000U);
  EXPECT_TRUE(text.lines.back().is_loss);
}

TEST(Plug, EndsWithMacrosThatDoubleOneAnother) {
  std::string text = "#define A0 xxxxxxxxxxxxxxxx\n";
  for (int i = 0; i < 40; ++i) {
    const std::string value = "$(A" + std::to_string(i) + ")";
    text += "#define A" + std::to_string(i + 1) + " " + value + value + "\n";
  }
  const PluggedText plugged = Plug({.name = "a", .text = text}, {}, {});
  for (const PluggedLine& line : plugged.lines) EXPECT_LT(line.text.size(), 5'000U);
  std::string wide = "#define A " + std::string(4'000, 'x') + "\n";
  for (int i = 0; i < 1'000; ++i) wide += "$(A)$(A)$(A)$(A)$(A)$(A)$(A)$(A)\n";
  const PluggedText bounded = Plug({.name = "a", .text = wide}, {}, {});
  EXPECT_LT(bounded.lines.size(), 1'000U);
  EXPECT_TRUE(bounded.lines.back().reason.starts_with("is too much"));
}

RC_GTEST_PROP(Plug, AcceptsAnyText, ()) {
  const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "#ifdef ", "#ifndef ", "#else\n", "#elseif ", "#endif\n", "#define ", "#include ", "A", "B",
      "\n", "\n", " ", "$(A)", "%(B)", "$(A:=", ")", "||", "&&", "p", "q", "<t>", "\xff", "//",
      "\"", "$(", "x = 1\n"));
  std::string text;
  for (const std::string& word : words) text += word;
  const Files files = {{"p", text}, {"q", "#include p\n" + text}};
  const PluggedText plugged = Plug({.name = "a", .text = text}, {{"A", text}}, Finder(files));
  for (const PluggedLine& line : plugged.lines) {
    RC_ASSERT(!line.text.empty());
    RC_ASSERT(line.text.find('\n') == std::string::npos);
    RC_ASSERT(line.reason.empty() || line.reason.starts_with("is "));
  }
}

TEST(CleanUtf8, KeepsUtf8AndReplacesTheRest) {
  EXPECT_EQ(CleanUtf8("a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x90\x9F"),
            "a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x90\x9F");
  EXPECT_EQ(CleanUtf8("a\tb\x01\x7F"), "a b??");
  EXPECT_EQ(CleanUtf8("\xC0\xAF|\xED\xA0\x80|\xF4\x90\x80\x80|\xE2\x82"), "??|???|????|??");
}

}  // namespace shoal::nsplug_test
