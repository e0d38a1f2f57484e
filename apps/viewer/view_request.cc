#include "apps/viewer/view_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>

#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

namespace {

constexpr size_t kLongestNumber = 40;
constexpr size_t kLongestName = 64;
constexpr size_t kLongestField = 300;
constexpr size_t kLongestWord = 1000;
constexpr size_t kMaxWords = 64;

bool IsPrintable(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](char each) {
    return static_cast<unsigned char>(each) < 0x20 || each == 0x7f;
  });
}

/// The whole of `text` as a number of type T, without a '+', which is a blank in a query.
template <class T>
std::optional<T> NumberOf(std::string_view text) {
  if (text.size() > kLongestNumber || text.starts_with('+')) return std::nullopt;
  return ReadNumber<T>(text);
}

/// Takes the words of a query one by one; the first thing that is wrong is kept.
class QueryReader {
 public:
  QueryReader(const QueryWords& query, std::initializer_list<std::string_view> known)
      : query_(query) {
    std::vector<std::string_view> names = known;
    names.insert(names.end(), {"t", "token"});
    for (const auto& [name, value] : query) {
      if (error_) break;
      if (std::find(names.begin(), names.end(), name) == names.end()) {
        Refuse(fmt::format("unknown in this query: {}; known: {}", Quoted(name), Joined(names)));
      } else if (query.count(name) > 1) {
        Refuse(fmt::format("'{}' appears in this query more than once", name));
      }
    }
  }

  template <class T>
  void Number(const char* name, T least, T most, T* value) {
    const auto found = query_.find(name);
    if (found == query_.end()) return;
    const std::optional<T> number = NumberOf<T>(found->second);
    if (number && *number >= least && *number <= most) {
      *value = *number;
    } else {
      Refuse(fmt::format("{} must be a number from {} to {}, not {}", name, least, most,
                         Quoted(found->second)));
    }
  }

  void Name(const char* name, bool is_required, std::string* value, size_t longest = kLongestName) {
    const auto found = query_.find(name);
    if (found == query_.end()) {
      if (is_required) Refuse(fmt::format("this query needs {}=NAME", name));
      return;
    }
    const std::string& text = found->second;
    if (text.size() > longest || !IsPrintable(text) || (is_required && text.empty())) {
      Refuse(fmt::format("{} must be a name of at most {} letters, not {}", name, longest,
                         Quoted(text)));
    } else {
      *value = text;
    }
  }

  void Flag(const char* name, bool* value) {
    int number = *value ? 1 : 0;
    Number(name, 0, 1, &number);
    *value = number == 1;
  }

  void Time(double* t_s) {
    constexpr double kMax = 1e300;
    Number("t", -kMax, kMax, t_s);
  }

  template <class T>
  Result<T> Conclude(T value) const {
    if (error_) return *error_;
    return value;
  }

 private:
  void Refuse(std::string why) {
    if (!error_) error_ = Error{std::move(why)};
  }

  const QueryWords& query_;
  std::optional<Error> error_;
};

Result<std::string> WordOf(const nlohmann::json& json, std::string_view what, size_t longest) {
  const auto* text = json.get_ptr<const std::string*>();
  if (text == nullptr) return Error{fmt::format("{} must be a string", what)};
  if (text->size() > longest) {
    return Error{fmt::format("{} is longer than {} bytes", what, longest)};
  }
  if (!IsPrintable(*text)) return Error{fmt::format("{} holds a control character", what)};
  return *text;
}

}  // namespace

Result<double> ParseTimeQuery(const QueryWords& query) {
  QueryReader reader(query, {});
  double t_s = kNoTimeGiven_s;
  reader.Time(&t_s);
  return reader.Conclude(t_s);
}

Result<LinksQuery> ParseLinksQuery(const QueryWords& query) {
  QueryReader reader(query, {"medium"});
  LinksQuery links;
  reader.Name("medium", false, &links.medium);
  reader.Time(&links.t_s);
  return reader.Conclude(std::move(links));
}

Result<LinkQuery> ParseLinkQuery(const QueryWords& query) {
  QueryReader reader(query, {"from", "to"});
  LinkQuery link;
  reader.Name("from", true, &link.from);
  reader.Name("to", true, &link.to);
  reader.Time(&link.t_s);
  return reader.Conclude(std::move(link));
}

