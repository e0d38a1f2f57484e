// Helps a person who has mistyped a word.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace shoal {

/// Returns the number of letters to insert, delete, replace or exchange with their neighbour that
/// turn `a` into `b` (optimal string alignment).
int EditDistance(std::string_view a, std::string_view b);

/// Returns the candidate that `word` was most likely meant to be, empty where none is near. Part
/// of a candidate is as good as all of it, so that 'sped' finds 'speed_mps' and 'range' finds
/// 'comms_range'. The first of several equally near ones wins.
std::string_view Suggest(std::string_view word, std::span<const std::string_view> candidates);

/// Returns " (did you mean 'x'?)", or "" where Suggest finds nothing.
std::string DidYouMean(std::string_view word, std::span<const std::string_view> candidates);

/// Returns `text` in single quotes, shortened and without control characters: fit for a terminal.
std::string Quoted(std::string_view text);

/// Returns `words` separated by ", ".
std::string Joined(std::span<const std::string_view> words);

}  // namespace shoal
