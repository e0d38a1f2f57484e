#include "lib/tools/mcap/proto_message.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <sstream>

#include "lib/base/schema/text.h"
#include "lib/bus/record/log_testing.h"
#include "lib/bus/record/message_types.h"
#include "lib/tools/mcap/foxglove.h"
#include "lib/tools/mcap/proto_schema.h"
#include "shoal_test/deep/shapes_t.hpp"
#include "shoal_test/deep/tree_t.hpp"

namespace shoal::proto_message_test {

namespace pb = google::protobuf;
using shoal_test::deep::shapes_t;
using shoal_test::deep::tree_t;

/// Google's own reader of messages by a FileDescriptorSet.
class ProtoReader {
 public:
  explicit ProtoReader(const std::string& descriptor_set) {
    pb::FileDescriptorSet files;
    EXPECT_TRUE(files.ParseFromString(descriptor_set));
    for (const pb::FileDescriptorProto& file : files.file()) {
      EXPECT_NE(pool_.BuildFile(file), nullptr) << file.DebugString();
    }
  }

  bool Knows(const std::string& type) const { return pool_.FindMessageTypeByName(type) != nullptr; }

  std::unique_ptr<pb::Message> Read(const std::string& type, const std::string& bytes) {
    const pb::Descriptor* descriptor = pool_.FindMessageTypeByName(type);
    EXPECT_NE(descriptor, nullptr) << type;
    if (descriptor == nullptr) return nullptr;
    std::unique_ptr<pb::Message> message(factory_.GetPrototype(descriptor)->New());
    EXPECT_TRUE(message->ParseFromString(bytes)) << type;
    EXPECT_TRUE(message->GetReflection()->GetUnknownFields(*message).empty()) << type;
    return message;
  }

 private:
  pb::DescriptorPool pool_;
  pb::DynamicMessageFactory factory_;
};

void AppendValues(const pb::Message& message, std::vector<std::string>* values);

/// Appends one value, or one of a list where `index` is not negative.
void AppendValue(const pb::Message& message, const pb::FieldDescriptor* field, int index,
                 std::vector<std::string>* values) {
  const pb::Reflection& reflection = *message.GetReflection();
  const auto pick = [&](auto repeated, auto single) { return index < 0 ? single() : repeated(); };
  const auto add = [&](const Scalar& value) { AppendScalar(value, &values->emplace_back()); };
  switch (field->cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return add(pick([&] { return reflection.GetRepeatedDouble(message, field, index); },
                      [&] { return reflection.GetDouble(message, field); }));
    case pb::FieldDescriptor::CPPTYPE_FLOAT:
      return add(pick([&] { return reflection.GetRepeatedFloat(message, field, index); },
                      [&] { return reflection.GetFloat(message, field); }));
    case pb::FieldDescriptor::CPPTYPE_BOOL:
      return add(pick([&] { return reflection.GetRepeatedBool(message, field, index); },
                      [&] { return reflection.GetBool(message, field); }));
    case pb::FieldDescriptor::CPPTYPE_INT32:
      return add(int64_t{pick([&] { return reflection.GetRepeatedInt32(message, field, index); },
                              [&] { return reflection.GetInt32(message, field); })});
    case pb::FieldDescriptor::CPPTYPE_UINT32:
      return add(int64_t{reflection.GetUInt32(message, field)});
    case pb::FieldDescriptor::CPPTYPE_INT64:
      return add(int64_t{pick([&] { return reflection.GetRepeatedInt64(message, field, index); },
                              [&] { return reflection.GetInt64(message, field); })});
    case pb::FieldDescriptor::CPPTYPE_STRING: {
      const std::string text =
          pick([&] { return reflection.GetRepeatedString(message, field, index); },
               [&] { return reflection.GetString(message, field); });
      if (field->type() == pb::FieldDescriptor::TYPE_STRING) {
        AppendQuoted(text, &values->emplace_back());
        return;
      }
      for (const char byte : text) add(int64_t{static_cast<uint8_t>(byte)});
      return;
    }
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      return AppendValues(index < 0 ? reflection.GetMessage(message, field)
                                    : reflection.GetRepeatedMessage(message, field, index),
                          values);
    default:
      FAIL() << field->full_name() << " has a type that no LCM member becomes";
  }
}

void AppendValues(const pb::Message& message, std::vector<std::string>* values) {
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const pb::FieldDescriptor* field = message.GetDescriptor()->field(i);
    if (!field->is_repeated()) {
      AppendValue(message, field, -1, values);
      continue;
    }
    const int size = message.GetReflection()->FieldSize(message, field);
    for (int k = 0; k < size; ++k) AppendValue(message, field, k, values);
  }
}

