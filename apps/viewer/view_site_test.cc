#include "apps/viewer/view_site.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>

namespace shoal::view_site_test {

constexpr const char* kToken = "0123456789abcdef0123456789abcdef";

/// Answers with what it was asked.
class EchoSource : public ViewSource {
 public:
  std::string SetupJson(bool commands) override { return commands ? "setup!" : "setup"; }
  std::string FrameJson(double t_s) override { return "frame " + std::to_string(t_s); }
  std::string TrailsJson() override { return "trails"; }
  std::string LinksJson(double t_s) override { return "links " + std::to_string(t_s); }
  Result<std::string> MediumLinksJson(std::string_view medium, double t_s) override {
    if (medium == "smoke") return Error{"no medium 'smoke' is known; there are: vhf"};
    return fmt::format("links of {} {}", medium, t_s);
  }
  std::string FatesJson(const FateQuery& query, double) override {
    return "fates " + query.vehicle;
  }
  std::string EventsJson() override { return "events"; }
  std::string VerdictJson() override { return "verdict"; }
  BackgroundFolder Backgrounds() override { return backgrounds; }
  Result<std::string> LinkJson(std::string_view from, std::string_view to, double) override {
    return std::string("link ").append(from).append(" ").append(to);
  }
  Result<std::string> VehicleJson(std::string_view name, double, double window_s) override {
    if (name != "alpha") return Error{"no such vehicle"};
    return "vehicle " + std::to_string(window_s);
  }

