#include "lib/mission/track/gpx_track.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

#include "lib/base/text/blanks.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/track/iso_time.h"

namespace shoal {

namespace {

/// Longer texts are no numbers and no times.
constexpr size_t kMaxText = 100;

/// "gpx:trkpt" and "trkpt" are the same.
std::string_view LocalName(std::string_view name) { return name.substr(name.rfind(':') + 1); }

class GpxReader {
 public:
  explicit GpxReader(const TrackSource& source)
      : source_(source), builder_(source), parser_(XML_ParserCreate(nullptr)) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), OnStart, OnEnd);
    XML_SetCharacterDataHandler(parser_.get(), OnText);
    XML_SetStartDoctypeDeclHandler(parser_.get(), OnDoctype);
  }

  Result<ReplayTrack> Read(std::string_view text) {
    // expat counts in int; the text comes in pieces.
    constexpr size_t kChunk = size_t{1} << 20;
    do {
      const std::string_view chunk = text.substr(0, kChunk);
      text.remove_prefix(chunk.size());
      if (XML_Parse(parser_.get(), chunk.data(), static_cast<int>(chunk.size()), text.empty()) !=
          XML_STATUS_OK) {
        return Error{fmt::format("{}:{}: {}", source_.name, line_, ProblemOrFault())};
      }
    } while (!text.empty());
    if (builder_.size() == 0) {
      return Error{source_.name +
                   ": no <trkpt> in it: export the track, not its route or waypoints"};
    }
    return builder_.Finish({.depth = source_.underwater});
  }

 private:
  struct FreeParser {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };

  static GpxReader& Self(void* self) { return *static_cast<GpxReader*>(self); }
  static void OnStart(void* self, const XML_Char* name, const XML_Char** attributes) {
    Self(self).Start(LocalName(name), attributes);
  }
  static void OnEnd(void* self, const XML_Char* name) { Self(self).End(LocalName(name)); }
  static void OnText(void* self, const XML_Char* text, int length) {
    Self(self).Text({text, static_cast<size_t>(length)});
  }
  static void OnDoctype(void* self, const XML_Char* /*name*/, const XML_Char* /*system_id*/,
                        const XML_Char* /*public_id*/, int /*has_internal_subset*/) {
    Self(self).Refuse("a DOCTYPE has no place in GPX: remove it");
  }

  /// What stopped the parser: a check of this class, or a fault of the XML.
  std::string ProblemOrFault() {
    if (!problem_.empty()) return problem_;
    line_ = XML_GetCurrentLineNumber(parser_.get());
    return fmt::format("this is no sound XML ({}); is the file complete, and GPX?",
                       XML_ErrorString(XML_GetErrorCode(parser_.get())));
  }

  void Refuse(std::string problem) {
    RefuseAt(XML_GetCurrentLineNumber(parser_.get()), std::move(problem));
  }

  void RefuseAt(uint64_t line, std::string problem) {
    if (!problem_.empty()) return;
    problem_ = std::move(problem);
    line_ = line;
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  void Start(std::string_view name, const XML_Char** attributes) {
    ++depth_;
    text_.clear();
    if (depth_ == 1 && name != "gpx") {
      return Refuse(fmt::format("the document is <{}>, and must be <gpx>",
                                QuotedWord(name).substr(1, name.size())));
    }
    if (name != "trkpt") return;
    if (point_depth_ > 0) return Refuse("a <trkpt> within a <trkpt>; is the file damaged?");
    point_depth_ = depth_;
    point_line_ = XML_GetCurrentLineNumber(parser_.get());
    latitude_.reset();
    longitude_.reset();
    time_us_.reset();
    elevation_m_.reset();
    for (; attributes[0] != nullptr; attributes += 2) {
      if (std::string_view(attributes[0]) == "lat") latitude_ = NumberIn(attributes[1]);
      if (std::string_view(attributes[0]) == "lon") longitude_ = NumberIn(attributes[1]);
    }
    if (!latitude_ || !longitude_) {
      Refuse("this <trkpt> needs two finite numbers: lat=\"54.4\" lon=\"10.2\"");
    }
  }

  void Text(std::string_view text) {
    text_.append(text.substr(0, kMaxText - std::min(kMaxText, text_.size())));
  }

  void End(std::string_view name) {
    if (!problem_.empty()) return;
    if (point_depth_ > 0 && depth_ == point_depth_ + 1) TakeMember(name);
    if (point_depth_ > 0 && depth_ == point_depth_) AddPoint();
    --depth_;
    text_.clear();
  }

  /// A child of <trkpt> has ended.
  void TakeMember(std::string_view name) {
    const std::string_view word = Trimmed(text_);
    if (name == "time") {
      time_us_ = ParseLoggedTime(word);
      if (!time_us_) {
        Refuse(fmt::format("<time> is {}, and must be ISO 8601: 2026-11-23T09:30:00Z",
                           QuotedWord(word)));
      }
    }
    if (name == "ele" && source_.underwater) {
      elevation_m_ = NumberIn(word);
      if (!elevation_m_) {
        Refuse(fmt::format("<ele> is {}, and must be a finite number of metres", QuotedWord(word)));
      }
    }
  }

  void AddPoint() {
    point_depth_ = 0;
    if (!problem_.empty()) return;
    if (!time_us_) {
      return RefuseAt(point_line_, "this <trkpt> has no <time>: export the track with its times");
    }
    if (source_.underwater && !elevation_m_) {
      return RefuseAt(point_line_,
                      "this <trkpt> has no <ele>, and underwater = true needs the depth of each "
                      "point: as -12 for 12 m");
    }
    ReplayFix fix{.time_us = *time_us_};
    if (elevation_m_) fix.position_m.z() = -*elevation_m_;
    std::string problem = builder_.Add(fix, {.lat_deg = *latitude_, .lon_deg = *longitude_});
    if (!problem.empty()) RefuseAt(point_line_, std::move(problem));
  }

  const TrackSource& source_;
  TrackBuilder builder_;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, FreeParser> parser_;
  std::string problem_;
  uint64_t line_ = 0;        ///< Of the problem.
  int depth_ = 0;            ///< Of open elements.
  int point_depth_ = 0;      ///< That of the open <trkpt>; 0: none is.
  uint64_t point_line_ = 0;  ///< Where that begins.
  std::string text_;         ///< Of the innermost element.
  std::optional<double> latitude_;
  std::optional<double> longitude_;
  std::optional<double> elevation_m_;
  std::optional<int64_t> time_us_;
};

}  // namespace

Result<ReplayTrack> ParseGpxTrack(std::string_view text, const TrackSource& source) {
  return GpxReader(source).Read(text);
}

}  // namespace shoal
