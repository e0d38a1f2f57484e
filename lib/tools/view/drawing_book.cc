#include "lib/tools/view/drawing_book.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/bus/bus/channels.h"
#include "lib/tools/view/wire_reader.h"

namespace shoal {

namespace {

constexpr double kFarthest_m = 1e7;
constexpr double kLargest_px = 100;
constexpr double kLongestLife_s = 1e9;

struct DrawingRow {
  DrawingKind kind;
  std::string_view topic;
  std::string_view text;
  int64_t fingerprint;
};

const std::array<DrawingRow, 5>& DrawingTable() {
  static const std::array<DrawingRow, 5> table = {{
      {DrawingKind::kPoint, topics::kViewPoint, "point", view_point_t::getHash()},
      {DrawingKind::kPolygon, topics::kViewPolygon, "polygon", view_polygon_t::getHash()},
      {DrawingKind::kSeglist, topics::kViewSeglist, "seglist", view_seglist_t::getHash()},
      {DrawingKind::kCircle, topics::kViewCircle, "circle", view_circle_t::getHash()},
      {DrawingKind::kText, topics::kViewText, "text", view_text_t::getHash()},
  }};
  return table;
}

/// Returns a number within bounds; 0 for one that is not finite.
double Bounded(double value, double low, double high) {
  return std::isfinite(value) ? std::clamp(value, low, high) : 0;
}

bool IsPlace(double x_m, double y_m) {
  return std::abs(x_m) <= kFarthest_m && std::abs(y_m) <= kFarthest_m;
}

void AddPlace(double x_m, double y_m, MapDrawing* drawing) {
  if (IsPlace(x_m, y_m)) drawing->points_m.emplace_back(x_m, y_m);
}

void ReadPlace(WireReader* wire, MapDrawing* drawing) {
  const double x_m = wire->Double();
  const double y_m = wire->Double();
  AddPlace(x_m, y_m, drawing);
}

/// Reads x of all points, then y of all.
void ReadPlaces(WireReader* wire, MapDrawing* drawing) {
  const size_t count = wire->Count(2 * sizeof(double));
  const size_t step = count / DrawingBook::kMaxPoints + 1;
  std::vector<double> x_m;
  for (size_t i = 0; i < count; ++i) {
    const double x = wire->Double();
    if (i % step == 0) x_m.push_back(x);
  }
  for (size_t i = 0; i < count; ++i) {
    const double y = wire->Double();
    if (i % step == 0) AddPlace(x_m[i / step], y, drawing);
  }
}

std::string CutText(std::string_view text) {
  return std::string(text.substr(0, DrawingBook::kMaxText));
}

}  // namespace

std::string_view TextOf(DrawingKind kind) { return DrawingTable()[static_cast<size_t>(kind)].text; }

std::optional<MapDrawing> ReadDrawing(std::string_view channel, std::span<const uint8_t> data) {
  const auto& table = DrawingTable();
  const auto row = std::ranges::find(table, channel, &DrawingRow::topic);
  if (row == table.end()) return std::nullopt;
  WireReader wire(data);
  if (wire.Int64() != row->fingerprint) return std::nullopt;
  wire.Int64();  // utime: drawings last from when they come.
  MapDrawing drawing;
  drawing.kind = row->kind;
  drawing.owner = CutText(wire.Text());
  drawing.label = CutText(wire.Text());
  drawing.color = CutText(wire.Text());
  drawing.life_s = Bounded(wire.Double(), -1, kLongestLife_s);
  switch (row->kind) {
    case DrawingKind::kPoint:
      ReadPlace(&wire, &drawing);
      drawing.size_px = Bounded(wire.Double(), 0, kLargest_px);
      break;
    case DrawingKind::kPolygon:
      drawing.fill = Bounded(wire.Double(), 0, 1);
      ReadPlaces(&wire, &drawing);
      break;
    case DrawingKind::kSeglist:
      drawing.size_px = Bounded(wire.Double(), 0, kLargest_px);
      ReadPlaces(&wire, &drawing);
      break;
    case DrawingKind::kCircle:
      drawing.fill = Bounded(wire.Double(), 0, 1);
      ReadPlace(&wire, &drawing);
      drawing.radius_m = Bounded(wire.Double(), 0, kFarthest_m);
      break;
    case DrawingKind::kText:
      ReadPlace(&wire, &drawing);
      drawing.text = CutText(wire.Text());
      break;
  }
  if (!wire.ok() || !wire.at_end()) return std::nullopt;
  if (drawing.points_m.empty() && drawing.life_s >= 0) return std::nullopt;
  return drawing;
}

const std::vector<std::string_view>& DrawingBook::Topics() {
  static const std::vector<std::string_view> topics = [] {
    std::vector<std::string_view> names;
    for (const DrawingRow& row : DrawingTable()) names.push_back(row.topic);
    return names;
  }();
  return topics;
}

bool DrawingBook::Take(std::string_view channel, std::span<const uint8_t> data, int64_t now_utime) {
  std::optional<MapDrawing> drawing = ReadDrawing(channel, data);
  if (!drawing) return false;
  Key key{drawing->kind, drawing->owner, drawing->label};
  if (drawing->life_s < 0) {
    drawings_.erase(key);
    return true;
  }
  drawing->utime = now_utime;
  drawings_.insert_or_assign(std::move(key), *std::move(drawing));
  if (drawings_.size() > kMaxDrawings) {
    drawings_.erase(std::ranges::min_element(drawings_, {},
                                             [](const auto& each) { return each.second.utime; }));
  }
  return true;
}

std::vector<const MapDrawing*> DrawingBook::At(int64_t utime) const {
  std::vector<const MapDrawing*> drawn;
  for (const auto& [key, drawing] : drawings_) {
    const double age_s = static_cast<double>(utime - drawing.utime) / 1e6;
    if (drawing.life_s == 0 || age_s <= drawing.life_s) drawn.push_back(&drawing);
  }
  return drawn;
}

}  // namespace shoal
