#include "apps/viewer/view_site.h"

#include <fmt/format.h>

#include <map>

#include "lib/mission/toml/suggest.h"
#include "lib/tools/view/background_tiles.h"
#include "lib/tools/view/json_writer.h"

namespace shoal {

namespace {

WebAnswer Json(std::string body) { return {.body = std::move(body)}; }

/// Answers with the result of `make` for the parsed query, or with the error of parsing.
template <class T, class Make>
WebAnswer Answer(const Result<T>& query, Make make) {
  if (!query.ok()) return ErrorAnswer(400, query.error());
  return make(*query);
}

WebAnswer OrNotFound(Result<std::string> json) {
  return json.ok() ? Json(std::move(*json)) : ErrorAnswer(404, json.error());
}

/// Bytes of a file of the mission; a browser that opens them by itself saves them.
WebAnswer BytesOrNotFound(Result<std::string> bytes) {
  if (!bytes.ok()) return ErrorAnswer(404, bytes.error());
  return {.content_type = "application/octet-stream", .body = std::move(*bytes)};
}

WebAnswer NoSuchPath(const std::string& path) {
  return ErrorAnswer(404, fmt::format("there is no {} here", Quoted(path)));
}

/// What is asked of a channel, by how the query calls it.
const std::map<std::string, const char*> kChannelPaths = {{"/api/channels", "text"},
                                                          {"/api/message", "channel"},
                                                          {"/api/fields", "text"},
                                                          {"/api/series", "field"}};

}  // namespace

std::optional<WebAnswer> ViewSite::Deny(const WebRequest& request) {
  // Before the access rules, whose error would recommend --allow-commands.
  if (request.path == kCommandPath && !parts_.command) {
    return ErrorAnswer(404, "a recorded mission takes no commands");
  }
  return FindDenial(parts_.access, request);
}

WebAnswer ViewSite::Reply(const WebRequest& request) {
  if (request.path.starts_with("/api/")) return ReplyWithData(request);
  const auto file = parts_.files.find(request.path);
  if (file == parts_.files.end()) return NoSuchPath(request.path);
  return {.content_type = file->second.content_type,
          .cache_control = "no-cache",
          .body = file->second.bytes};
}

WebAnswer ViewSite::ReplyOfChannels(const WebRequest& request) {
  const std::string& path = request.path;
  const bool needs_name = path == "/api/message" || path == "/api/series";
  const auto asked = ParseChannelQuery(request.query, kChannelPaths.at(path), needs_name);
  return Answer(asked, [&](const ChannelQuery& query) {
    const std::shared_ptr<ChannelSource> channels = parts_.channels();
    if (path == "/api/channels") return Json(channels->ChannelsJson(query.t_s));
    if (path == "/api/fields") return Json(channels->FieldsJson(query.name, query.t_s));
    if (path == "/api/message") return OrNotFound(channels->MessageJson(query.name, query.t_s));
    return OrNotFound(channels->SeriesJson(query.name, query.t_s, query.window_s));
  });
}

WebAnswer ViewSite::OutsideJson() const {
  JsonWriter json;
  json.BeginObject().Key("tiles");
  if (parts_.outside_tiles.empty()) {
    json.Null();
  } else {
    json.Text(parts_.outside_tiles);
  }
  json.EndObject();
  return Json(json.Take());
}

WebAnswer ViewSite::ReplyWithData(const WebRequest& request) {
  const std::string& path = request.path;
  const QueryWords& query = request.query;
  if (path == kCommandPath) {
    return Answer(ParseCommandBody(request.body),
                  [&](const CommandWords& words) { return parts_.command(words); });
  }
  if (parts_.plan) {
    if (path == kPlanPath) return parts_.plan->Look(request.body);
    if (path == kPlanWritePath) return parts_.plan->Write(request.body);
    if (path == kPlanRunPath) return parts_.plan->Run(request.body);
  }
  const std::shared_ptr<ViewSource> source = parts_.source();
  if (path == "/api/fates") {
    return Answer(ParseFateQuery(query), [&](const TimedFateQuery& asked) {
      return Json(source->FatesJson(asked.fates, asked.t_s));
    });
  }
  if (path == "/api/links") {
    return Answer(ParseLinksQuery(query), [&](const LinksQuery& asked) {
      if (asked.medium.empty()) return Json(source->LinksJson(asked.t_s));
      return OrNotFound(source->MediumLinksJson(asked.medium, asked.t_s));
    });
  }
  if (path == "/api/link") {
    return Answer(ParseLinkQuery(query), [&](const LinkQuery& asked) {
      return OrNotFound(source->LinkJson(asked.from, asked.to, asked.t_s));
    });
  }
  if (path == "/api/background") {
    return Answer(ParseBackgroundQuery(query), [&](const BackgroundQuery& asked) {
      return BytesOrNotFound(
          source->Backgrounds().Read(static_cast<size_t>(asked.number), asked.world));
    });
  }
  if (path == "/api/tile") {
    return Answer(ParseTileQuery(query), [&](const TileQuery& asked) {
      return BytesOrNotFound(
          TileOf(source->Backgrounds(), static_cast<size_t>(asked.number), asked.tile));
    });
  }
  if (path == "/api/vehicle") {
    return Answer(ParseVehicleQuery(query), [&](const VehicleQuery& asked) {
      return OrNotFound(source->VehicleJson(asked.name, asked.t_s, asked.window_s));
    });
  }
  if (parts_.channels && kChannelPaths.contains(path)) return ReplyOfChannels(request);
  return Answer(ParseTimeQuery(query), [&](double t_s) {
    if (path == kStreamPath && parts_.is_live) return WebAnswer{.is_stream = true};
    if (path == "/api/status" && parts_.status) return Json(parts_.status());
    if (path == "/api/setup") {
      return Json(source->SetupJson(MaySendCommands(parts_.access, request)));
    }
    if (path == "/api/outside") return OutsideJson();
    if (path == "/api/frame") return Json(source->FrameJson(t_s));
    if (path == "/api/trails") return Json(source->TrailsJson());
    if (path == "/api/events") return Json(source->EventsJson());
    if (path == "/api/verdict") return Json(source->VerdictJson());
    if (!parts_.is_live && (path == kStreamPath || path == "/api/status")) {
      return ErrorAnswer(404, "not available for a recorded mission");
    }
    return NoSuchPath(path);
  });
}

}  // namespace shoal
