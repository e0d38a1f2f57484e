// Which key of which MOOS app is which key of a mission file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace shoal {

enum class SettingKind {
  kNumber,
  kNumberOrNolimit,
  kFlag,
  kFlagOrNumber,
  kText,
};

/// Which table of a mission file.
enum class SettingPlace { kComms, kVehicle, kCraft, kAutopilot, kReporter, kHelm };

struct SettingRule {
  std::string_view app;  ///< As AppClass() writes it.
  std::string_view moos_key;
  SettingPlace place;
  std::string_view key;
  SettingKind kind;
  std::string_view remark;  ///< What the user must know of it; may be empty.
};

/// Returns the app's name in lower case; versions of uSimMarine and pMarinePID are one class each.
[[nodiscard]] std::string AppClass(std::string_view app);

/// Returns the rule for a key of an app, both without regard to case; nullptr: there is none.
[[nodiscard]] const SettingRule* FindSetting(std::string_view app_class, std::string_view moos_key);

/// Returns `value` as TOML; nothing where it is not of this kind.
[[nodiscard]] std::optional<std::string> SettingValue(SettingKind kind, std::string_view value);

/// Returns what a value of this kind is, for messages: "a number".
[[nodiscard]] std::string_view KindText(SettingKind kind);

/// Returns what shoal has instead of an app; empty where it has nothing.
[[nodiscard]] std::string_view AppCounterpart(std::string_view app_class);

/// Returns what shoal has instead of a key that many apps have; "no counterpart in shoal" for all
/// others.
[[nodiscard]] std::string_view KeyCounterpart(std::string_view moos_key);

}  // namespace shoal
