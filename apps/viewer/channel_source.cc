#include "apps/viewer/channel_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"
#include "lib/tools/fields/field_reader.h"
#include "lib/tools/view/json_writer.h"

namespace shoal {

namespace {

/// An empty text, as Leaves() writes it.
constexpr std::string_view kEmpty = "\"\"";
constexpr size_t kMaxJoined = 20;

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return lower;
}

/// Returns "aims[].name" for "aims[3].name".
std::string WithoutIndices(std::string_view path) {
  std::string plain;
  bool is_index = false;
  for (const char letter : path) {
    if (letter == ']') is_index = false;
    if (!is_index) plain += letter;
    if (letter == '[') is_index = true;
  }
  return plain;
}

std::optional<double> NumberAsDrawn(std::string_view text) {
  if (text == "true") return 1;
  if (text == "false") return 0;
  return ReadNumber<double>(text);
}

bool IsNumber(std::string_view text) { return NumberAsDrawn(text) || text == "nan"; }

}  // namespace

Result<FieldName> ParseFieldName(std::string_view text) {
  const size_t colon = text.find(':');
  if (colon == 0 || colon == text.npos || colon + 1 == text.size()) {
    return Error{
        fmt::format("field must be CHANNEL:PATH, such as NAV_ALPHA:x_m, not {}", Quoted(text))};
  }
  return FieldName{std::string(text.substr(0, colon)), std::string(text.substr(colon + 1))};
}

std::string TypeNameOf(std::span<const uint8_t> logged) {
  const RecognisedMessage message = Recognise(ShoalTypes(), logged);
  return message.type == nullptr ? DescribeFingerprint(message.data) : DisplayName(*message.type);
}

std::vector<Leaf> LeavesOf(std::span<const uint8_t> logged) {
  if (logged.size() > ChannelSource::kMaxMessage_bytes) return {};
  Bytes storage;
  const RecognisedMessage message = RecogniseAsList(ShoalTypes(), logged, &storage);
  if (!message.IsDecodable()) return {};
  return Leaves(ShoalTypes(), *message.type, message.data);
}

std::optional<std::string> ValueAt(const std::vector<Leaf>& leaves, std::string_view path) {
  if (path.find("[]") == path.npos) {
    const auto leaf = std::ranges::find(leaves, path, &Leaf::path);
    if (leaf == leaves.end()) return std::nullopt;
    return leaf->text == kEmpty ? "" : leaf->text;
  }
  std::vector<std::string_view> values;
  for (const Leaf& leaf : leaves) {
    if (values.size() == kMaxJoined) break;
    if (WithoutIndices(leaf.path) != path || std::ranges::count(values, leaf.text) > 0) continue;
    values.push_back(leaf.text);
  }
  return fmt::format("{}", fmt::join(values, ", "));
}

std::optional<Error> FindNoSuchField(const FieldName& name, std::span<const uint8_t> message) {
  const std::vector<Leaf> leaves = LeavesOf(message);
  // Arrays may be empty now.
  if (leaves.empty() || name.path.find('[') != name.path.npos) return std::nullopt;
  std::vector<std::string_view> paths;
  for (const Leaf& leaf : leaves) {
    if (leaf.path == name.path) return std::nullopt;
    if (paths.size() < ChannelSource::kMaxLeaves) paths.push_back(leaf.path);
  }
  return Error{fmt::format("{} has no field {}{}", name.channel, Quoted(name.path),
                           DidYouMean(name.path, paths))};
}

std::string ChannelListJson(const std::vector<ChannelFacts>& channels,
                            const std::vector<std::string>& types) {
  JsonWriter json;
  json.BeginObject().Key("channels").BeginArray();
  for (size_t i = 0; i < channels.size(); ++i) {
    json.BeginObject()
        .Text("name", channels[i].name)
        .Text("type", types[i])
        .Integer("count", channels[i].count)
        .Number("rate_hz", channels[i].rate_hz, 2)
        .Number("t", channels[i].last_s, kMilliseconds)
        .EndObject();
  }
  json.EndArray().EndObject();
  return json.Take();
}

std::string MessageJsonOf(const ShownMessage& message) {
  const std::vector<Leaf> leaves = LeavesOf(message.data);
  JsonWriter json;
  json.BeginObject()
      .Text("channel", message.channel)
      .Text("type", TypeNameOf(message.data))
      .Number("t", message.t_s, kMilliseconds)
      .Integer("bytes", static_cast<int64_t>(message.data.size()))
      .Key("fields")
      .BeginArray();
  const size_t shown = std::min(leaves.size(), ChannelSource::kMaxLeaves);
  for (size_t i = 0; i < shown; ++i) {
    json.BeginObject()
        .Text("path", leaves[i].path)
        .Text("text", std::string_view(leaves[i].text).substr(0, ChannelSource::kLongestText))
        .Boolean("number", IsNumber(leaves[i].text))
        .EndObject();
  }
  json.EndArray().Integer("left_out", static_cast<int64_t>(leaves.size() - shown)).EndObject();
  return json.Take();
}

FieldSearch::FieldSearch(std::string_view text) {
  std::string word;
  for (const char letter : Lower(text) + " ") {
    if (letter != ' ') {
      word += letter;
    } else if (!word.empty()) {
      words_.push_back(std::move(word));
      word.clear();
    }
  }
}

bool FieldSearch::Take(const std::string& channel, std::span<const uint8_t> message) {
  for (const Leaf& leaf : LeavesOf(message)) {
    std::string name = fmt::format("{}:{}", channel, leaf.path);
    const std::string lower = Lower(name);
    const bool has_all = std::ranges::all_of(
        words_, [&](const std::string& word) { return lower.find(word) != lower.npos; });
    if (!has_all) continue;
    is_more_ = found_.size() == ChannelSource::kMaxFields;
    if (is_more_) return false;
    found_.push_back(std::move(name));
  }
  return true;
}

std::string FieldSearch::Json() const {
  JsonWriter json;
  json.BeginObject().Key("fields").BeginArray();
  for (const std::string& name : found_) json.Text(name);
  json.EndArray().Boolean("more", is_more_).EndObject();
  return json.Take();
}

std::string SeriesJsonOf(std::string_view field, const std::vector<SeriesPoint>& points) {
  const bool is_numeric =
      std::ranges::all_of(points, [](const SeriesPoint& point) { return IsNumber(point.value); });
  JsonWriter json;
  json.BeginObject().Text("field", field).Boolean("number", is_numeric).Key("t").BeginArray();
  for (const SeriesPoint& point : points) json.Number(point.t_s, kMilliseconds);
  json.EndArray().Key("value").BeginArray();
  for (const SeriesPoint& point : points) {
    if (!is_numeric) {
      json.Text(std::string_view(point.value).substr(0, ChannelSource::kLongestText));
    } else if (const auto number = NumberAsDrawn(point.value)) {
      json.Number(*number, 6);
    } else {
      json.Null();
    }
  }
  json.EndArray().EndObject();
  return json.Take();
}

}  // namespace shoal
