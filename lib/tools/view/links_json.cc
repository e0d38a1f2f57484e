#include "lib/tools/view/links_json.h"

#include <fmt/format.h>

#include "lib/tools/view/fate_text.h"
#include "lib/tools/view/fates_json.h"
#include "lib/tools/view/json_writer.h"
#include "lib/tools/view/view_limits.h"

namespace shoal {

namespace {

bool Receives(const Scene& scene, const LinkCounts& link) {
  if (!IsReceived(link.last.cause)) return false;
  if (!scene.rules() || !(scene.rules()->stale_time_s >= 0)) return true;
  return scene.now_s() - scene.SecondsOf(link.last.utime) <= scene.rules()->stale_time_s;
}

void WriteLink(const Scene& scene, const NameTable& names, const LinkCounts& link,
               JsonWriter* json) {
  json->BeginObject()
      .Text("from", names.at(link.from))
      .Text("to", names.at(link.to))
      .Boolean("receives", Receives(scene, link))
      .Integer("delivered", static_cast<int64_t>(link.Received()))
      .Integer("offered", static_cast<int64_t>(link.Offered()))
      .Key("last_received_s");
  if (link.last_received_utime == LinkCounts::kNeverReceived) {
    json->Null();
  } else {
    json->Number(scene.SecondsOf(link.last_received_utime), kMilliseconds);
  }
  json->Text("cause", CauseText(link.last.cause))
      .Text("text", DecidingNumbers(link.last))
      .Number("t", scene.SecondsOf(link.last.utime), kMilliseconds)
      .EndObject();
}

void WriteCounts(const LinkCounts& counts, JsonWriter* json) {
  json->Key("causes").BeginObject();
  for (size_t i = 0; i < counts.by_cause.size(); ++i) {
    if (counts.by_cause[i] == 0) continue;
    json->Integer(CauseText(static_cast<Cause>(i)), counts.by_cause[i]);
  }
  json->EndObject().Key("by_kind").BeginObject();
  for (size_t i = 0; i < counts.offered.size(); ++i) {
    if (counts.offered[i] == 0) continue;
    json->Key(KindText(static_cast<Kind>(i)))
        .BeginObject()
        .Integer("delivered", counts.received[i])
        .Integer("offered", counts.offered[i])
        .EndObject();
  }
  json->EndObject();
}

/// Writes an array of what `write` writes of each.
template <class T, class F>
void WriteEach(const std::vector<T>& items, std::string_view key, JsonWriter* json, F write) {
  json->Key(key).BeginArray();
  for (const T& item : items) write(item);
  json->EndArray();
}

void WriteRatio(const std::vector<RatioBin>& bins, JsonWriter* json) {
  json->Key("ratio").BeginObject();
  WriteEach(bins, "t", json,
            [&](const RatioBin& bin) { json->Number(bin.begin_s, kMilliseconds); });
  WriteEach(bins, "delivered", json, [&](const RatioBin& bin) { json->Integer(bin.received); });
  WriteEach(bins, "offered", json, [&](const RatioBin& bin) { json->Integer(bin.offered); });
  json->EndObject();
}

void WriteRanges(const std::vector<RangeSample>& ranges, JsonWriter* json) {
  json->Key("range").BeginObject();
  WriteEach(ranges, "t", json,
            [&](const RangeSample& range) { json->Number(range.t_s, kMilliseconds); });
  WriteEach(ranges, "range_m", json,
            [&](const RangeSample& range) { json->Number(range.range_m, 2); });
  WriteEach(ranges, "limit_m", json, [&](const RangeSample& range) {
    if (range.limit_m >= 0) {
      json->Number(range.limit_m, 2);
    } else {
      json->Null();
    }
  });
  json->EndObject();
}

/// The names are those of all links, so that the matrix keeps its shape.
std::string JsonOf(const Scene& scene, const LinkBook& links) {
  JsonWriter json;
  json.BeginObject().Number("t", scene.now_s(), kMilliseconds).Key("names").BeginArray();
  for (const std::string& name : scene.links().names().all()) json.Text(name);
  json.EndArray();
  if (const auto media = scene.media_links().Names(); !media.empty()) {
    json.Key("media").BeginArray();
    for (const std::string_view medium : media) json.Text(medium);
    json.EndArray();
  }
  json.Key("links").BeginArray();
  for (const LinkCounts& link : links.links()) WriteLink(scene, links.names(), link, &json);
  json.EndArray().EndObject();
  return json.Take();
}

}  // namespace

std::string LinksJson(const Scene& scene) { return JsonOf(scene, scene.links()); }

Result<std::string> MediumLinksJson(const Scene& scene, std::string_view medium) {
  const LinkBook* links = scene.media_links().Find(medium);
  if (links != nullptr) return JsonOf(scene, *links);
  const std::vector<std::string_view> names = scene.media_links().Names();
  return Error{fmt::format("no medium '{}' is known; there are: {}",
                           medium.substr(0, kMaxNameBytes),
                           names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")))};
}

std::string LinkJson(const Scene& scene, const LinkAnswer& answer) {
  JsonWriter json;
  json.BeginObject().Text("from", answer.from).Text("to", answer.to);
  WriteCounts(answer.counts == nullptr ? LinkCounts{} : *answer.counts, &json);
  WriteRatio(answer.bins, &json);
  WriteRanges(answer.ranges, &json);
  json.Key("fates");
  WriteFates(answer.fates, scene, &json);
  json.EndObject();
  return json.Take();
}

}  // namespace shoal
