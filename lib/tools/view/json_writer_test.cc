#include "lib/tools/view/json_writer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace shoal::json_writer_test {

std::string Written(double value, int decimals) {
  JsonWriter json;
  json.Number(value, decimals);
  return json.Take();
}

TEST(JsonWriter, WritesNestedValues) {
  JsonWriter json;
  json.BeginObject()
      .Key("a")
      .BeginArray()
      .Integer(1)
      .BeginObject()
      .EndObject()
      .Null()
      .EndArray()
      .Boolean("b", true)
      .KeyText("c \"d\"")
      .BeginArray()
      .EndArray()
      .Key("e")
      .Raw("[2]")
      .EndObject();
  EXPECT_EQ(json.Take(), R"({"a":[1,{},null],"b":true,"c \"d\"":[],"e":[2]})");
  EXPECT_EQ(json.Take(), "") << "it started again";
}

TEST(JsonWriter, RoundsAndWritesNoMoreDigitsThanNeeded) {
  EXPECT_EQ(Written(1.005, 1), "1");
  EXPECT_EQ(Written(-3.456, 2), "-3.46");
  EXPECT_EQ(Written(0.05, 2), "0.05");
  EXPECT_EQ(Written(-0.004, 2), "0") << "no minus zero";
  EXPECT_EQ(Written(120, 3), "120");
  EXPECT_EQ(Written(1e12, 6), "1000000000000");
  EXPECT_EQ(Written(43.825300, 6), "43.8253");
}

TEST(JsonWriter, WritesNullForNumbersThatAreNotFinite) {
  EXPECT_EQ(Written(std::numeric_limits<double>::quiet_NaN(), 2), "null");
  EXPECT_EQ(Written(std::numeric_limits<double>::infinity(), 2), "null");
  EXPECT_EQ(Written(-std::numeric_limits<double>::infinity(), 2), "null");
  EXPECT_EQ(Written(1.1e12, 2), "null");
  EXPECT_EQ(Written(-1e300, 0), "null");
}

RC_GTEST_PROP(JsonWriter, WritesNumbersThatReadBackRounded, ()) {
  const double value = static_cast<double>(*rc::gen::arbitrary<int64_t>()) / 1e10;
  const int decimals = *rc::gen::inRange(0, 7);
  const double read = nlohmann::json::parse(Written(value, decimals)).get<double>();
  RC_ASSERT(std::abs(read - value) <= 0.5 * std::pow(10, -decimals) + 1e-6);
}

RC_GTEST_PROP(JsonWriter, WritesAnyBytesAsText, ()) {
  const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
  JsonWriter json;
  json.BeginArray().Text(bytes).EndArray();
  const auto read = nlohmann::json::parse(json.Take());
  RC_ASSERT(read.size() == 1U);
  std::string ascii = bytes;
  if (std::all_of(ascii.begin(), ascii.end(), [](char c) { return c >= 0; })) {
    RC_ASSERT(read[0].get<std::string>() == bytes);
  }
}

}  // namespace shoal::json_writer_test
