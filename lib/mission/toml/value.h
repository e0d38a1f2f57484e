// A mission file before its keys are interpreted: values, each with the place that it came from.
// Templates, fleets and overrides work on these (expand.h, override.h); then TableReader gives them
// meaning.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace shoal {

/// Where something was written: in the file, or in an override of the command line. Places are
/// ordered as a reader meets them: the file first, then the overrides.
struct Place {
  int64_t override_number = 0;  ///< 0: the file; n: the n-th override.
  int64_t line = 0;             ///< Counts from 1; of the file only.
  int64_t column = 0;

  auto operator<=>(const Place&) const = default;  // NOLINT(modernize-use-nullptr): no pointer
};

struct Value;
struct Entry;
using Array = std::vector<Value>;
using Table = std::vector<Entry>;  ///< In the order of the file; keys are unique.

/// A TOML date or time; no key of a mission file takes one.
struct DateOrTime {};

struct Value {
  Place place;
  std::variant<bool, int64_t, double, std::string, DateOrTime, Array, Table> data;
};

struct Entry {
  std::string key;
  Place key_place;
  Value value;
};

/// Returns the value of `key`, or nullptr.
const Value* Find(const Table& table, std::string_view key);
Value* Find(Table& table, std::string_view key);

/// Returns the string under `key`, or nullptr where there is none or it is not a string.
const std::string* FindText(const Value& table, std::string_view key);

/// Gives `key` this value, whether it is there already or not.
void Set(Table& table, std::string_view key, const Place& key_place, Value value);

/// Returns the number of values in `value`, itself included.
int64_t CountValues(const Value& value);

/// Returns what a value is, for messages: "a number", "the string 'fast'", "an array".
std::string WhatIs(const Value& value);

}  // namespace shoal