/// Returns what Google's reader finds in the message, encoded again.
std::vector<std::string> ValuesByProto(const Schema& schema, const StructType& type,
                                       const Bytes& lcm) {
  const auto files = ProtoFilesOf(schema, type);
  EXPECT_TRUE(files.ok());
  std::string bytes;
  ProtoEncoder(schema).Append(type, lcm, &bytes);
  ProtoReader reader(EncodeFileDescriptorSet(*files));
  const auto message = reader.Read(type.FullName(), bytes);
  std::vector<std::string> values;
  if (message) AppendValues(*message, &values);
  return values;
}

std::vector<std::string> ValuesByLcm(const Schema& schema, const StructType& type,
                                     const Bytes& lcm) {
  std::vector<std::string> values;
  for (const Leaf& leaf : Leaves(schema, type, lcm)) values.push_back(leaf.text);
  return values;
}

Schema TestSchema() {
  std::ostringstream text;
  text << std::ifstream(SHOAL_SOURCE_DIR "/lib/base/schema/schema_test_types.lcm").rdbuf();
  auto built = Schema::Build({{"types", text.str()}});
  EXPECT_TRUE(built.ok()) << built.error();
  return std::move(*built);
}

rc::Gen<double> AnyDouble() {
  return rc::gen::oneOf(rc::gen::arbitrary<double>(), rc::gen::element(0.0, -0.0, 1e300));
}

std::string AnyText() { return *rc::gen::container<std::string>(rc::gen::inRange<char>(' ', '~')); }

shapes_t AnyShapes() {
  shapes_t shapes{};
  shapes.small = *rc::gen::inRange<int8_t>(0, 5);
  shapes.medium = *rc::gen::arbitrary<int16_t>();
  shapes.large = *rc::gen::arbitrary<int32_t>();
  shapes.huge = *rc::gen::arbitrary<int64_t>();
  shapes.octet = *rc::gen::arbitrary<uint8_t>();
  shapes.single_precision = *rc::gen::arbitrary<float>();
  shapes.real = *AnyDouble();
  shapes.flag = *rc::gen::inRange<int8_t>(0, 2);
  shapes.text = AnyText();
  shapes.rows = *rc::gen::inRange(0, 4);
  shapes.columns = *rc::gen::inRange(0, 200);
  for (int row = 0; row < shapes.rows; ++row) {
    shapes.matrix.push_back(
        *rc::gen::container<std::vector<double>>(static_cast<size_t>(shapes.columns), AnyDouble()));
    shapes.words.push_back(AnyText());
    shapes.track.push_back({.x_m = *AnyDouble(), .y_m = *AnyDouble()});
  }
  shapes.fixed[1][2] = *rc::gen::arbitrary<float>();
  for (int i = 0; i < shapes.small; ++i) shapes.flags.push_back(*rc::gen::inRange<int8_t>(0, 2));
  shapes.raw = *rc::gen::container<std::vector<uint8_t>>(static_cast<size_t>(shapes.columns),
                                                         rc::gen::arbitrary<uint8_t>());
  shapes.corners[1].y_m = *AnyDouble();
  return shapes;
}

RC_GTEST_PROP(ProtoEncoder, KeepsEveryValueThatLcmEncoded, ()) {
  const Schema schema = TestSchema();
  const StructType& type = *schema.FindByFingerprint(shapes_t::getHash());
  const Bytes lcm = Encoded(AnyShapes());
  RC_ASSERT(ValuesByProto(schema, type, lcm) == ValuesByLcm(schema, type, lcm));
}

TEST(ProtoEncoder, KeepsStructsThatHoldThemselves) {
  const Schema schema = TestSchema();
  tree_t tree{};
  for (int depth = 0; depth < 40; ++depth) {
    tree_t parent{};
    parent.name = "level " + std::to_string(depth);
    parent.num_children = 2;
    parent.children = {tree, tree_t{}};
    tree = parent;
  }
  const Bytes lcm = Encoded(tree);
  const StructType& type = *schema.FindByFingerprint(tree_t::getHash());
  EXPECT_EQ(ValuesByProto(schema, type, lcm), ValuesByLcm(schema, type, lcm));
}

TEST(ProtoEncoder, ReplacesBytesThatAreNoUtf8) {
  const Schema schema = TestSchema();
  shapes_t shapes{};
  shapes.text = "caf\xc3\xa9 \xff";
  const StructType& type = *schema.FindByFingerprint(shapes_t::getHash());
  const auto values = ValuesByProto(schema, type, Encoded(shapes));
  EXPECT_EQ(values.at(8), "\"caf\xc3\xa9 \xef\xbf\xbd\"");
}

TEST(ProtoFiles, OfEveryTypeOfShoalAreTakenByGooglesReader) {
  const auto schema = LoadMessageTypes({});
  ASSERT_TRUE(schema.ok());
  for (const StructType& type : schema->types()) {
    const auto files = ProtoFilesOf(*schema, type);
    ASSERT_TRUE(files.ok()) << files.error();
    EXPECT_TRUE(ProtoReader(EncodeFileDescriptorSet(*files)).Knows(type.FullName()))
        << type.FullName();
  }
}

