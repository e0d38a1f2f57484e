#include "lib/tools/moos/launch_script.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace shoal::launch_script_test {

using Files = std::map<std::string, std::string>;

/// Returns "SOURCE > TARGET A=1 B=2" for each file, and the notes.
std::string Plan(const std::string& text, const Files& files = {}) {
  const FindMoosFile find = [&](std::string_view name,
                                std::string_view) -> std::optional<MoosSource> {
    const auto at = files.find(std::string(name));
    if (at == files.end()) return std::nullopt;
    return MoosSource{.name = at->first, .text = at->second};
  };
  const LaunchPlan plan = ReadLaunchScript({.name = "launch.sh", .text = text}, find);
  std::string lines;
  for (const LaunchFile& file : plan.files) {
    lines += file.source + " > " + file.target;
    for (const auto& [name, value] : file.defines) lines += " " + name + "=" + value;
    lines += "\n";
  }
  for (const std::string& note : plan.notes) lines += note + "\n";
  return lines;
}

TEST(LaunchScript, TakesVariablesQuotesAndContinuedLines) {
  EXPECT_EQ(Plan("#!/bin/bash -e\nNAME1=\"ida\"  # the first\nPOS1=\"x=5,y=6\"\n"
                 "nsplug meta.moos targ_$NAME1.moos -f WARP=$WARP \\\n"
                 "   VNAME=$NAME1 START=\"$POS1\" NIGHT\n"),
            "meta.moos > targ_ida.moos NIGHT=<defined> START=x=5,y=6 VNAME=ida WARP=\n");
}

TEST(LaunchScript, TakesTheBranchesOfARunWithoutArguments) {
  EXPECT_EQ(
      Plan("MAKE=no\nfor ARGI; do\n if [ \"${ARGI}\" = \"-j\" ] ; then\n MAKE=yes\n fi\ndone\n"
           "if [ \"${MAKE}\" = \"yes\" -o -z \"$MAKE\" ]; then\n exit 0\nelif [ 2 -gt 1 -a $MAKE = "
           "no ]\n"
           "then\n A=1\nelse A=2\nfi\n[ -n \"$A\" ] && B=3\n"
           "nsplug a.bhv b.bhv A=$A B=$B\nexit 0\nnsplug c.bhv d.bhv\n"),
      "a.bhv > b.bhv A=1 B=3\n");
}

TEST(LaunchScript, TakesTheCaseThatMatches) {
  const std::string script =
      "X=$1\ncase \"$X\" in\n  -a|--all) Y=all ;;\n  \"\")\n    case z in y) Y=1;; z) Y=2; Z=3;; "
      "esac\n"
      "    ;;\n  *) Y=other ;;\nesac\nnsplug a.moos b.moos Y=$Y Z=$Z\n";
  EXPECT_EQ(Plan(script), "a.moos > b.moos Y=2 Z=3\n");
  EXPECT_EQ(Plan("case --all in -a|--a*) Y=1;; *) Y=2;; esac\nnsplug a.moos b.moos Y=$Y\n"),
            "a.moos > b.moos Y=1\n");
  EXPECT_EQ(Plan("case x in y) Y=1;; esac\nnsplug a.moos b.moos Y=$Y\n"), "a.moos > b.moos Y=\n");
}

TEST(LaunchScript, GoesRoundUntilTheConditionHolds) {
  EXPECT_EQ(Plan("I=0\nuntil [ $I -ge 3 ]; do\nI=$((I+1))\ndone\nnsplug a.moos b.moos I=$I\n"),
            "a.moos > b.moos I=3\n");
}

