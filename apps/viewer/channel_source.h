// What a mission's channels carry, for the panel of channels and for charts of any field
// (docs/extending/viewer_protocol.md). A field is named "NAV_ALPHA:x_m": channel, then the way to a
// value; of "HELM_DECISION_ALPHA:aims[].name" the values of all elements are one text.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/schema/text.h"
#include "lib/bus/record/message_types.h"

namespace shoal {

class ChannelSource {
 public:
  static constexpr size_t kMaxLeaves = 400;   ///< Of a message that is shown.
  static constexpr size_t kMaxFields = 100;   ///< Of a search.
  static constexpr size_t kMaxPoints = 1500;  ///< Of a series.
  static constexpr size_t kLongestText = 200;
  static constexpr size_t kMaxMessage_bytes = 256 << 10;  ///< Of one that is decoded.

  virtual ~ChannelSource() = default;

  // From any thread. `t_s` as in ViewSource.
  virtual std::string ChannelsJson(double t_s) = 0;
  /// The last message; the error names a channel that has none.
  virtual Result<std::string> MessageJson(const std::string& channel, double t_s) = 0;
  /// Fields whose names hold all words of `text`.
  virtual std::string FieldsJson(const std::string& text, double t_s) = 0;
  virtual Result<std::string> SeriesJson(const std::string& field, double t_s, double window_s) = 0;
};

struct ChannelFacts {
  std::string name;
  int64_t count = 0;
  double rate_hz = 0;
  double last_s = 0;  ///< Mission time of the last message.
};

/// A message of any channel, and when it came.
struct ShownMessage {
  std::string channel;
  double t_s = 0;
  std::vector<uint8_t> data;  ///< With its seal where it has one.
};

struct FieldName {
  std::string channel;
  std::string path;
};

/// Returns the two parts of "NAV_ALPHA:x_m"; the error states what is missing.
[[nodiscard]] Result<FieldName> ParseFieldName(std::string_view text);

/// Returns the name of a message's type, or what is known instead: its fingerprint.
[[nodiscard]] std::string TypeNameOf(std::span<const uint8_t> logged);

/// Returns all values of a message in wire order; none of one that cannot be decoded, or is longer
/// than kMaxMessage_bytes.
[[nodiscard]] std::vector<Leaf> LeavesOf(std::span<const uint8_t> logged);

/// Returns the value at `path`, as text; with "[]" in it the values of all such elements, each
/// once, joined.
[[nodiscard]] std::optional<std::string> ValueAt(const std::vector<Leaf>& leaves,
                                                 std::string_view path);

/// Returns why a message has no value at `path`; nothing where it has one, or where it cannot be
/// decoded.
[[nodiscard]] std::optional<Error> FindNoSuchField(const FieldName& name,
                                                   std::span<const uint8_t> message);

[[nodiscard]] std::string ChannelListJson(const std::vector<ChannelFacts>& channels,
                                          const std::vector<std::string>& types);
[[nodiscard]] std::string MessageJsonOf(const ShownMessage& message);

/// Gathers names of fields that hold all words of a text, without regard to case.
class FieldSearch {
 public:
  explicit FieldSearch(std::string_view text);

  /// Takes the fields of a channel by one of its messages. Returns false where enough were found.
  bool Take(const std::string& channel, std::span<const uint8_t> message);
  [[nodiscard]] std::string Json() const;

 private:
  std::vector<std::string> words_;
  std::vector<std::string> found_;
  bool is_more_ = false;
};

/// One value of a series; numbers, and booleans as 1 and 0, are drawn as lines, other texts as
/// spans of time.
struct SeriesPoint {
  double t_s = 0;
  std::string value;
};

[[nodiscard]] std::string SeriesJsonOf(std::string_view field,
                                       const std::vector<SeriesPoint>& points);

}  // namespace shoal
