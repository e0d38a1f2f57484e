#include "lib/mission/toml/value.h"

#include <utility>

#include "lib/mission/toml/suggest.h"

namespace shoal {

Value* Find(Table& table, std::string_view key) {
  for (Entry& entry : table) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

const Value* Find(const Table& table, std::string_view key) {
  return Find(const_cast<Table&>(table), key);
}

const std::string* FindText(const Value& table, std::string_view key) {
  const auto* entries = std::get_if<Table>(&table.data);
  const Value* value = entries == nullptr ? nullptr : Find(*entries, key);
  return value == nullptr ? nullptr : std::get_if<std::string>(&value->data);
}

void Set(Table& table, std::string_view key, const Place& key_place, Value value) {
  for (Entry& entry : table) {
    if (entry.key != key) continue;
    entry.key_place = key_place;
    entry.value = std::move(value);
    return;
  }
  table.push_back({std::string(key), key_place, std::move(value)});
}

int64_t CountValues(const Value& value) {
  int64_t count = 1;
  if (const auto* array = std::get_if<Array>(&value.data)) {
    for (const Value& element : *array) count += CountValues(element);
  } else if (const auto* table = std::get_if<Table>(&value.data)) {
    for (const Entry& entry : *table) count += CountValues(entry.value);
  }
  return count;
}

std::string WhatIs(const Value& value) {
  struct Namer {
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(int64_t) const { return "a whole number"; }
    std::string operator()(double) const { return "a number"; }
    std::string operator()(const std::string& text) const { return "the string " + Quoted(text); }
    std::string operator()(const DateOrTime&) const { return "a date or time"; }
    std::string operator()(const Array&) const { return "an array"; }
    std::string operator()(const Table&) const { return "a table"; }
  };
  return std::visit(Namer(), value.data);
}

}  // namespace shoal