TEST(LaunchScript, TakesWhatItPokes) {
  const LaunchPlan plan = ReadLaunchScript(
      {.name = "launch.sh",
       .text = "V=true\nuPokeDB targ_shore.moos DEPLOY_ALL=$V SPEED:=1.5 PTS=x=1 A:=b:=c &\n"
               "uPokeDB --host=localhost\n"},
      {});
  ASSERT_EQ(plan.pokes.size(), 1U);
  EXPECT_EQ(plan.pokes[0].origins, "launch.sh:2");
  EXPECT_EQ(plan.pokes[0].posts, (std::vector<std::pair<std::string, std::string>>{
                                     {"DEPLOY_ALL", "true"}, {"SPEED", "1.5"}, {"PTS", "x=1"}}));
}

TEST(LaunchScript, GoesRoundLoopsWithArraysAndSums) {
  EXPECT_EQ(Plan("NAMES=(ida jon)\nPOS=(`cat pos.txt`)\nfor IX in `seq 1 ${#NAMES[@]}`;\ndo\n"
                 " IXX=$(($IX - 1))\n nsplug m.moos targ_${NAMES[$IXX]}.moos P=${POS[$IXX]} "
                 "PORT=900$((IX*2+1))\ndone\n",
                 {{"pos.txt", "1,2\n3,4\n"}}),
            "m.moos > targ_ida.moos P=1,2 PORT=9003\nm.moos > targ_jon.moos P=3,4 PORT=9005\n");
}

TEST(LaunchScript, CallsOtherScriptsWithTheirArguments) {
  EXPECT_EQ(Plan("vecho() { if [ \"$V\" != \"\" ]; then echo \"$1\"; fi }\n"
                 "./field.sh\nV=(`cat names.txt`)\nARGS=\" --sim \"\nARGS+=\" --vname=${V[1]} \"\n"
                 "vecho \"go\"\nCMD=\"./vehicle.sh $ARGS\"\neval $CMD\n",
                 {{"field.sh", "echo ida > names.txt\necho jon >> names.txt\n"},
                  {"vehicle.sh",
                   "for ARGI; do\nif [ \"${ARGI:0:8}\" = \"--vname=\" ]; then\n"
                   "VNAME=\"${ARGI#--vname=*}\"\nelif [ $ARGI = --sim ]; then MODE=SIM\nfi\ndone\n"
                   "nsplug v.moos targ_$VNAME.moos VNAME=$VNAME MODE=$MODE\n"}}),
            "v.moos > targ_jon.moos MODE=SIM VNAME=jon\n");
}

TEST(LaunchScript, PicksNamesAndColorsAndGoesRoundWhile) {
  EXPECT_EQ(
      Plan("pickpos --amt=2 --vnames > v.txt\npickpos --amt=2 --spd=2:2 > s.txt\nV=(`cat v.txt`)\n"
           "S=(`cat s.txt`)\nI=0\nwhile [ $I -lt 2 ]; do\nnsplug m.moos ${V[$I]}.moos S=${S[$I]}\n"
           "I=$((I+1))\ndone\nwhile [ 1 = 1 ]; do\nread A\ndone\n"),
      "m.moos > abe.moos S=2\nm.moos > ben.moos S=2\n");
}

TEST(LaunchScript, TakesAFileThatIsLaunchedAsItIs) {
  EXPECT_EQ(Plan("pAntler alpha.moos --MOOSTimeWarp=1 >& /dev/null &\npAntler targ_x.moos\n",
                 {{"alpha.moos", ""}}),
            "alpha.moos > alpha.moos\n");
}

TEST(LaunchScript, ComputesWithExprAndKnowsTheFolderOfAPath) {
  EXPECT_EQ(Plan("I=3\nPORT=`expr $I + 9000`\nTWO=$(expr $I \\* 2)\nD=$(dirname a/b/c.sh)\n"
                 "nsplug a.moos b.moos PORT=$PORT TWO=$TWO D=$D\n"),
            "a.moos > b.moos D=a/b PORT=9003 TWO=6\n");
}

