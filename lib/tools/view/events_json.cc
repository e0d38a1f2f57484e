#include "lib/tools/view/events_json.h"

#include "lib/base/time/seconds.h"
#include "lib/tools/view/json_writer.h"

namespace shoal {

std::string EventsJson(std::span<const ViewEvent> events, int64_t start_utime) {
  JsonWriter json;
  json.BeginObject().Key("events").BeginArray();
  int64_t id = 0;
  for (const ViewEvent& event : events) {
    json.BeginObject()
        .Integer("id", ++id)
        .Number("t", Seconds(event.utime - PlausibleUtime(start_utime)), 3)
        .Text("kind", EventKindText(event.kind))
        .Key("vehicles")
        .BeginArray();
    for (const std::string& vehicle : event.vehicles) json.Text(vehicle);
    json.EndArray().Text("text", event.text);
    if (!event.plan.empty()) json.Key("plan").Raw(event.plan);
    json.EndObject();
  }
  json.EndArray().EndObject();
  return json.Take();
}

}  // namespace shoal
