#include "lib/tools/moos/mission_draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/mission/file/load.h"

namespace shoal {
namespace {

constexpr std::string_view kName = "draft";  ///< Stands for the file in the reader's messages.

std::string CommentText(const DraftLine& line) {
  std::string comment = "#";
  const auto add = [&](const std::string& part) {
    if (part.empty()) return;
    comment += comment.size() > 1 ? ": " : " ";
    comment += part;
  };
  add(line.origin);
  add(line.text);
  add(line.reason);
  return comment;
}

/// Returns the line of "draft:12:7: unknown key" and cuts the place off; 0: there is none.
size_t TakeLineNumber(std::string* error) {
  const std::string_view text = *error;
  if (!text.starts_with(kName) || text.size() < kName.size() + 2) return 0;
  size_t line = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data() + kName.size() + 1, end, line);
  const size_t reason = text.find(": ");
  if (problem != std::errc() || reason == std::string_view::npos) return 0;
  error->erase(0, reason + 2);
  return line;
}

}  // namespace

void DraftOrigins::Add(const std::string& origin, const std::string& text) {
  origins += (origins.empty() ? "" : ", ") + origin;
  texts += (texts.empty() ? "" : ", ") + text;
}

void MissionDraft::AddTable(std::string id, std::string header, bool is_required) {
  index_.emplace(id, tables_.size());
  tables_.push_back(
      {.id = std::move(id), .header = std::move(header), .is_required = is_required, .lines = {}});
}

size_t MissionDraft::IndexOf(std::string_view table) const {
  const auto at = index_.find(table);
  SHOAL_CHECK(at != index_.end(), "a draft's table must be added before it is filled");
  return at->second;
}

void MissionDraft::Set(std::string_view table, DraftLine line) {
  std::vector<DraftLine>& lines = tables_[IndexOf(table)].lines;
  for (DraftLine& earlier : lines) {
    if (earlier.key != line.key) continue;
    if (earlier.value == line.value) {
      const bool is_named = earlier.origin.ends_with(line.origin);
      if (!is_named) earlier.origin += (earlier.origin.empty() ? "" : ", ") + line.origin;
      return;
    }
    earlier.key.clear();
    earlier.reason = line.origin.empty() ? "replaced" : "replaced by " + line.origin;
    break;
  }
  lines.push_back(std::move(line));
}

void MissionDraft::Remark(std::string_view table, std::string origin, std::string text,
                          std::string reason) {
  if (!remarks_.insert({std::string(table), origin, text, reason}).second) return;
  tables_[IndexOf(table)].lines.push_back({.key = "",
                                           .value = "",
                                           .origin = std::move(origin),
                                           .text = std::move(text),
                                           .reason = std::move(reason)});
}

void MissionDraft::Add(std::string_view table, DraftLine line) {
  tables_[IndexOf(table)].lines.push_back(std::move(line));
}

bool MissionDraft::IsSet(std::string_view table, std::string_view key) const {
  const std::vector<DraftLine>& lines = tables_[IndexOf(table)].lines;
  return std::any_of(lines.begin(), lines.end(),
                     [&](const DraftLine& line) { return line.key == key; });
}

bool MissionDraft::Refuse(const Owner& owner, const std::string& reason,
                          std::vector<std::string>* refused) {
  if (!owner.table) return false;
  DraftTable& table = tables_[*owner.table];
  if (!owner.line && table.is_required) return false;
  const bool is_whole = !owner.line || table.lines[*owner.line].is_essential;
  size_t num_refused = 0;
  std::string first;
  for (size_t i = 0; i < table.lines.size(); ++i) {
    DraftLine& line = table.lines[i];
    if (line.key.empty() || (!is_whole && *owner.line != i)) continue;
    line.text = line.text.empty() ? line.key + " = " + line.value : line.text;
    line.key.clear();
    line.reason = reason;
    const bool is_cause = owner.line ? *owner.line == i : num_refused == 0;
    if (is_cause)
      first = (line.origin.empty() ? "" : line.origin + ": ") + line.text + ": " + reason;
    ++num_refused;
  }
  if (num_refused == 0) return false;
  if (num_refused > 1)
    first += fmt::format("; all {} lines of {} are left out", num_refused, table.header);
  refused->push_back(std::move(first));
  return true;
}

std::vector<std::string> MissionDraft::MakeLoadable() {
  std::vector<std::string> refused;
  while (true) {
    std::vector<Owner> owners;
    std::vector<std::string> errors = LoadMissionText(Render(&owners), std::string(kName)).errors;
    bool changed = false;
    for (std::string& error : errors) {
      const size_t number = TakeLineNumber(&error);
      if (number == 0 || number > owners.size()) continue;
      changed = Refuse(owners[number - 1], error, &refused) || changed;
    }
    if (changed) continue;
    for (const std::string& error : errors) refused.push_back("the mission needs care: " + error);
    return refused;
  }
}

std::string MissionDraft::Text() const {
  std::vector<Owner> owners;
  return Render(&owners);
}

std::string MissionDraft::Render(std::vector<Owner>* owners) const {
  std::string text;
  const auto add = [&](const std::string& line, const Owner& owner) {
    text += line;
    text += '\n';
    owners->push_back(owner);
  };
  for (size_t begin = 0; begin < preamble_.size();) {
    const size_t end = std::min(preamble_.find('\n', begin), preamble_.size());
    add(preamble_.substr(begin, end - begin), {});
    begin = end + 1;
  }
  for (size_t i = 0; i < tables_.size(); ++i) {
    const DraftTable& table = tables_[i];
    if (table.lines.empty() && !table.is_required) continue;
    const bool has_setting = std::any_of(table.lines.begin(), table.lines.end(),
                                         [](const DraftLine& line) { return !line.key.empty(); });
    add("", {});
    const bool has_header = has_setting || table.is_required || table.header.starts_with('#');
    if (has_header) add(table.header, {.table = i, .line = std::nullopt});
    for (size_t j = 0; j < table.lines.size(); ++j) {
      const DraftLine& line = table.lines[j];
      if (line.key.empty()) {
        add(CommentText(line), {});
        continue;
      }
      if (!line.reason.empty()) add("# " + line.reason, {});
      add(line.key + " = " + line.value + (line.origin.empty() ? "" : "  # " + line.origin),
          {.table = i, .line = j});
    }
  }
  return text;
}

}  // namespace shoal
