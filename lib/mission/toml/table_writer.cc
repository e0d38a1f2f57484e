#include "lib/mission/toml/table_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "lib/base/text/letters.h"

namespace shoal {
namespace {

std::string TomlPair(const Eigen::Vector2d& pair) {
  return fmt::format("[{}, {}]", TomlNumber(pair.x()), TomlNumber(pair.y()));
}

std::string TomlTriple(const Eigen::Vector3d& triple) {
  return fmt::format("[{}, {}, {}]", TomlNumber(triple.x()), TomlNumber(triple.y()),
                     TomlNumber(triple.z()));
}

/// Returns "[a, b, c]" of what `write` makes of each item.
template <class Items, class Write>
std::string TomlArray(const Items& items, const Write& write) {
  std::string text;
  for (const auto& item : items) {
    if (!text.empty()) text += ", ";
    text += write(item);
  }
  return "[" + text + "]";
}

std::string TomlKey(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return IsNameCharacter(c) || c == '-';
  });
  return bare ? std::string(key) : TomlString(key);
}

}  // namespace

std::string TomlNumber(double number) {
  std::string text = fmt::format("{}", number);
  // TOML would take digits alone for an integer, which knows no -0.
  if (number == 0 && std::signbit(number)) text = "-0.0";
  return text;
}

std::string TomlString(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (c == '\t') {
      quoted += "\\t";
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      quoted += fmt::format("\\u{:04X}", static_cast<int>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

void TableWriter::Line(std::string_view key, std::string_view value) {
  fmt::format_to(std::back_inserter(lines_), "{} = {}\n", key, value);
}

std::string TableWriter::PathOf(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

void TableWriter::Write(std::string_view key, const NumberField& field) {
  Line(key, TomlNumber(field.value));
}

void TableWriter::Write(std::string_view key, const NumberOrWordField& field) {
  Line(key, field.value < 0 ? TomlString(field.word) : TomlNumber(field.value));
}

void TableWriter::Write(std::string_view key, const ScalarField& field) {
  const std::string& word = field.word;
  const bool is_number = !word.empty() && word.find_first_not_of("+-.0123456789e") == word.npos &&
                         word.find("..") == word.npos;
  if (!is_number && word != "true" && word != "false") return Line(key, TomlString(word));
  // TOML would take many digits alone for an integer that is too large.
  const bool is_long = is_number && word.size() > 18 && word.find_first_of(".e") == word.npos;
  Line(key, is_long ? word + ".0" : word);
}

void TableWriter::Write(std::string_view key, const IntegerField& field) {
  Line(key, fmt::format("{}", field.value));
}

void TableWriter::Write(std::string_view key, const FlagField& field) {
  Line(key, field.value ? "true" : "false");
}

void TableWriter::Write(std::string_view key, const TextField& field) {
  Line(key, TomlString(field.value));
}

void TableWriter::Write(std::string_view key, const WordField& field) {
  Line(key, TomlString(field.value));
}

void TableWriter::Write(std::string_view key, const NumbersField& field) {
  Line(key, TomlArray(field.values, TomlNumber));
}

void TableWriter::Write(std::string_view key, const PairField& field) {
  Line(key, TomlPair(field.pair));
}

void TableWriter::Write(std::string_view key, const PairsField& field) {
  Line(key, TomlArray(field.pairs, TomlPair));
}

void TableWriter::Write(std::string_view key, const TripleField& field) {
  Line(key, TomlTriple(field.triple));
}

void TableWriter::Write(std::string_view key, const TriplesField& field) {
  Line(key, TomlArray(field.triples, TomlTriple));
}

void TableWriter::Write(std::string_view key, const TextsField& field) {
  Line(key, TomlArray(field.texts, TomlString));
}

void TableWriter::Write(std::string_view key, const TextMapField& field) {
  std::string members;
  for (const auto& [name, text] : field.texts) {
    members += (members.empty() ? "" : ", ") + TomlKey(name) + " = " + TomlString(text);
  }
  Line(key, "{" + members + "}");
}

void TableWriter::Write(std::string_view key, const ScalarsField& field) {
  std::string members;
  for (const auto& [name, value] : field.values) {
    const auto* text = std::get_if<std::string>(&value);
    members += (members.empty() ? "" : ", ") + TomlKey(name) + " = " +
               (text != nullptr ? TomlString(*text) : TomlNumber(std::get<double>(value)));
  }
  Line(key, "{" + members + "}");
}

void TableWriter::Key(std::string_view key, const Field& field) {
  std::visit([&](const auto& each) { Write(key, each); }, field);
}

void TableWriter::Below(std::string_view key, const DescribeTable& describe) {
  TableWriter below(PathOf(key));
  describe(below);
  tables_ += fmt::format("\n[{}]\n{}", below.path_, below.TakeText());
}

void TableWriter::Inline(std::string_view key, const DescribeTable& describe) {
  TableWriter members;
  describe(members);
  std::string text = members.TakeText();
  if (!text.empty()) text.pop_back();
  for (size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at)) {
    text.replace(at, 1, ", ");
  }
  Line(key, "{" + text + "}");
}

void TableWriter::EachBelow(std::string_view key, size_t count, const std::function<void(size_t)>&,
                            const std::function<void(Fields&, size_t)>& describe_one) {
  for (size_t i = 0; i < count; ++i) {
    TableWriter below(PathOf(key));
    describe_one(below, i);
    tables_ += fmt::format("\n[[{}]]\n{}", below.path_, below.TakeText());
  }
}

}  // namespace shoal
