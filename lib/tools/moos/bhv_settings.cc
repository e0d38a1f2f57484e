#include "lib/tools/moos/bhv_settings.h"

#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/bhv_text.h"

namespace shoal {

void BhvSettings::Remark(const MoosLine& line, std::string reason) {
  table_.lines.push_back({.key = "",
                          .value = "",
                          .origin = line.origin,
                          .text = line.text,
                          .reason = std::move(reason)});
}

BhvSettings::Gathered& BhvSettings::At(const std::string& key) {
  if (!gathered_.contains(key)) order_.push_back(key);
  return gathered_[key];
}

void BhvSettings::Set(const std::string& key, std::string value, const MoosLine& line,
                      bool is_essential, std::string remark) {
  Gathered& gathered = At(key);
  if (!gathered.origins.empty()) {
    table_.lines.push_back({.key = "",
                            .value = "",
                            .origin = gathered.origins,
                            .text = gathered.line_texts,
                            .reason = "replaced by " + line.origin});
  }
  gathered = {.texts = {},
              .value = std::move(value),
              .origins = line.origin,
              .line_texts = line.text,
              .remark = std::move(remark),
              .is_essential = is_essential};
}

void BhvSettings::Append(const std::string& key, const std::vector<std::string>& texts,
                         const MoosLine& line, bool is_essential) {
  Gathered& gathered = At(key);
  gathered.texts.insert(gathered.texts.end(), texts.begin(), texts.end());
  gathered.origins += (gathered.origins.empty() ? "" : ", ") + line.origin;
  gathered.line_texts += (gathered.line_texts.empty() ? "" : ", ") + line.text;
  gathered.is_essential = is_essential;
}

void BhvSettings::Assume(const std::string& key, std::string value, std::string remark) {
  if (gathered_.contains(key)) return;
  At(key) = {.texts = {},
             .value = std::move(value),
             .origins = "",
             .line_texts = "",
             .remark = std::move(remark)};
}

void BhvSettings::Move(const std::string& key, std::string value, std::string remark) {
  Gathered& gathered = At(key);
  gathered.value = std::move(value);
  if (!remark.empty()) gathered.remark = std::move(remark);
}

std::string_view BhvSettings::ValueOf(const std::string& key) const {
  const auto at = gathered_.find(key);
  return at == gathered_.end() ? std::string_view() : std::string_view(at->second.value);
}

double BhvSettings::NumberAt(const std::string& key, double otherwise) const {
  const auto at = gathered_.find(key);
  return at == gathered_.end() ? otherwise : NumberIn(at->second.value).value_or(otherwise);
}

BhvTable BhvSettings::Finished() && {
  for (const std::string& key : order_) {
    const Gathered& gathered = gathered_.at(key);
    table_.lines.push_back(
        {.key = key,
         .value = gathered.texts.empty() ? gathered.value : TomlTexts(gathered.texts),
         .origin = gathered.origins,
         .text = gathered.line_texts,
         .reason = gathered.remark,
         .is_essential = gathered.is_essential});
  }
  return std::move(table_);
}

}  // namespace shoal