TEST(ProtoFiles, ImportThePackagesThatATypeNeeds) {
  const auto schema = Schema::Build({{"a", "package a.b; struct x_t { c.y_t y; z_t z; }"},
                                     {"c", "package c; struct y_t { z_t z; }"},
                                     {"z", "package a.b; struct z_t { double value; }"},
                                     {"z2", "package c; struct z_t { double value; }"}});
  ASSERT_TRUE(schema.ok()) << schema.error();
  const auto files = ProtoFilesOf(*schema, *schema->FindByName("a.b.x_t"));
  ASSERT_TRUE(files.ok()) << files.error();
  ASSERT_EQ(files->size(), 2u);
  EXPECT_EQ(files->at(0).name, "c.proto");
  EXPECT_EQ(files->at(1).name, "a/b.proto");
  EXPECT_EQ(files->at(1).imports, std::vector<std::string>{"c.proto"});
  EXPECT_TRUE(ProtoReader(EncodeFileDescriptorSet(*files)).Knows("a.b.x_t"));
}

TEST(ProtoFiles, OfPackagesThatHoldEachOtherAreRefused) {
  const auto schema = Schema::Build({{"a", "package a; struct x_t { b.y_t y; }"},
                                     {"b", "package b; struct y_t { a.w_t w; }"},
                                     {"w", "package a; struct w_t { double value; }"}});
  ASSERT_TRUE(schema.ok()) << schema.error();
  const auto files = ProtoFilesOf(*schema, *schema->FindByName("a.x_t"));
  ASSERT_FALSE(files.ok());
  EXPECT_NE(files.error().find("hold each other"), std::string::npos) << files.error();
}

TEST(ProtoFiles, NumberNoMemberAsProtobufNumbersItsOwn) {
  EXPECT_EQ(ProtoFieldNumber(0), 1u);
  EXPECT_EQ(ProtoFieldNumber(18'998), 18'999u);
  EXPECT_EQ(ProtoFieldNumber(18'999), 20'000u);
}

/// Returns the message as protobuf's text, in one line.
std::string TextOf(const FoxgloveSchema& schema, const std::string& bytes) {
  ProtoReader reader(schema.descriptor_set);
  const auto message = reader.Read(schema.name, bytes);
  return message ? message->ShortDebugString() : "";
}

TEST(Foxglove, HasTheFixOfAVehicleUnderWaterBelowTheSea) {
  nav_t nav{};
  nav.utime = 12'300'001;
  nav.lat_deg = 43.5;
  nav.lon_deg = -70.25;
  nav.z_m = 7;
  std::string bytes;
  AppendLocationFix(nav, "ALPHA", &bytes);
  EXPECT_EQ(TextOf(LocationFixSchema(), bytes),
            "latitude: 43.5 longitude: -70.25 altitude: -7 timestamp { seconds: 12 nanos: "
            "300001000 } frame_id: \"ALPHA\"");
}

TEST(Foxglove, HasAPoseThatLooksWhereTheVehicleHeads) {
  nav_t nav{};
  nav.x_m = 3;
  nav.y_m = 4;
  nav.z_m = 5;
  nav.roll_deg = 10;
  nav.pitch_deg = 20;
  nav.heading_deg = 30;
  std::string bytes;
  AppendPoseInFrame(nav, &bytes);
  const FoxgloveSchema schema = PoseInFrameSchema();
  std::vector<std::string> values;
  AppendValues(*ProtoReader(schema.descriptor_set).Read(schema.name, bytes), &values);
  ASSERT_EQ(values.size(), 10u);  // seconds, nanos, frame; x, y, z; x, y, z, w
  EXPECT_EQ(values[2], "mission");
  EXPECT_EQ(std::vector(values.begin() + 3, values.begin() + 6),
            (std::vector<std::string>{"3", "4", "-5"}));
  const Eigen::Quaterniond turn(std::stod(values[9]), std::stod(values[6]), std::stod(values[7]),
                                std::stod(values[8]));
  const double degree = std::numbers::pi / 180;
  const double level = std::cos(20 * degree);
  const Eigen::Vector3d bow(level * std::sin(30 * degree), level * std::cos(30 * degree),
                            std::sin(20 * degree));
  EXPECT_LT((turn * Eigen::Vector3d::UnitX() - bow).norm(), 1e-12);
  // Rolled to starboard, port is up: by cos(pitch) sin(roll).
  EXPECT_NEAR((turn * Eigen::Vector3d::UnitY()).z(), level * std::sin(10 * degree), 1e-12);
}

TEST(Foxglove, HasALineOfText) {
  std::string bytes;
  AppendLog(1'000'000, LogLevel::kWarning, "alpha", "all-stop: out of area", &bytes);
  EXPECT_EQ(TextOf(LogSchema(), bytes),
            "timestamp { seconds: 1 } level: WARNING message: \"all-stop: out of area\" name: "
            "\"alpha\"");
}

}  // namespace shoal::proto_message_test
