#include "lib/mission/track/gpx_track.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "lib/base/text/blanks.h"
#include "lib/base/text/numbers.h"
#include "lib/base/time/seconds.h"
#include "lib/base/time/utc_time.h"
#include "lib/mission/track/iso_time.h"

namespace shoal {

namespace {

/// Longer texts are neither numbers nor times.
constexpr size_t kMaxText = 100;
/// GPX has seven levels, and extensions a few more. A parser remembers each open element, each name
/// and all of an element until it ends.
constexpr int kMaxNesting = 100;
constexpr size_t kMaxNames = 1000;
constexpr size_t kLongestElement_bytes = size_t{1} << 20;
constexpr size_t kMaxTracks = 10'000;

/// A <trkpt> as the file has it.
struct GpxPoint {
  int64_t time_us = 0;
  GeoPoint place;
  double elevation_m = 0;
  uint64_t line = 0;
};

/// A <trk>.
struct GpxTrack {
  size_t number = 0;  ///< In the file, from 1.
  std::string name = "";
  std::vector<GpxPoint> points = {};
  std::string problem = "";  ///< Of its first point that is not one; those behind it are left out.
  uint64_t problem_line = 0;
};

/// "gpx:trkpt" and "trkpt" are the same.
std::string_view LocalName(std::string_view name) { return name.substr(name.rfind(':') + 1); }

class GpxReader {
 public:
  explicit GpxReader(const TrackSource& source)
      : source_(source), parser_(XML_ParserCreate(nullptr)) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), OnStart, OnEnd);
    XML_SetCharacterDataHandler(parser_.get(), OnText);
    XML_SetStartDoctypeDeclHandler(parser_.get(), OnDoctype);
    XML_SetUnknownEncodingHandler(parser_.get(), OnEncoding, this);
  }

  /// Reads the whole document.
  [[nodiscard]] std::string Parse(std::string_view text) {
    // expat counts in int; the text comes in pieces.
    constexpr size_t kChunk = kLongestElement_bytes;
    const std::string_view whole = text;
    do {
      const std::string_view chunk = text.substr(0, kChunk);
      text.remove_prefix(chunk.size());
      if (XML_Parse(parser_.get(), chunk.data(), static_cast<int>(chunk.size()), text.empty()) !=
          XML_STATUS_OK) {
        return ProblemOrFault(whole);
      }
      // What the parser still keeps of the text is an element that has not ended.
      const auto at = static_cast<size_t>(std::max<XML_Index>(0, ByteIndex()));
      if (whole.size() - text.size() > at + 2 * kLongestElement_bytes) {
        line_ = Line();
        return fmt::format("an element is longer than {} bytes; is this GPX?",
                           kLongestElement_bytes);
      }
    } while (!text.empty());
    return "";
  }

  uint64_t line() const { return line_; }
  std::vector<GpxTrack>& tracks() { return tracks_; }

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

  /// The encodings of expat itself are UTF-8, UTF-16, ISO-8859-1 and US-ASCII.
  static int OnEncoding(void* self, const XML_Char* name, XML_Encoding* /*info*/) {
    Self(self).Refuse(
        fmt::format("the encoding of the file is {}: save it as UTF-8", QuotedWord(name)));
    return XML_STATUS_ERROR;
  }

  XML_Index ByteIndex() const { return XML_GetCurrentByteIndex(parser_.get()); }
  uint64_t Line() const { return XML_GetCurrentLineNumber(parser_.get()); }

  /// What stopped the parser: a check of this class, or a fault of the XML.
  std::string ProblemOrFault(std::string_view whole) {
    if (!problem_.empty()) return problem_;
    line_ = Line();
    const XML_Error error = XML_GetErrorCode(parser_.get());
    const XML_Index at = ByteIndex();
    const bool is_beyond_ascii = at >= 0 && static_cast<size_t>(at) < whole.size() &&
                                 static_cast<unsigned char>(whole[static_cast<size_t>(at)]) > 0x7F;
    if (error == XML_ERROR_INCORRECT_ENCODING ||
        (error == XML_ERROR_INVALID_TOKEN && is_beyond_ascii)) {
      return "the text is not in the encoding that the file names (UTF-8 if it names none): save "
             "it as UTF-8";
    }
    return fmt::format("this is not well-formed XML ({}); is the file complete, and GPX?",
                       XML_ErrorString(error));
  }

  /// Refuses the whole document, at the line where the parser is.
  void Refuse(std::string problem) {
    if (!problem_.empty()) return;
    problem_ = std::move(problem);
    line_ = Line();
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  /// Refuses the track that is open.
  void RefuseTrack(uint64_t line, std::string problem) {
    GpxTrack& track = tracks_.back();
    if (!track.problem.empty()) return;
    track.problem = std::move(problem);
    track.problem_line = line;
  }

  void NoteName(std::string_view name) {
    if (names_.find(name) != names_.end()) return;
    if (names_.size() == kMaxNames) {
      return Refuse(
          fmt::format("more than {} names of elements and attributes; is this GPX?", kMaxNames));
    }
    names_.emplace(name);
  }

  void OpenTrack() {
    // A track without points does not count.
    if (!tracks_.empty() && tracks_.back().points.empty() && tracks_.back().problem.empty()) {
      tracks_.pop_back();
    }
    if (tracks_.size() == kMaxTracks) {
      return Refuse(fmt::format("more than {} tracks; divide the file", kMaxTracks));
    }
    tracks_.push_back({.number = ++num_tracks_});
  }

  void Start(std::string_view name, const XML_Char** attributes) {
    ++depth_;
    text_.clear();
    if (!problem_.empty()) return;
    if (depth_ == 1 && name != "gpx") {
      return Refuse(fmt::format("the document is <{}>, and must be <gpx>",
                                QuotedWord(name).substr(1, name.size())));
    }
    if (depth_ > kMaxNesting) {
      return Refuse(
          fmt::format("elements are nested more than {} deep; is this GPX?", kMaxNesting));
    }
    NoteName(name);
    for (const XML_Char** each = attributes; each[0] != nullptr; each += 2) NoteName(each[0]);
    if (name == "trk" && point_depth_ == 0) {
      track_depth_ = depth_;
      return OpenTrack();
    }
    if (name == "trkpt") StartPoint(attributes);
  }

  void StartPoint(const XML_Char** attributes) {
    if (point_depth_ > 0) return Refuse("a <trkpt> within a <trkpt>; is the file damaged?");
    if (track_depth_ == 0 && tracks_.empty()) OpenTrack();
    point_depth_ = depth_;
    point_line_ = Line();
    latitude_.reset();
    longitude_.reset();
    time_us_.reset();
    elevation_m_.reset();
    for (; attributes[0] != nullptr; attributes += 2) {
      if (std::string_view(attributes[0]) == "lat") latitude_ = NumberIn(attributes[1]);
      if (std::string_view(attributes[0]) == "lon") longitude_ = NumberIn(attributes[1]);
    }
    if (!latitude_ || !longitude_) {
      RefuseTrack(point_line_, "this <trkpt> needs two finite numbers: lat=\"54.4\" lon=\"10.2\"");
    }
  }

  void Text(std::string_view text) {
    text_.append(text.substr(0, kMaxText - std::min(kMaxText, text_.size())));
  }

  void End(std::string_view name) {
    if (!problem_.empty()) return;
    if (point_depth_ > 0 && depth_ == point_depth_ + 1) TakeMember(name);
    if (point_depth_ > 0 && depth_ == point_depth_) AddPoint();
    if (track_depth_ > 0 && depth_ == track_depth_ + 1 && name == "name") {
      tracks_.back().name = Trimmed(text_);
    }
    if (depth_ == track_depth_) track_depth_ = 0;
    --depth_;
    text_.clear();
  }

  /// A child of <trkpt> has ended.
  void TakeMember(std::string_view name) {
    const std::string_view word = Trimmed(text_);
    if (name == "time") {
      time_us_ = ParseLoggedTime(word);
      if (!time_us_) {
        RefuseTrack(Line(), fmt::format("<time> is {}, and must be ISO 8601, as "
                                        "2026-11-23T09:30:00Z, from {} to {}",
                                        QuotedWord(word), kFirstLoggedYear, kLastClockYear));
      }
    }
    if (name == "ele" && source_.underwater) {
      elevation_m_ = NumberIn(word);
      if (!elevation_m_) {
        RefuseTrack(Line(), fmt::format("<ele> is {}, and must be a finite number of metres",
                                        QuotedWord(word)));
      }
    }
  }

  void AddPoint() {
    point_depth_ = 0;
    if (!tracks_.back().problem.empty()) return;
    if (!time_us_) {
      return RefuseTrack(point_line_,
                         "this <trkpt> has no <time>: export the track with its times");
    }
    if (source_.underwater && !elevation_m_) {
      return RefuseTrack(point_line_,
                         "this <trkpt> has no <ele>, and underwater = true needs the depth of each "
                         "point: as -12 for 12 m");
    }
    tracks_.back().points.push_back({.time_us = *time_us_,
                                     .place = {.lat_deg = *latitude_, .lon_deg = *longitude_},
                                     .elevation_m = elevation_m_.value_or(0),
                                     .line = point_line_});
  }

  const TrackSource& source_;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, FreeParser> parser_;
  std::string problem_;      ///< Of the document.
  uint64_t line_ = 0;        ///< Of the problem.
  int depth_ = 0;            ///< Of open elements.
  int track_depth_ = 0;      ///< That of the open <trk>; 0: none is.
  int point_depth_ = 0;      ///< Likewise, of the open <trkpt>.
  uint64_t point_line_ = 0;  ///< Where that begins.
  std::string text_;         ///< Of the innermost element.
  std::optional<double> latitude_;
  std::optional<double> longitude_;
  std::optional<double> elevation_m_;
  std::optional<int64_t> time_us_;
  std::set<std::string, std::less<>> names_;  ///< Of elements and attributes.
  std::vector<GpxTrack> tracks_;
  size_t num_tracks_ = 0;  ///< Those without points too.
};

