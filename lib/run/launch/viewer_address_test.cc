#include "lib/run/launch/viewer_address.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace shoal::viewer_address_test {

constexpr int64_t kStart_us = 5'000'000;

class AwaitedViewer : public testing::Test {
 protected:
  AwaitedViewer() { address_.Await(path_, kStart_us); }
  ~AwaitedViewer() override { std::remove(path_.c_str()); }

  void Log(const std::string& text) const { std::ofstream(path_, std::ios::app) << text; }

  /// What the terminal shows at `seconds` after the viewer's start, output and then errors.
  std::string ShownAt(double seconds) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    address_.OnTime(kStart_us + static_cast<int64_t>(seconds * 1e6), &terminal_);
    const std::string output = testing::internal::GetCapturedStdout();
    return output + testing::internal::GetCapturedStderr();
  }

  const std::string path_ = testing::TempDir() + "viewer-address-" + std::to_string(getpid());
  LaunchTerminal terminal_;
  ViewerAddress address_;
};

TEST_F(AwaitedViewer, HasItsAddressShownOnceTheLineIsWhole) {
  EXPECT_EQ(ShownAt(0.1), "") << "there is no log yet";
  Log("starting\nviewer: http://127.0.0.1:87");
  EXPECT_EQ(ShownAt(0.3), "") << "the line may go on";
  Log("65/\n");
  EXPECT_EQ(ShownAt(0.5), "viewer: http://127.0.0.1:8765/\n");
  EXPECT_EQ(ShownAt(0.7), "") << "once is enough";
}

TEST_F(AwaitedViewer, IsWarnedAboutAfterTenSecondsWithoutAnAddress) {
  Log("still starting\n");
  EXPECT_EQ(ShownAt(9.9), "");
  EXPECT_EQ(ShownAt(10.1),
            "the viewer has not written its address yet; its output: " + path_ + "\n");
  EXPECT_EQ(ShownAt(10.3), "");
}

TEST_F(AwaitedViewer, HasAPageOnceItsLogHasTheLine) {
  Log("viewer: http://127.0.0.1:8765/\n");
  EXPECT_FALSE(ViewerAddress::HasPage(path_));
  Log("viewer: a page is open\n");
  EXPECT_TRUE(ViewerAddress::HasPage(path_));
  EXPECT_FALSE(ViewerAddress::HasPage(path_ + "-of-none"));
}

TEST_F(AwaitedViewer, IsNotAwaitedOnceTheViewerHasEnded) {
  Log("viewer: http://127.0.0.1:8765/\n");
  address_.Forget();
  EXPECT_EQ(ShownAt(1), "");
}

}  // namespace shoal::viewer_address_test
