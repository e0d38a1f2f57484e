#include "lib/tools/view/fates_json.h"

#include "lib/tools/view/fate_text.h"

namespace shoal {

namespace {

/// Writes a range; null where it is not known, or there is no limit: negative, or not finite.
void WriteMetres(std::string_view key, double metres, JsonWriter* json) {
  json->Key(key);
  if (metres >= 0) {
    json->Number(metres, kCentimetres);
  } else {
    json->Null();
  }
}

}  // namespace

std::string FatesJson(const FateHistory& history, const FateQuery& query, const Scene& scene) {
  JsonWriter json;
  json.BeginObject().Key("fates");
  WriteFates(history.Find(query), scene, &json);
  json.Key("kinds").BeginArray();
  for (size_t i = 0; i < history.kinds_seen().size(); ++i) {
    if (history.kinds_seen()[i]) json.Text(KindText(static_cast<Kind>(i)));
  }
  json.EndArray().Key("causes").BeginArray();
  for (size_t i = 0; i < history.causes_seen().size(); ++i) {
    if (history.causes_seen()[i]) json.Text(CauseText(static_cast<Cause>(i)));
  }
  json.EndArray().Integer("forgotten", history.num_forgotten()).EndObject();
  return json.Take();
}

void WriteFates(const std::vector<const KeptFate*>& fates, const Scene& scene, JsonWriter* json) {
  json->BeginArray();
  for (const KeptFate* fate : fates) {
    json->BeginObject()
        .Integer("id", fate->id)
        .Number("t", scene.SecondsOf(fate->facts.utime), 3)
        .Text("kind", KindText(fate->facts.kind))
        .Text("source", fate->source)
        .Text("destination", fate->destination)
        .Integer("count", fate->facts.count)
        .Integer("number", fate->facts.number)
        .Text("cause", CauseText(fate->facts.cause))
        .Text("rule", OverrideText(fate->facts.override_rule))
        .Text("text", FateText(fate->view()));
    WriteMetres("range_m", fate->facts.range_m, json);
    WriteMetres("limit_m", fate->facts.limit_m, json);
    if (!fate->medium.empty()) json->Text("medium", fate->medium);
    json->EndObject();
  }
  json->EndArray();
}

}  // namespace shoal