  BackgroundFolder backgrounds = {};
};

class EchoChannels : public ChannelSource {
 public:
  std::string ChannelsJson(double t_s) override { return fmt::format("channels {}", t_s); }
  Result<std::string> MessageJson(const std::string& channel, double t_s) override {
    if (channel != "NAV_ALPHA") return Error{"no such channel"};
    return fmt::format("message {} {}", channel, t_s);
  }
  std::string FieldsJson(const std::string& text, double) override { return "fields " + text; }
  Result<std::string> SeriesJson(const std::string& field, double t_s, double window_s) override {
    return fmt::format("series {} {} {}", field, t_s, window_s);
  }
};

ViewSiteParts Parts(bool is_live) {
  ViewSiteParts parts = {.files = {{"/", {"text/html", "<html>"}}}, .is_live = is_live};
  parts.source = [source = std::make_shared<EchoSource>()] { return source; };
  if (!is_live) return parts;
  parts.access = {.allow_commands = true, .token = kToken};
  parts.status = [] { return "pages"; };
  parts.command = [](const CommandWords& words) { return WebAnswer{.body = words.target}; };
  return parts;
}

/// "200 body", or the status alone.
std::string Ask(ViewSite& site, const std::string& path, const QueryWords& query = {},
                const std::string& body = "") {
  const WebRequest request = {.method = body.empty() ? "GET" : "POST",
                              .path = path,
                              .query = query,
                              .host = "localhost",
                              .token = body.empty() ? "" : kToken,
                              .content_type = "application/json",
                              .body = body};
  const auto denial = site.Deny(request);
  const WebAnswer answer = denial ? *denial : site.Reply(request);
  if (answer.is_stream) return "stream";
  return answer.status == 200 ? answer.body : std::to_string(answer.status);
}

TEST(ViewSite, AnswersAtTheAddressesOfTheProtocol) {
  ViewSite site(Parts(true));
  EXPECT_EQ(Ask(site, "/"), "<html>");
  EXPECT_EQ(Ask(site, "/api/setup"), "setup");
  EXPECT_EQ(Ask(site, "/api/stream"), "stream");
  EXPECT_EQ(Ask(site, "/api/frame", {{"t", "1.5"}}), "frame 1.500000");
  EXPECT_EQ(Ask(site, "/api/trails"), "trails");
  EXPECT_EQ(Ask(site, "/api/links", {{"t", "2"}}), "links 2.000000");
  EXPECT_EQ(Ask(site, "/api/links", {{"medium", "vhf"}, {"t", "2"}}), "links of vhf 2");
  EXPECT_EQ(Ask(site, "/api/link", {{"from", "a"}, {"to", "b"}}), "link a b");
  EXPECT_EQ(Ask(site, "/api/fates", {{"vehicle", "a"}}), "fates a");
  EXPECT_EQ(Ask(site, "/api/vehicle", {{"name", "alpha"}, {"window", "5"}}), "vehicle 5.000000");
  EXPECT_EQ(Ask(site, "/api/status"), "pages");
  EXPECT_EQ(Ask(site, "/api/events"), "events");
  EXPECT_EQ(Ask(site, "/api/verdict"), "verdict");
  EXPECT_EQ(Ask(site, "/api/command", {}, R"({"target": "alpha", "words": []})"), "alpha");
}

TEST(ViewSite, AnswersWithTheFilesAndTilesOfBackgroundsAlone) {
  const std::filesystem::path folder = testing::TempDir() + "view_site-" + std::to_string(getpid());
  std::filesystem::create_directories(folder / "map/3/4");
  std::ofstream(folder / "bay.png") << "pixels";
  std::ofstream(folder / "bay.pgw") << "1 0 0 -1 0 0";
  std::ofstream(folder / "map/3/4/5.png") << "tile";
  ViewSiteParts parts = Parts(true);
  const auto source = std::make_shared<EchoSource>();
  source->backgrounds = {.folder = folder, .files = {"bay.png", "map/"}};
  parts.source = [source] { return source; };
  ViewSite site(std::move(parts));
  EXPECT_EQ(Ask(site, "/api/background", {{"number", "0"}}), "pixels");
  EXPECT_EQ(Ask(site, "/api/background", {{"number", "0"}, {"world", "1"}}), "1 0 0 -1 0 0");
  EXPECT_EQ(Ask(site, "/api/background", {{"number", "2"}}), "404");
  EXPECT_EQ(Ask(site, "/api/background", {{"number", "-1"}}), "400");
  EXPECT_EQ(Ask(site, "/api/background", {{"file", "/etc/passwd"}}), "400");
  const auto tile = [&](const char* number, const char* z, const char* x, const char* y) {
    return Ask(site, "/api/tile", {{"number", number}, {"z", z}, {"x", x}, {"y", y}});
  };
  EXPECT_EQ(tile("1", "3", "4", "5"), "tile");
  EXPECT_EQ(tile("1", "3", "4", "6"), "") << "it does not have this one";
  EXPECT_EQ(tile("0", "3", "4", "5"), "404") << "it has no tiles";
  EXPECT_EQ(tile("7", "3", "4", "5"), "404");
  for (const char* y : {"8", "-1", "../5", "5.png", "1e3", "99999999999999999999"}) {
    EXPECT_EQ(tile("1", "3", "4", y), "400") << y;
  }
  EXPECT_EQ(tile("1", "25", "4", "5"), "400");
  std::filesystem::remove_all(folder);
}

TEST(ViewSite, AnswersWhatChannelsCarry) {
  ViewSiteParts parts = Parts(false);
  parts.channels = [channels = std::make_shared<EchoChannels>()] { return channels; };
  ViewSite site(std::move(parts));
  EXPECT_EQ(Ask(site, "/api/channels", {{"t", "2"}}), "channels 2");
  EXPECT_EQ(Ask(site, "/api/message", {{"channel", "NAV_ALPHA"}, {"t", "2"}}),
            "message NAV_ALPHA 2");
  EXPECT_EQ(Ask(site, "/api/fields", {{"text", "nav x_m"}}), "fields nav x_m");
  EXPECT_EQ(Ask(site, "/api/series", {{"field", "A:b"}, {"t", "2"}, {"window", "60"}}),
            "series A:b 2 60");
  EXPECT_EQ(Ask(site, "/api/message", {{"channel", "NAV"}}), "404");
  EXPECT_EQ(Ask(site, "/api/message"), "400");
  EXPECT_EQ(Ask(site, "/api/series", {{"field", ""}}), "400");
  EXPECT_EQ(Ask(site, "/api/series", {{"field", std::string(301, 'a')}}), "400");
  EXPECT_EQ(Ask(site, "/api/series", {{"field", "A:b"}, {"window", "0"}}), "400");
  EXPECT_EQ(Ask(site, "/api/series", {{"name", "A:b"}}), "400");
}

TEST(ViewSite, WithoutChannelsHasNone) {
  ViewSite site(Parts(false));
  EXPECT_EQ(Ask(site, "/api/channels"), "404");
}

TEST(ViewSite, StatesWhatIsWrong) {
  ViewSite site(Parts(true));
  EXPECT_EQ(Ask(site, "/api/frame", {{"t", "nan"}}), "400");
  EXPECT_EQ(Ask(site, "/api/vehicle", {{"name", "unknown"}}), "404");
  EXPECT_EQ(Ask(site, "/api/vehicle"), "400");
  EXPECT_EQ(Ask(site, "/api/nothing"), "404");
  for (const char* path : {"/api/stream", "/api/status", "/api/events"}) {
    EXPECT_EQ(Ask(site, path, {{"nonsense", "1"}}), "400") << path;
  }
  EXPECT_EQ(Ask(site, "/api/"), "404");
  EXPECT_EQ(Ask(site, "/api/command", {}, "{}"), "400");
  EXPECT_EQ(Ask(site, "/../etc/passwd"), "404");
  EXPECT_EQ(Ask(site, ""), "404");
}

TEST(ViewSite, ShowsWhichRequestsMaySendCommands) {
  ViewSite site(Parts(true));
  WebRequest request = {.method = "GET", .path = "/api/setup", .host = "localhost"};
  EXPECT_EQ(site.Reply(request).body, "setup");
  request.token = kToken;
  EXPECT_EQ(site.Reply(request).body, "setup!");
}

TEST(ViewSite, HasNothingLiveOfALog) {
  ViewSite site(Parts(false));
  EXPECT_EQ(Ask(site, "/api/frame", {{"t", "1"}}), "frame 1.000000");
  EXPECT_EQ(Ask(site, "/api/stream"), "404");
  EXPECT_EQ(Ask(site, "/api/status"), "404");
  EXPECT_EQ(Ask(site, "/api/command", {}, R"({"target": "a", "words": []})"), "404");
}

TEST(ViewSite, ForbidsCachingOfData) {
  ViewSite site(Parts(true));
  WebRequest request = {.method = "GET", .path = "/api/frame", .host = "localhost"};
  EXPECT_EQ(site.Reply(request).cache_control, "no-store");
  request.path = "/";
  EXPECT_EQ(site.Reply(request).cache_control, "no-cache");
}

}  // namespace shoal::view_site_test