TEST(LaunchScript, NamesTheOutputOfExprThatIsNoSum) {
  const auto value = [](const std::string& expression) {
    return Plan("A=$(expr " + expression + ")\nnsplug a.moos b.moos A=$A\n");
  };
  EXPECT_EQ(value("\\( 1 + -3 \\) \\* 4"), "a.moos > b.moos A=-8\n");
  for (const char* text : {"length abc", "1+2", "1.5 + 1", "+ 9", "3 +", "abc : a"}) {
    EXPECT_EQ(value(text), "a.moos > b.moos A=\nlaunch.sh:1: the output of 'expr " +
                               std::string(text) + "' is not known\n");
  }
}

TEST(LaunchScript, NamesASumThatDividesByZeroOrIsTooLarge) {
  const auto note = [](const std::string& sum) {
    const std::string plan = Plan("A=" + sum + "\nnsplug a.moos b.moos A=$A\n");
    const size_t at = plan.find("launch.sh");
    return at == plan.npos ? "" : plan.substr(at);
  };
  EXPECT_EQ(note("$((7 / 2))"), "");
  EXPECT_EQ(note("$((1000000000 + 0))"), "");
  EXPECT_EQ(note("$((5 / 0))"), "launch.sh:1: '5 / 0' divides by 0 or leaves +-1e9: taken as 0\n");
  EXPECT_EQ(note("`expr 5 % 0`"),
            "launch.sh:1: '5 % 0' divides by 0 or leaves +-1e9: taken as 0\n");
  EXPECT_EQ(note("$((1000000001 - 1))"),
            "launch.sh:1: '1000000001 - 1' divides by 0 or leaves +-1e9: taken as 999999999\n");
}

TEST(LaunchScript, DrawsWhatBashDrawsTheSameEachTime) {
  const std::string text = "nsplug a.moos b.moos A=$((RANDOM % 1000)) B=$(($RANDOM % 1000))\n";
  const std::string plan = Plan(text);
  EXPECT_EQ(plan, Plan(text));
  EXPECT_TRUE(
      plan.ends_with("launch.sh:1: RANDOM is random: drawn here, the same in each import\n"))
      << plan;
  const size_t a = plan.find("A=") + 2;
  const size_t b = plan.find("B=") + 2;
  EXPECT_NE(plan.substr(a, 3), plan.substr(b, 3));
  EXPECT_NE(plan[a], '0');
}

TEST(LaunchScript, KeepsOptionsOfNsplug) {
  const LaunchPlan plan = ReadLaunchScript(
      {.name = "launch.sh",
       .text = "nsplug a.moos b.moos -f --path=p:q -p r --strict\nnsplug a.bhv b.bhv -l -f\n"},
      {});
  ASSERT_EQ(plan.files.size(), 2U);
  EXPECT_EQ(plan.files[0].options.paths, (std::vector<std::string>{"p", "q", "r"}));
  EXPECT_TRUE(plan.files[0].options.is_strict);
  EXPECT_FALSE(plan.files[0].options.is_lenient);
  EXPECT_TRUE(plan.files[1].options.is_lenient);
  EXPECT_EQ(plan.notes, std::vector<std::string>{});
}

TEST(LaunchScript, TakesPathsApartAsDirnameAndBasenameDo) {
  const auto value = [](const std::string& command) {
    return Plan("A=$(" + command + ")\nnsplug a.moos b.moos A=$A\n");
  };
  for (const auto& [path, folder, name] : {std::tuple("a/b", "a", "b"),
                                           {"/", "/", "/"},
                                           {"a/", ".", "a"},
                                           {"/a", "/", "a"},
                                           {"a//b//", "a", "b"},
                                           {"a", ".", "a"},
                                           {".", ".", "."}}) {
    EXPECT_EQ(value("dirname " + std::string(path)),
              "a.moos > b.moos A=" + std::string(folder) + "\n");
    EXPECT_EQ(value("basename " + std::string(path)),
              "a.moos > b.moos A=" + std::string(name) + "\n");
  }
  EXPECT_EQ(value("basename x/ida.moos .moos"), "a.moos > b.moos A=ida\n");
  EXPECT_EQ(value("dirname -z a/b"),
            "a.moos > b.moos A=\nlaunch.sh:1: the output of 'dirname' is not known\n");
}

