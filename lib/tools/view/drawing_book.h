// What users' programs draw on the map: VIEW_POINT, VIEW_POLYGON, VIEW_SEGLIST, VIEW_CIRCLE and
// VIEW_TEXT. A drawing replaces the one of the same kind, owner and label.
//
//   DrawingBook book;
//   book.Take("VIEW_CIRCLE", bytes, now_utime);
//   for (const MapDrawing* drawing : book.At(now_utime)) ...
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace shoal {

enum class DrawingKind : uint8_t { kPoint, kPolygon, kSeglist, kCircle, kText };

/// Returns "point", "polygon", ...
[[nodiscard]] std::string_view TextOf(DrawingKind kind);

struct MapDrawing {
  DrawingKind kind = DrawingKind::kPoint;
  std::string owner;
  std::string label;
  std::string color;
  std::string text;    ///< Of kText.
  int64_t utime = 0;   ///< Since when it has been drawn.
  double life_s = 0;   ///< 0: until it is replaced; negative: the drawing goes.
  double size_px = 0;  ///< Of a point, the width of a line; 0: as the viewer likes.
  double fill = 0;     ///< Opacity of the inside, 0 to 1.
  double radius_m = 0;
  std::vector<std::pair<double, double>> points_m = {};
};

/// Returns the drawing in an encoded message; nothing where `channel` or the bytes are of another
/// type, or no position is a number within 10,000 km. `utime` is left at 0.
[[nodiscard]] std::optional<MapDrawing> ReadDrawing(std::string_view channel,
                                                    std::span<const uint8_t> data);

class DrawingBook {
 public:
  static constexpr size_t kMaxDrawings = 500;  ///< The oldest goes where there are more.
  static constexpr size_t kMaxPoints = 2000;   ///< Of each; of more, every second or third, ...
  static constexpr size_t kMaxText = 100;      ///< Bytes of each text.

  /// The channels of drawings.
  static const std::vector<std::string_view>& Topics();

  /// Takes a message that came at `now_utime`. Returns false where ReadDrawing finds none.
  bool Take(std::string_view channel, std::span<const uint8_t> data, int64_t now_utime);

  /// Returns those that are drawn at `utime`, by kind, owner and label.
  std::vector<const MapDrawing*> At(int64_t utime) const;

 private:
  using Key = std::tuple<DrawingKind, std::string, std::string>;
  std::map<Key, MapDrawing> drawings_;
};

}  // namespace shoal
