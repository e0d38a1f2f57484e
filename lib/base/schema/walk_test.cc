#include "lib/base/schema/walk.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <sstream>

#include "lib/base/schema/text.h"
#include "shoal_test/deep/shapes_t.hpp"
#include "shoal_test/deep/tree_t.hpp"

namespace shoal::walk_test {

using shoal_test::deep::shapes_t;
using shoal_test::deep::tree_t;
using Bytes = std::vector<uint8_t>;

const Schema& TestSchema() {
  static const Schema schema = [] {
    std::ostringstream text;
    text << std::ifstream(SHOAL_SOURCE_DIR "/lib/base/schema/schema_test_types.lcm").rdbuf();
    auto built = Schema::Build({{"types", text.str()}});
    EXPECT_TRUE(built.ok()) << built.error();
    return std::move(*built);
  }();
  return schema;
}

template <class T>
const StructType& TypeOf() {
  return *TestSchema().FindByFingerprint(T::getHash());
}

template <class T>
Bytes Encoded(const T& message) {
  Bytes bytes(static_cast<size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

template <class T>
bool IsSane(std::span<const uint8_t> bytes) {
  return !FindWireFault(TestSchema(), TypeOf<T>(), bytes);
}

shapes_t Shapes(int rows, int columns) {
  shapes_t shapes{};
  shapes.small = 2;
  shapes.medium = -300;
  shapes.large = 70000;
  shapes.huge = -5'000'000'000;
  shapes.octet = 200;
  shapes.single_precision = 0.1F;
  shapes.real = 0.1;
  shapes.flag = 1;
  shapes.text = "two words";
  shapes.rows = rows;
  shapes.columns = columns;
  shapes.matrix.assign(static_cast<size_t>(rows),
                       std::vector<double>(static_cast<size_t>(columns), 1.5));
  shapes.words.assign(static_cast<size_t>(rows), "w");
  shapes.flags = {0, 1};
  shapes.raw.assign(static_cast<size_t>(columns), 7);
  shapes.track.resize(static_cast<size_t>(rows));
  return shapes;
}

tree_t Chain(int depth) {
  tree_t tree{};
  tree.name = "n";
  if (depth > 0) {
    tree.num_children = 1;
    tree.children = {Chain(depth - 1)};
  }
  return tree;
}

TEST(Walk, ReportsEveryValueThatLcmEncoded) {
  std::string text;
  for (const Leaf& leaf : Leaves(TestSchema(), TypeOf<shapes_t>(), Encoded(Shapes(2, 1)))) {
    text += leaf.path + "=" + leaf.text + "\n";
  }
  EXPECT_EQ(text, R"(small=2
medium=-300
large=70000
huge=-5000000000
octet=200
single_precision=0.1
real=0.1
flag=true
text="two words"
rows=2
columns=1
matrix[0][0]=1.5
matrix[1][0]=1.5
fixed[0][0]=0
fixed[0][1]=0
fixed[0][2]=0
fixed[1][0]=0
fixed[1][1]=0
fixed[1][2]=0
words[0]=w
words[1]=w
flags[0]=false
flags[1]=true
raw[0]=7
origin.x_m=0
origin.y_m=0
corners[0].x_m=0
corners[0].y_m=0
corners[1].x_m=0
corners[1].y_m=0
track[0].x_m=0
track[0].y_m=0
track[1].x_m=0
track[1].y_m=0
)");
}

TEST(Walk, RefusesAMessageThatIsCutAnywhereOrTooLong) {
  Bytes bytes = Encoded(Shapes(2, 3));
  ASSERT_TRUE(IsSane<shapes_t>(bytes));
  for (size_t size = 0; size < bytes.size(); ++size) {
    const auto cut = std::span(bytes).first(size);
    EXPECT_FALSE(IsSane<shapes_t>(cut)) << size;
    Visitor ignored;
    EXPECT_TRUE(Walk(TestSchema(), TypeOf<shapes_t>(), cut, &ignored)) << size;
  }
  bytes.push_back(0);
  EXPECT_FALSE(IsSane<shapes_t>(bytes));
}

TEST(Walk, RefusesTheFingerprintOfAnotherType) {
  EXPECT_FALSE(IsSane<shapes_t>(Encoded(Chain(0))));
}

// The members of tree_t: 4 bytes length and "n\0" of name, 4 bytes num_children.
constexpr size_t kNameLength = 8;
constexpr size_t kNumChildren = 14;

void Write32(uint32_t value, size_t offset, Bytes* bytes) {
  for (size_t i = 0; i < 4; ++i) (*bytes)[offset + i] = static_cast<uint8_t>(value >> (24 - 8 * i));
}

TEST(Walk, RefusesLengthsThatLie) {
  const Bytes good = Encoded(Chain(1));
  ASSERT_TRUE(IsSane<tree_t>(good));
  for (const uint32_t lie : {0U, 2U, 3U, 0x7fffffffU, 0xffffffffU, 0x80000000U}) {
    Bytes bad = good;
    Write32(lie, kNumChildren, &bad);
    EXPECT_FALSE(IsSane<tree_t>(bad)) << lie;
  }
  for (const uint32_t lie : {0U, 1U, 3U, 0x7fffffffU, 0xffffffffU, 0x80000000U}) {
    Bytes bad = good;
    Write32(lie, kNameLength, &bad);
    EXPECT_FALSE(IsSane<tree_t>(bad)) << lie;
  }
}

TEST(Walk, RefusesStringsThatLcmCouldNotEncodeAgain) {
  Bytes unterminated = Encoded(Chain(0));
  unterminated[kNumChildren - 1] = 'x';
  EXPECT_FALSE(IsSane<tree_t>(unterminated));

  Bytes nul_inside = Encoded(Chain(0));
  nul_inside[kNumChildren - 2] = 0;
  EXPECT_FALSE(IsSane<tree_t>(nul_inside));
}

TEST(Walk, RefusesRowsWithoutEndThatHaveNoColumns) {
  shapes_t shapes = Shapes(0, 0);
  ASSERT_TRUE(IsSane<shapes_t>(Encoded(shapes)));
  const auto schema = Schema::Build({{"a.lcm", "struct t { int32_t n, m; double x[n][m]; }"}});
  const StructType& type = *schema->FindByName("t");
  Bytes bytes(16);
  for (size_t i = 0; i < 8; ++i) {
    bytes[i] = static_cast<uint8_t>(static_cast<uint64_t>(type.fingerprint) >> (56 - 8 * i));
  }
  Write32(1000, 8, &bytes);
  EXPECT_FALSE(FindWireFault(*schema, type, bytes));
  Write32(0x7fffffff, 8, &bytes);
  EXPECT_TRUE(FindWireFault(*schema, type, bytes));
}

TEST(Walk, RefusesStructsInsideOneAnotherWithoutEnd) {
  // The innermost tree holds a point.
  EXPECT_TRUE(IsSane<tree_t>(Encoded(Chain(kMaxStructDepth - 1))));
  EXPECT_FALSE(IsSane<tree_t>(Encoded(Chain(kMaxStructDepth))));
}

RC_GTEST_PROP(Walk, PassesOnlyWhatLcmDecodesAndEncodesToTheSameBytes, ()) {
  const auto rows = *rc::gen::inRange(0, 4);
  const auto columns = *rc::gen::inRange(1, 4);
  Bytes bytes = Encoded(Shapes(rows, columns));
  const auto num_damages = *rc::gen::inRange(0, 3);
  for (int i = 0; i < num_damages; ++i) {
    const auto where = *rc::gen::inRange<size_t>(8, bytes.size());
    bytes[where] = *rc::gen::element<uint8_t>(0, 1, 2, 3, 5, 127, 128, 255);
  }
  const bool is_sane = IsSane<shapes_t>(bytes);
  Visitor ignored;
  RC_ASSERT(is_sane == !Walk(TestSchema(), TypeOf<shapes_t>(), bytes, &ignored));
  if (num_damages == 0) RC_ASSERT(is_sane);
  if (!is_sane) return;
  shapes_t decoded;
  RC_ASSERT(decoded.decode(bytes.data(), 0, static_cast<int>(bytes.size())) ==
            static_cast<int>(bytes.size()));
  RC_ASSERT(Encoded(decoded) == bytes);
}

RC_GTEST_PROP(Walk, EndsWhateverTheBytes, (Bytes bytes)) {
  const StructType& type = TypeOf<tree_t>();
  for (size_t i = 0; i < std::min<size_t>(8, bytes.size()); ++i) {
    bytes[i] = static_cast<uint8_t>(static_cast<uint64_t>(type.fingerprint) >> (56 - 8 * i));
  }
  Visitor ignored;
  RC_ASSERT(FindWireFault(TestSchema(), type, bytes).has_value() ==
            Walk(TestSchema(), type, bytes, &ignored).has_value());
}

}  // namespace shoal::walk_test