/// Lists tracks for messages: "1 'Ferry' (2 points from 2024-05-01T10:00:00Z to ...)".
std::string ListOf(const std::vector<GpxTrack>& tracks) {
  constexpr size_t kMaxShown = 8;
  std::string text;
  for (size_t i = 0; i < std::min(tracks.size(), kMaxShown); ++i) {
    const GpxTrack& track = tracks[i];
    text += fmt::format("{}{} {} ({} points", i == 0 ? "" : ", ", track.number,
                        track.name.empty() ? "without a name" : QuotedWord(track.name),
                        track.points.size());
    if (!track.points.empty()) {
      text += fmt::format(" from {} to {}", IsoTimeText(track.points.front().time_us),
                          IsoTimeText(track.points.back().time_us));
    }
    text += ")";
  }
  return text +
         (tracks.size() > kMaxShown ? fmt::format(", {} more", tracks.size() - kMaxShown) : "");
}

/// Leaves the tracks that the source chooses, or returns why none is.
std::string ChooseTrack(const TrackSource& source, std::vector<GpxTrack>& tracks) {
  if (source.vessel.empty() && source.number == 0) return "";
  const auto is_chosen = [&](const GpxTrack& track) {
    return source.number != 0 ? track.number == static_cast<size_t>(source.number)
                              : track.name == std::string_view(source.vessel).substr(0, kMaxText);
  };
  const auto num_chosen = std::ranges::count_if(tracks, is_chosen);
  if (num_chosen == 1) {
    std::erase_if(tracks, [&](const GpxTrack& track) { return !is_chosen(track); });
    return "";
  }
  const std::string which =
      source.number != 0 ? fmt::format("the number {}", source.number) : QuotedWord(source.vessel);
  return fmt::format("{} of its tracks {} {}{}: {}", num_chosen == 0 ? "none" : "several",
                     num_chosen == 0 ? "is" : "are", which,
                     num_chosen == 0 ? "" : "; choose one by its number", ListOf(tracks));
}

