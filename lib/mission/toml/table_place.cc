#include "lib/mission/toml/table_place.h"

#include <utility>
#include <variant>

namespace shoal {

TablePlace::TablePlace(const Value& root, Problems& problems) : problems_(&problems) {
  way_.push_back(&root);
}

TablePlace TablePlace::At(const Value* value) const {
  TablePlace below(*problems_);
  below.way_ = way_;
  below.exists_ = value != nullptr;
  if (value != nullptr) below.way_.push_back(value);
  return below;
}

const Value* TablePlace::Find(std::string_view key) const {
  const auto* table = exists_ ? std::get_if<Table>(&way_.back()->data) : nullptr;
  return table == nullptr ? nullptr : shoal::Find(*table, key);
}

TablePlace TablePlace::Below(std::string_view key) const { return At(Find(key)); }

TablePlace TablePlace::Below(std::string_view key, size_t number) const {
  const Value* list = Find(key);
  const auto* array = list == nullptr ? nullptr : std::get_if<Array>(&list->data);
  return At(array == nullptr || number >= array->size() ? nullptr : &(*array)[number]);
}

bool TablePlace::Has(std::string_view key) const { return Find(key) != nullptr; }

bool TablePlace::IsSound() const { return !exists_ || problems_->IsSound(*way_.back()); }

const Place& TablePlace::PlaceOf(std::string_view key) const {
  const Value* found = Find(key);
  return found == nullptr ? way_.back()->place : found->place;
}

void TablePlace::Refuse(std::string_view key, std::string text) const {
  problems_->Add(PlaceOf(key), std::move(text));
  for (const Value* table : way_) problems_->MarkUnsound(*table);
}

void TablePlace::Warn(std::string_view key, std::string text) const {
  problems_->Warn(PlaceOf(key), std::move(text));
}

void TablePlace::WarnOfFailure(std::string_view key, std::string text) const {
  problems_->WarnOfFailure(PlaceOf(key), std::move(text));
}

}  // namespace shoal
