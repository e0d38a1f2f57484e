// What nsplug does to MOOS files: #include, #define, #ifdef and macros.
//
//   #include plug_loiter.bhv            its lines; <tag> behind the name: a section of the file
//   <tag><north>                        begins the section north
//   #define SPEED 1.5                   takes the place of a value that is given
//   #ifdef SIM                          also: SIM yes, A || B, A && B, #ifndef SIM
//   #elseifdef XMODE REAL
//   #else
//   #endif
//   speed = $(SPEED)   group = %(TEAM:=red)    %: in upper case
//
// $(X=d) is d where X is not defined, $(X:=d) also where it is empty. An empty macro is not defined
// for #ifdef X, || and #ifndef. Values are expanded where they are used. A line with one macro that
// has no value stays as it is written: some apps have macros of their own. What nsplug refuses is
// taken as it is meant, with a reason. docs/reference/import_bhv.md
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

struct MoosSource {
  std::string name;  ///< Stands before line numbers, in comments and warnings.
  std::string text;
};

/// The value of a macro that is defined and stands for nothing: `nsplug a b NIGHT`.
inline constexpr std::string_view kBareMacro = "<defined>";

/// Values of macros, by name.
using MoosDefines = std::map<std::string, std::string, std::less<>>;

/// Returns the file that `from` names as `name`, nothing where there is none. The same file always
/// has the same name.
/// `from` is the first file, then the including one.
using FindMoosFile =
    std::function<std::optional<MoosSource>(std::string_view name, std::string_view from)>;

/// What else a command line of nsplug states.
struct PlugOptions {
  std::vector<std::string> paths = {};  ///< --path: folders of included files.
  bool is_lenient = false;  ///< --lenient: beside a macro without a value others have theirs.
  bool is_strict = false;   ///< --strict: nsplug writes nothing where a macro has no value.
};

/// A line, without comment and without blanks at its ends; never empty.
struct PluggedLine {
  int number = 0;            ///< Counts all lines that are read, those of included files too.
  std::string origin;        ///< "a.moos:12".
  std::string text;          ///< UTF-8.
  std::string reason = {};   ///< Not empty: it is not one of the file's own; why ("is ...").
  bool is_loss = true;       ///< With a reason: something is lost.
  std::string unknown = {};  ///< The first macro that has no value, as it is written.
};

struct PluggedText {
  std::string name;
  std::vector<PluggedLine> lines;
};

/// Reads any text; `find` may be empty. What cannot be resolved is a line with a reason. At most
/// 100,000 lines, 20 MB, 16 files within one another, and 4,096 bytes of a macro's value.
[[nodiscard]] PluggedText Plug(const MoosSource& source, const MoosDefines& defines,
                               const FindMoosFile& find, const PlugOptions& options = {});

/// Returns "a.moos" for "missions/a.moos".
[[nodiscard]] std::string FileName(std::string_view path);

/// Returns `text` as one line of UTF-8: control characters and bytes that are not UTF-8 are '?'.
[[nodiscard]] std::string CleanUtf8(std::string_view text);

/// Returns the first macro $(NAME) or %(NAME) of `text` as it is written; empty: there is none.
[[nodiscard]] std::string FirstMacro(std::string_view text);

}  // namespace shoal