/// Returns where to choose a track.
std::string ChoiceOf(const std::vector<GpxTrack>& tracks) {
  return "choose one by name = \"...\" or number = N beside file: " + ListOf(tracks);
}

std::string AddTo(TrackBuilder& builder, const TrackSource& source, const GpxPoint& point) {
  ReplayFix fix{.time_us = point.time_us};
  if (source.underwater) fix.position_m.z() = point.elevation_m;
  return builder.Add(fix, point.place, point.line);
}

/// Returns why the first point of a track does not follow the last one of the track before; empty:
/// it is wrong by itself.
std::string WhyNotBehind(const TrackSource& source, const GpxPoint& last, const GpxPoint& first) {
  TrackBuilder alone(source, DepthPositive::kUp);
  if (!AddTo(alone, source, first).empty()) return "";
  const double later_s = Seconds(first.time_us - last.time_us);
  return later_s < 0
             ? fmt::format("this track begins {:g} s before the one in front of it ends", -later_s)
             : fmt::format(
                   "this track begins {:g} s after the one in front of it ends, too "
                   "far from there",
                   later_s);
}

/// Makes one track of the points of all.
Result<ReplayTrack> JoinTracks(const TrackSource& source, const std::vector<GpxTrack>& tracks,
                               std::vector<std::string>* warnings) {
  TrackBuilder builder(source, DepthPositive::kUp);
  const GpxPoint* last = nullptr;
  for (const GpxTrack& track : tracks) {
    const GpxPoint* const last_of_other = last;
    for (const GpxPoint& point : track.points) {
      std::string problem = AddTo(builder, source, point);
      if (!problem.empty()) {
        if (last_of_other != nullptr && last == last_of_other) {
          const std::string why = WhyNotBehind(source, *last, point);
          if (!why.empty()) problem = why + ": " + ChoiceOf(tracks);
        }
        return Error{fmt::format("{}:{}: {}", source.name, point.line, problem)};
      }
      last = &point;
    }
    if (!track.problem.empty()) {
      return Error{fmt::format("{}:{}: {}", source.name, track.problem_line, track.problem)};
    }
  }
  if (tracks.size() > 1 && warnings != nullptr) {
    warnings->push_back(
        fmt::format("{}: its {} tracks count as one; if they are not of one vessel, {}",
                    source.name, tracks.size(), ChoiceOf(tracks)));
  }
  return builder.Finish({.depth = source.underwater}, warnings);
}

}  // namespace

Result<ReplayTrack> ParseGpxTrack(std::string_view text, const TrackSource& source,
                                  std::vector<std::string>* warnings) {
  GpxReader reader(source);
  if (std::string problem = reader.Parse(text); !problem.empty()) {
    return Error{fmt::format("{}:{}: {}", source.name, reader.line(), problem)};
  }
  std::vector<GpxTrack> tracks = std::move(reader.tracks());
  std::erase_if(
      tracks, [](const GpxTrack& track) { return track.points.empty() && track.problem.empty(); });
  if (tracks.empty()) {
    return Error{source.name + ": no <trkpt> in it: export the track, not its route or waypoints"};
  }
  if (std::string problem = ChooseTrack(source, tracks); !problem.empty()) {
    return Error{source.name + ": " + problem};
  }
  return JoinTracks(source, tracks, warnings);
}

}  // namespace shoal
