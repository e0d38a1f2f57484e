// A draft of a mission file: each setting with the line that it came from.
//
//   MissionDraft draft("# What this is.");
//   draft.Require("mission", "[mission]");
//   draft.Set("mission", {.key = "duration_s", .value = "600", .origin = "", .text = ""});
//   draft.Remark("mission", "a.moos:7", "pulse_colour = red", "no counterpart in shoal");
//   draft.MakeLoadable();
//   draft.Text();
//
// The reader of mission files judges every value: MakeLoadable() turns each setting that it refuses
// into a comment with the reader's own reason, so that ranges and keys are in one place.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

/// One line of a table: a setting, or (without a key) a comment.
struct DraftLine {
  std::string key;
  std::string value;   ///< As TOML.
  std::string origin;  ///< "a.moos:12"; empty: of no line.
  std::string text;    ///< What stands there.
  std::string reason;  ///< Of a comment: why it is not a setting. Of a setting: a remark on it.
  /// Without this setting the others of its table would mean something else: where it is refused,
  /// so are they.
  bool is_essential = false;
};

/// The lines that one setting is made of.
struct DraftOrigins {
  std::string origins;  ///< "a.moos:12, a.moos:14".
  std::string texts;

  void Add(const std::string& origin, const std::string& text);
};

class MissionDraft {
 public:
  /// `preamble` is the text before the first table, in lines that begin with '#'.
  explicit MissionDraft(std::string preamble) : preamble_(std::move(preamble)) {}

  /// Adds the table `id` behind those that are there, under `header`, such as "[comms]". The header
  /// is written where the table has a setting, or where it `is_required`. A header that is a
  /// comment is above a table of comments.
  void AddTable(std::string id, std::string header, bool is_required = false);

  /// Sets a key of a table. An earlier, different value becomes a comment; an equal one is named
  /// beside this.
  void Set(std::string_view table, DraftLine line);

  /// Adds the comment "# ORIGIN: TEXT: REASON", once; empty parts are left out.
  void Remark(std::string_view table, std::string origin, std::string text, std::string reason);

  /// Adds a line as it is: a comment where it has no key.
  void Add(std::string_view table, DraftLine line);

  bool IsSet(std::string_view table, std::string_view key) const;

  /// Turns settings that shoal's reader of mission files refuses into comments. Returns what it
  /// refused, a line each; last, what keeps the mission from being loaded all the same.
  std::vector<std::string> MakeLoadable();

  std::string Text() const;

 private:
  struct DraftTable {
    std::string id;
    std::string header;
    bool is_required = false;
    std::vector<DraftLine> lines;
  };
  /// What is in a line of the text.
  struct Owner {
    std::optional<size_t> table;
    std::optional<size_t> line;  ///< Of the table; none: its header.
  };

  size_t IndexOf(std::string_view table) const;
  /// Returns the text, and for each of its lines what stands there.
  std::string Render(std::vector<Owner>* owners) const;
  /// Turns the owner's settings into comments. Returns false where there are none.
  bool Refuse(const Owner& owner, const std::string& reason, std::vector<std::string>* refused);

  std::string preamble_;
  std::vector<DraftTable> tables_;
  std::set<std::array<std::string, 4>> remarks_;      ///< Table, origin, text, reason.
  std::map<std::string, size_t, std::less<>> index_;  ///< Of tables_, by id.
};

}  // namespace shoal