TEST(LaunchScript, TakesMacrosOfAFileThatItWrites) {
  EXPECT_EQ(Plan("echo SPD=1 > own.opf\nnsplug a.bhv b.bhv --macros=own.opf\n"),
            "a.bhv > b.bhv SPD=1\n");
}

TEST(LaunchScript, TakesMacrosOfAFileThatTheCommandLineDoesNotGive) {
  EXPECT_EQ(
      Plan("nsplug a.bhv b.bhv --force --macros=base.opf SPD=2\n",
           {{"base.opf", "// base\n# of macros\nSPD=1\nEL=x=5,y=-4\nNAME = \"ida jon\"\nodd\n"}}),
      "a.bhv > b.bhv EL=x=5,y=-4 NAME=ida jon SPD=2\n");
  EXPECT_EQ(Plan("nsplug a.bhv b.bhv --macros=none.opf\n"),
            "a.bhv > b.bhv\nlaunch.sh:1: 'none.opf' is not there\n");
}

TEST(LaunchScript, TakesTheQuotesOffADefault) {
  EXPECT_EQ(Plan("POS=${POS:-\"5,6\"}\nnsplug a.moos b.moos POS=$POS\n"),
            "a.moos > b.moos POS=5,6\n");
}

TEST(LaunchScript, NamesWhatItCannotRead) {
  EXPECT_EQ(Plan("A=`ifconfig`\n./gone.sh\nnsplug a.moos b.moos A=$A\n"),
            "a.moos > b.moos A=\nlaunch.sh:1: the output of 'ifconfig' is not known\n"
            "launch.sh:2: './gone.sh' is not there\n");
}

TEST(LaunchScript, EndsWithScriptsThatCallThemselves) {
  const std::string loop = "for I in `seq 1 1000`; do\n./launch.sh\nA+=aaaaaaaaaaaaaaaa\ndone\n";
  Plan(loop, {{"launch.sh", loop}});
}

RC_GTEST_PROP(LaunchScript, AcceptsAnyText, ()) {
  const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "if ", "[ ", " ]", "then\n", "else\n", "fi\n", "for I in ", "do\n", "done\n", "A=", "$A",
      "${A", "}", "\"", "'", "`", "$((", "))", "$(", ")", "(", "nsplug ", "a.moos ", "\n", ";", " ",
      "\\", "#", "eval ", "-o ", "= ", "f() {", "&& ", "\xff", "[0]", ":0:2", "//x"));
  std::string text;
  for (const std::string& word : words) text += word;
  Plan(text, {{"a.moos", text}});
}

std::string Repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

/// Each took the whole stack, or minutes.
TEST(LaunchScript, ThatNestsOrRepeatsWithoutEndIsCutOffWithANote) {
  EXPECT_NE(Plan("X=" + Repeated("${X:-", 20'000)).find("within one another"), std::string::npos);
  EXPECT_NE(Plan("X=" + Repeated("$((", 20'000)).find("within one another"), std::string::npos);
  EXPECT_NE(Plan("X=" + Repeated("$(echo ", 20'000)).find("within one another"), std::string::npos);
  EXPECT_NE(Plan(Repeated("if [ a ]; then\n", 20'000) + Repeated("fi\n", 20'000))
                .find("more than 50 deep"),
            std::string::npos);
  EXPECT_NE(Plan(Repeated("A=1\n", 60'000)).find("too long a script"), std::string::npos);
  EXPECT_NE(Plan("X=" + std::string(90'000, 'a') + "\nY=${X##*b}\nZ=${X%%b*}\nA=1\n")
                .find("too long a script"),
            std::string::npos);
  EXPECT_EQ(Plan("for i in $(seq 1e17 1e18); do A=$i; done\nnsplug m.moos t.moos A=1\n"),
            "m.moos > t.moos A=1\n");
}

}  // namespace shoal::launch_script_test
