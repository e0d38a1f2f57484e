#include "lib/tools/mcap/foxglove.h"

#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/tools/mcap/proto_schema.h"
#include "lib/tools/mcap/proto_wire.h"

namespace shoal {

namespace {

ProtoField DoubleField(std::string name, uint32_t number) {
  return {.name = std::move(name), .number = number, .type = ProtoType::kDouble};
}

ProtoField MessageField(std::string name, uint32_t number, std::string type) {
  return {.name = std::move(name),
          .number = number,
          .type = ProtoType::kMessage,
          .type_name = std::move(type)};
}

ProtoField StringField(std::string name, uint32_t number) {
  return {.name = std::move(name), .number = number, .type = ProtoType::kString};
}

constexpr char kTimestampFile[] = "google/protobuf/timestamp.proto";
constexpr char kTimestampType[] = ".google.protobuf.Timestamp";

ProtoFile TimestampFile() {
  return {.name = kTimestampFile,
          .package = "google.protobuf",
          .messages = {{.name = "Timestamp",
                        .fields = {{.name = "seconds", .number = 1, .type = ProtoType::kInt64},
                                   {.name = "nanos", .number = 2, .type = ProtoType::kInt32}}}}};
}

FoxgloveSchema MakeSchema(const std::string& name, std::vector<ProtoMessageType> messages) {
  const ProtoFile file{.name = "foxglove/" + name + ".proto",
                       .package = "foxglove",
                       .imports = {kTimestampFile},
                       .messages = std::move(messages)};
  return {.name = "foxglove." + name,
          .descriptor_set = EncodeFileDescriptorSet({TimestampFile(), file})};
}

void AppendTimestamp(uint32_t field, int64_t utime, std::string* out) {
  constexpr int64_t kMicroseconds = 1'000'000;
  const int64_t micros = (utime % kMicroseconds + kMicroseconds) % kMicroseconds;
  AppendProtoMessage(field, out, [&] {
    AppendProtoVarint(1, static_cast<uint64_t>((utime - micros) / kMicroseconds), out);
    AppendProtoVarint(2, static_cast<uint64_t>(micros * 1000), out);
  });
}

}  // namespace

FoxgloveSchema LocationFixSchema() {
  return MakeSchema(
      "LocationFix",
      {{.name = "LocationFix",
        .fields = {MessageField("timestamp", 6, kTimestampType),
                   StringField("frame_id", 7),
                   DoubleField("latitude", 1),
                   DoubleField("longitude", 2),
                   DoubleField("altitude", 3),
                   {.name = "position_covariance",
                    .number = 4,
                    .type = ProtoType::kDouble,
                    .is_repeated = true},
                   {.name = "position_covariance_type",
                    .number = 5,
                    .type = ProtoType::kEnum,
                    .type_name = ".foxglove.LocationFix.PositionCovarianceType"}},
        .enums = {{.name = "PositionCovarianceType",
                   .values = {"UNKNOWN", "APPROXIMATED", "DIAGONAL_KNOWN", "KNOWN"}}}}});
}

FoxgloveSchema PoseInFrameSchema() {
  const auto xyz = [] {
    return std::vector<ProtoField>{DoubleField("x", 1), DoubleField("y", 2), DoubleField("z", 3)};
  };
  std::vector<ProtoField> xyzw = xyz();
  xyzw.push_back(DoubleField("w", 4));
  return MakeSchema(
      "PoseInFrame",
      {{.name = "PoseInFrame",
        .fields = {MessageField("timestamp", 1, kTimestampType), StringField("frame_id", 2),
                   MessageField("pose", 3, ".foxglove.Pose")}},
       {.name = "Pose",
        .fields = {MessageField("position", 1, ".foxglove.Vector3"),
                   MessageField("orientation", 2, ".foxglove.Quaternion")}},
       {.name = "Vector3", .fields = xyz()},
       {.name = "Quaternion", .fields = std::move(xyzw)}});
}

FoxgloveSchema LogSchema() {
  return MakeSchema(
      "Log", {{.name = "Log",
               .fields = {MessageField("timestamp", 1, kTimestampType),
                          {.name = "level",
                           .number = 2,
                           .type = ProtoType::kEnum,
                           .type_name = ".foxglove.Log.Level"},
                          StringField("message", 3),
                          StringField("name", 4),
                          StringField("file", 5),
                          {.name = "line", .number = 6, .type = ProtoType::kFixed32}},
               .enums = {{.name = "Level",
                          .values = {"UNKNOWN", "DEBUG", "INFO", "WARNING", "ERROR", "FATAL"}}}}});
}

void AppendLocationFix(const nav_t& nav, std::string_view vehicle, std::string* out) {
  AppendProtoDouble(1, nav.lat_deg, out);
  AppendProtoDouble(2, nav.lon_deg, out);
  AppendProtoDouble(3, 0 - nav.z_m, out);  // at the surface 0, not -0
  AppendTimestamp(6, nav.utime, out);
  AppendProtoText(7, vehicle, out);
}

void AppendPoseInFrame(const nav_t& nav, std::string* out) {
  constexpr double kHalfRadians = std::numbers::pi / 360;  // of a degree's half
  const double roll = nav.roll_deg * kHalfRadians;
  const double pitch = -nav.pitch_deg * kHalfRadians;
  const double yaw = (90 - nav.heading_deg) * kHalfRadians;
  const auto [sr, cr] = SinCos(roll);
  const auto [sp, cp] = SinCos(pitch);
  const auto [sy, cy] = SinCos(yaw);
  const double x = sr * cp * cy - cr * sp * sy;
  const double y = cr * sp * cy + sr * cp * sy;
  const double z = cr * cp * sy - sr * sp * cy;
  const double w = cr * cp * cy + sr * sp * sy;
  AppendTimestamp(1, nav.utime, out);
  AppendProtoText(2, kMissionFrame, out);
  AppendProtoMessage(3, out, [&] {
    AppendProtoMessage(1, out, [&] {
      AppendProtoDouble(1, nav.x_m, out);
      AppendProtoDouble(2, nav.y_m, out);
      AppendProtoDouble(3, 0 - nav.z_m, out);
    });
    AppendProtoMessage(2, out, [&] {
      AppendProtoDouble(1, x, out);
      AppendProtoDouble(2, y, out);
      AppendProtoDouble(3, z, out);
      AppendProtoDouble(4, w, out);
    });
  });
}

void AppendLog(int64_t utime, LogLevel level, std::string_view name, std::string_view text,
               std::string* out) {
  AppendTimestamp(1, utime, out);
  AppendProtoVarint(2, static_cast<uint64_t>(level), out);
  AppendProtoText(3, text, out);
  AppendProtoText(4, name, out);
}

}  // namespace shoal
