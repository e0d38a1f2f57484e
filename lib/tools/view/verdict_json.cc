#include "lib/tools/view/verdict_json.h"

#include <filesystem>
#include <fstream>

#include "lib/tools/view/json_writer.h"

namespace shoal {

namespace {

constexpr int kDigits = 4;

void WriteNumber(std::string_view key, const std::optional<double>& number, JsonWriter* json) {
  json->Key(key);
  if (number) {
    json->Number(*number, kDigits);
  } else {
    json->Null();
  }
}

}  // namespace

std::string VerdictJson(const std::optional<MissionVerdict>& verdict) {
  JsonWriter json;
  json.BeginObject().Key("verdict");
  if (!verdict) {
    json.Null().EndObject();
    return json.Take();
  }
  json.BeginObject()
      .Text("result", verdict->result)
      .Text("why", verdict->why)
      .Number("t", verdict->end_s, kMilliseconds)
      .Key("expectations")
      .BeginArray();
  for (const VerdictLine& line : verdict->lines) {
    json.BeginObject().Boolean("passed", line.passed).Text("text", line.text);
    json.Text("numbers", line.numbers).Text("where", line.where).Text("unit", line.unit);
    WriteNumber("value", line.value, &json);
    WriteNumber("margin", line.margin, &json);
    json.EndObject();
  }
  json.EndArray().EndObject().EndObject();
  return json.Take();
}

std::optional<MissionVerdict> VerdictBeside(const std::string& log) {
  constexpr size_t kMaxBytes = 8 << 20;
  std::ifstream in(std::filesystem::path(log).parent_path() / "verdict.txt", std::ios::binary);
  if (!in) return std::nullopt;
  std::string text(kMaxBytes, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<size_t>(in.gcount()));
  return ReadVerdict(text);
}

}  // namespace shoal
