#include "lib/mission/netcdf/netcdf_wire.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "lib/mission/netcdf/cf_testing.h"

namespace shoal::netcdf_wire_test {

NetcdfHeader SmallHeader() {
  FakeNetcdf file;
  file.Axis("lat", {54, 55}, kNorthDegrees)
      .Axis("lon", {10}, kEastDegrees)
      .Variable("z", {"lat", "lon"}, {1, 2}, {}, {{"valid_range", {0, 9}}}, NetcdfType::kShort);
  return file.header;
}

std::string BytesOf(const NetcdfHeader& header) {
  NetcdfReplyWriter writer;
  AddHeader(header, &writer);
  return writer.bytes();
}

TEST(NetcdfWire, CarriesAHeader) {
  const std::string bytes = BytesOf(SmallHeader());
  NetcdfReply reply(bytes);
  const auto header = TakeHeader(&reply);
  ASSERT_TRUE(header && reply.IsWhole());
  EXPECT_EQ(header->dimensions[0].name, "lat");
  EXPECT_EQ(header->dimensions[0].length, 2U);
  const NetcdfVariable* z = header->Find("z");
  ASSERT_NE(z, nullptr);
  EXPECT_EQ(z->type, NetcdfType::kShort);
  EXPECT_EQ(z->dimensions, (std::vector<uint32_t>{0, 1}));
  EXPECT_EQ(z->NumbersOf("valid_range"), (std::vector<double>{0, 9}));
  EXPECT_EQ(header->Find("lat")->TextOf("units"), "degrees_north");
  EXPECT_EQ(header->NumValues(*z), 2U);
}

TEST(NetcdfWire, IsNoHeaderWhereAnythingIsMissing) {
  const std::string bytes = BytesOf(SmallHeader());
  for (size_t size = 0; size < bytes.size(); ++size) {
    NetcdfReply reply(std::string_view(bytes).substr(0, size));
    EXPECT_FALSE(TakeHeader(&reply).has_value() && reply.ok()) << size;
  }
}

TEST(NetcdfWire, TakesNoMemoryForLengthsThatAreNotThere) {
  NetcdfReplyWriter writer;
  writer.Add(uint64_t{1} << 61);
  NetcdfReply numbers(writer.bytes());
  EXPECT_TRUE(numbers.TakeNumbers().empty());
  EXPECT_FALSE(numbers.ok());
  NetcdfReplyWriter text;
  text.Add(uint32_t{0xFFFFFFFF});
  NetcdfReply reply(text.bytes());
  EXPECT_EQ(reply.TakeText(), "");
  EXPECT_FALSE(reply.ok());
}

RC_GTEST_PROP(NetcdfWire, SurvivesAnyDamage, ()) {
  std::string bytes = BytesOf(SmallHeader());
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<size_t>(*rc::gen::inRange(0, static_cast<int>(bytes.size())));
    bytes[at] = static_cast<char>(*rc::gen::arbitrary<uint8_t>());
  }
  NetcdfReply reply(bytes);
  const auto header = TakeHeader(&reply);
  if (!header) return;
  for (const NetcdfVariable& variable : header->variables) {
    for (const uint32_t dimension : variable.dimensions) {
      RC_ASSERT(dimension < header->dimensions.size());
    }
  }
}

}  // namespace shoal::netcdf_wire_test
