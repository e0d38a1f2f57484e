#include "apps/shore_broker/repeat_memory.h"

#include <gtest/gtest.h>

#include <string>

namespace shoal::repeat_memory_test {

TEST(RepeatMemory, RecognizesARepeatBySourceAndAckId) {
  RepeatMemory memory;
  EXPECT_FALSE(memory.IsRepeat("alpha", "1"));
  EXPECT_FALSE(memory.IsRepeat("alpha", "2"));
  EXPECT_FALSE(memory.IsRepeat("bravo", "1"));
  EXPECT_TRUE(memory.IsRepeat("alpha", "1"));
}

TEST(RepeatMemory, ForgetsTheOldestOnceItIsFull) {
  RepeatMemory memory;
  for (size_t i = 0; i < RepeatMemory::kRemembered; ++i)
    memory.IsRepeat("alpha", std::to_string(i));
  EXPECT_TRUE(memory.IsRepeat("alpha", "0"));
  memory.IsRepeat("alpha", "one more");
  EXPECT_TRUE(memory.IsRepeat("alpha", "1"));
  EXPECT_FALSE(memory.IsRepeat("alpha", "0"));
}

}  // namespace shoal::repeat_memory_test
