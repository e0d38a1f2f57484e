#include "lib/comms/routing/sparse_row.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

namespace shoal::sparse_row_test {

TEST(SparseRow, ReadsAsTheRestWhereNothingWasSet) {
  SparseRow<int, -1> row;
  EXPECT_EQ(row.Get(0), -1);
  row.At(1000) = 5;
  EXPECT_EQ(row.Get(1000), 5);
  EXPECT_EQ(row.Get(999), -1);
  EXPECT_EQ(row.Get(5000), -1);
}

RC_GTEST_PROP(SparseRow, HoldsWhatAMapHolds, ()) {
  SparseRow<int, 7> row;
  std::map<size_t, int> expected;
  for (int i = 0; i < 50; ++i) {
    const auto index = *rc::gen::inRange<size_t>(0, 200);
    const auto action = *rc::gen::inRange(0, 20);
    if (action == 0) {
      row.Clear();
      expected.clear();
    } else if (action < 5) {
      row.Reset(index);
      expected.erase(index);
    } else {
      row.At(index) = i;
      expected[index] = i;
    }
  }
  for (size_t index = 0; index < 300; ++index) {
    RC_ASSERT(row.Get(index) == (expected.contains(index) ? expected[index] : 7));
  }
}

}  // namespace shoal::sparse_row_test