Result<VehicleQuery> ParseVehicleQuery(const QueryWords& query) {
  QueryReader reader(query, {"name", "window"});
  VehicleQuery vehicle;
  reader.Name("name", true, &vehicle.name);
  reader.Time(&vehicle.t_s);
  reader.Number("window", 1.0, 3600.0, &vehicle.window_s);
  return reader.Conclude(std::move(vehicle));
}

Result<ChannelQuery> ParseChannelQuery(const QueryWords& query, const char* word,
                                       bool is_required) {
  QueryReader reader(query, {word, "window"});
  ChannelQuery channel;
  reader.Name(word, is_required, &channel.name, kLongestField);
  reader.Time(&channel.t_s);
  reader.Number("window", 1.0, 1e7, &channel.window_s);
  return reader.Conclude(std::move(channel));
}

Result<BackgroundQuery> ParseBackgroundQuery(const QueryWords& query) {
  QueryReader reader(query, {"number", "world"});
  BackgroundQuery background;
  reader.Number("number", 0, 1000, &background.number);
  reader.Flag("world", &background.world);
  return reader.Conclude(background);
}

Result<TileQuery> ParseTileQuery(const QueryWords& query) {
  QueryReader reader(query, {"number", "z", "x", "y"});
  TileQuery asked;
  constexpr int64_t kMaxPlace = (int64_t{1} << TileName::kMaxZoom) - 1;
  reader.Number("number", 0, 1000, &asked.number);
  reader.Number("z", 0, TileName::kMaxZoom, &asked.tile.z);
  reader.Number("x", int64_t{0}, kMaxPlace, &asked.tile.x);
  reader.Number("y", int64_t{0}, kMaxPlace, &asked.tile.y);
  Result<TileQuery> concluded = reader.Conclude(asked);
  if (concluded.ok() && !IsTile(asked.tile)) {
    return Error{fmt::format("zoom {} has columns and rows from 0 to {}", asked.tile.z,
                             (int64_t{1} << asked.tile.z) - 1)};
  }
  return concluded;
}

Result<TimedFateQuery> ParseFateQuery(const QueryWords& query) {
  QueryReader reader(query, {"vehicle", "kind", "cause", "blocked", "after", "limit"});
  TimedFateQuery timed;
  reader.Name("vehicle", false, &timed.fates.vehicle);
  reader.Name("kind", false, &timed.fates.kind);
  reader.Name("cause", false, &timed.fates.cause);
  reader.Flag("blocked", &timed.fates.only_blocked);
  reader.Number("after", int64_t{-1}, INT64_MAX, &timed.fates.after);
  reader.Number("limit", 1, 500, &timed.fates.limit);
  reader.Time(&timed.t_s);
  return reader.Conclude(std::move(timed));
}

Result<CommandWords> ParseCommandBody(std::string_view body) {
  constexpr const char* kExample = R"({"target": "alpha", "words": ["goto", "100", "-50"]})";
  const nlohmann::json json = nlohmann::json::parse(body, nullptr, false);
  if (!json.is_object()) return Error{fmt::format("a command is JSON like {}", kExample)};
  for (const auto& [key, value] : json.items()) {
    if (key != "target" && key != "words") {
      return Error{fmt::format("unknown in a command: {}; it is like {}", Quoted(key), kExample)};
    }
  }
  const auto target = json.find("target");
  const auto words = json.find("words");
  if (target == json.end() || words == json.end() || !words->is_array()) {
    return Error{fmt::format("a command has a target and a list of words, like {}", kExample)};
  }
  CommandWords command;
  Result<std::string> name = WordOf(*target, "target", kLongestName);
  if (!name.ok()) return Error{name.error()};
  if (name->empty()) return Error{"target is empty"};
  command.target = std::move(*name);
  if (words->size() > kMaxWords) {
    return Error{fmt::format("more than {} words", kMaxWords)};
  }
  for (const nlohmann::json& each : *words) {
    Result<std::string> word = WordOf(each, "each of the words", kLongestWord);
    if (!word.ok()) return Error{word.error()};
    command.words.push_back(std::move(*word));
  }
  return command;
}

}  // namespace shoal
