// Which behavior of MOOS-IvP is which kind of [[vehicle.behavior]], and which key is which.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

struct BhvType {
  std::string_view type;  ///< Without "BHV_", in lower case; a '*' at its end: all versions.
  std::string_view kind;
};

/// How a value is written in a mission file.
enum class BhvValue {
  kNumber,
  kInteger,
  kFlag,
  kText,
  kWord,    ///< A text in lower case.
  kPosted,  ///< The name of a variable that the behavior posts; "silent": none.
  kTexts,   ///< One text of a list for each line.
  kNames,   ///< A list of texts, separated by ',' or ':'.
  kNumbers,
  kPoints,  ///< [[x, y], ...].
  kPoint,   ///< [x, y].
  kPairs,   ///< [[depth, time], ...].
};

struct BhvKey {
  std::string_view kinds;  ///< Separated by blanks; "*": all; "@": those about a contact.
  std::string_view moos_key;
  std::string_view key;
  BhvValue value;
  bool is_essential = false;  ///< Without it the behavior would be another: it is left out whole.
};

struct BhvLostKey {
  std::string_view kinds;
  std::string_view moos_key;
  std::string_view reason;
  bool is_loss;  ///< True: worth a warning.
  /// The value is a variable that is not posted here: a loss where a condition reads it.
  bool names_variable = false;
};

/// Returns the kind for "BHV_AvdColregsV22"; empty: there is none.
[[nodiscard]] std::string_view KindOfBhv(std::string_view type);

/// Returns the kind that is nearest to a behavior of others that shoal does not have; "" for one
/// that only draws; nothing for a type that is not known.
[[nodiscard]] std::optional<std::string_view> NearestKind(std::string_view type);

/// Returns true for kinds about a contact.
[[nodiscard]] bool IsContactKind(std::string_view kind);

/// Returns what a key of a kind becomes, without regard to case; nullptr: nothing.
[[nodiscard]] const BhvKey* FindBhvKey(std::string_view kind, std::string_view moos_key);

/// Returns why a key has no counterpart where that is known; else nullptr.
[[nodiscard]] const BhvLostKey* FindLostBhvKey(std::string_view kind, std::string_view moos_key);

/// Returns all rows, for the documentation's test.
[[nodiscard]] std::vector<BhvType> AllBhvTypes();
[[nodiscard]] std::vector<BhvKey> AllBhvKeys();

}  // namespace shoal
