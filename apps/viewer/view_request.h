// Reads what a request to the viewer asks for. All input may be hostile: any input gives a
// value within the stated bounds, or an Error whose text states what to send instead. Never throws.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "apps/viewer/web_request.h"
#include "lib/base/check/result.h"
#include "lib/tools/tiles/tile_files.h"
#include "lib/tools/view/view_source.h"

namespace shoal {

/// Stands for a time that is not given: all of a log, and for a running mission now. A recorded
/// viewer clamps it.
inline constexpr double kNoTimeGiven_s = 1e12;

struct LinksQuery {
  std::string medium;  ///< Empty: all.
  double t_s = kNoTimeGiven_s;
};

struct LinkQuery {
  std::string from;
  std::string to;
  double t_s = kNoTimeGiven_s;
};

struct VehicleQuery {
  std::string name;
  double t_s = kNoTimeGiven_s;
  double window_s = 120;
};

/// Of the channels: a channel, a field, or the text of a search.
struct ChannelQuery {
  std::string name;
  double t_s = kNoTimeGiven_s;
  double window_s = 120;
};

struct BackgroundQuery {
  int number = 0;      ///< Of the mission's backgrounds, from 0.
  bool world = false;  ///< Its world file instead.
};

struct TileQuery {
  int number = 0;  ///< Of the mission's backgrounds, from 0.
  TileName tile;   ///< IsTile() holds.
};

struct TimedFateQuery {
  FateQuery fates;
  double t_s = kNoTimeGiven_s;
};

/// An order as on the command line of `shoal send`: 1 to 64 bytes of target, at most 64 words of at
/// most 1000 bytes, all UTF-8 without control characters.
struct CommandWords {
  std::string target;
  std::vector<std::string> words;
};

// Of a query: an unknown or repeated name is an error; `t` and `token` are known everywhere.
Result<double> ParseTimeQuery(const QueryWords& query);
Result<LinksQuery> ParseLinksQuery(const QueryWords& query);
Result<LinkQuery> ParseLinkQuery(const QueryWords& query);
Result<VehicleQuery> ParseVehicleQuery(const QueryWords& query);
/// `word`: how the query calls the name, which may be empty unless it `is_required`.
Result<ChannelQuery> ParseChannelQuery(const QueryWords& query, const char* word, bool is_required);
Result<BackgroundQuery> ParseBackgroundQuery(const QueryWords& query);
Result<TileQuery> ParseTileQuery(const QueryWords& query);
Result<TimedFateQuery> ParseFateQuery(const QueryWords& query);

/// Reads the body of POST /api/command.
Result<CommandWords> ParseCommandBody(std::string_view body);

}  // namespace shoal
