// What nsplug does to MOOS files: #include, #define, #ifdef and macros.
//
//   #include plug_loiter.bhv            its lines; <tag> behind the name: the part behind that tag
//   #define SPEED 1.5                   a value given to the import counts instead
//   #ifdef SIM                          also: SIM yes, A || B, A && B, #ifndef SIM
//   #elseifdef XMODE REAL
//   #else
//   #endif
//   speed = $(SPEED)   group = %(TEAM:=red)    %: in upper case; := the value where there is none
//
// A macro without a value stays as it is written: some apps have macros of their own.
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

/// Values of macros, by name.
using MoosDefines = std::map<std::string, std::string, std::less<>>;

/// Returns the file that `from` names as `name`, nothing where there is none. The same file always
/// has the same name.
using FindMoosFile =
    std::function<std::optional<MoosSource>(std::string_view name, std::string_view from)>;

/// A line, without comment and without blanks at its ends; never empty.
struct PluggedLine {
  int number = 0;           ///< Counts all lines that are read, those of included files too.
  std::string origin;       ///< "a.moos:12".
  std::string text;         ///< UTF-8.
  std::string reason = {};  ///< Not empty: it is none of the file's own; why ("is ...").
  bool is_loss = true;      ///< With a reason: something is lost.
};

struct PluggedText {
  std::string name;
  std::vector<PluggedLine> lines;
};

/// Reads any text; `find` may be empty. What cannot be resolved is a line with a reason. At most
/// 100,000 lines, 20 MB, 16 files within one another, and 4,096 bytes of a macro's value.
[[nodiscard]] PluggedText Plug(const MoosSource& source, const MoosDefines& defines,
                               const FindMoosFile& find);

/// Returns "a.moos" for "missions/a.moos".
[[nodiscard]] std::string FileName(std::string_view path);

/// Returns `text` as one line of UTF-8: control characters and bytes that are not UTF-8 are '?'.
[[nodiscard]] std::string CleanUtf8(std::string_view text);

/// Returns the first macro $(NAME) or %(NAME) of `text` as it is written; empty: there is none.
[[nodiscard]] std::string FirstMacro(std::string_view text);

}  // namespace shoal
