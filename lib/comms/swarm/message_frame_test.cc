#include "lib/comms/swarm/message_frame.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace shoal::message_frame_test {

const std::vector<uint8_t> kMessage = {'1', '2', '3', '4', '5', '6', '7'};

FrameCount CountOf(std::initializer_list<uint16_t> sequences) {
  FrameCount count;
  for (const uint16_t sequence : sequences) CountFrame(sequence, &count);
  return count;
}

TEST(MessageFrame, IsTheMessageItsNumberAndTheChecksumOfBoth) {
  // "123456789", whose CRC-32 is the one that its tables print: 0xCBF43926.
  const std::vector<uint8_t> frame = {'1', '2', '3',  '4',  '5',  '6', '7',
                                      '8', '9', 0x26, 0x39, 0xF4, 0xCB};
  EXPECT_EQ(EncodeFrame(kMessage, 0x3938), frame);
  const auto opened = OpenFrame(frame);
  ASSERT_TRUE(opened);
  EXPECT_EQ(std::vector<uint8_t>(opened->message.begin(), opened->message.end()), kMessage);
  EXPECT_EQ(opened->sequence, 0x3938);
}

TEST(MessageFrame, MayHoldNothing) {
  const auto opened = OpenFrame(EncodeFrame({}, 5));
  ASSERT_TRUE(opened);
  EXPECT_TRUE(opened->message.empty());
}

RC_GTEST_PROP(MessageFrame, FindsUpToThreeDamagedBits,
              (const std::vector<uint8_t>& message, uint16_t sequence)) {
  std::vector<uint8_t> frame = EncodeFrame(message, sequence);
  const auto bits = *rc::gen::unique<std::vector<size_t>>(
      *rc::gen::inRange<size_t>(1, 4), rc::gen::inRange<size_t>(0, 8 * frame.size()));
  for (const size_t bit : bits) frame[bit / 8] ^= static_cast<uint8_t>(1 << (bit % 8));
  RC_ASSERT(!OpenFrame(frame).has_value());
}

RC_GTEST_PROP(MessageFrame, IsNotFoundInAnyBytes, (const std::vector<uint8_t>& bytes)) {
  const auto opened = OpenFrame(bytes);
  if (!opened) return;
  RC_ASSERT(EncodeFrame(opened->message, opened->sequence) == bytes);
}

TEST(FrameCount, CountsFramesThatWereLeftOut) {
  EXPECT_EQ(CountOf({7, 8, 11, 12}).lost, 2);
  EXPECT_EQ(CountOf({7, 8, 11, 12}).received, 4);
}

TEST(FrameCount, DoesNotMissWhatWasSentBeforeTheFirst) { EXPECT_EQ(CountOf({500}).lost, 0); }

TEST(FrameCount, CountsOnAcrossTheEndOfTheNumbers) {
  EXPECT_EQ(CountOf({65534, 65535, 0, 2}).lost, 1);
  EXPECT_EQ(CountOf({65534, 65535, 0, 2}).restarted, 0);
}

TEST(FrameCount, DistinguishesARepeatedFrameFromALostOne) {
  EXPECT_EQ(CountOf({3, 3, 4}).repeated, 1);
  EXPECT_EQ(CountOf({3, 3, 4}).lost, 0);
}

TEST(FrameCount, TakesANumberThatGoesBackForASenderThatBeganAgain) {
  const FrameCount count = CountOf({40, 41, 0, 1, 3});
  EXPECT_EQ(count.restarted, 1);
  EXPECT_EQ(count.lost, 1);
  EXPECT_EQ(count.repeated, 0);
}

}  // namespace shoal::message_frame_test
