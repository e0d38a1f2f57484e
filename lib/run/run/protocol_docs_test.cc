// docs/extending/step_protocol.md against the constants of the code.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "lib/run/run/step_inbox.h"

namespace shoal::protocol_docs_test {

TEST(StepProtocolPage, StatesHowManyMessagesFromOutsideAStepTakes) {
  std::ifstream file(std::string(SHOAL_SOURCE_DIR) + "/docs/extending/step_protocol.md");
  const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  constexpr size_t kThousand = 1000;
  const std::string limit =
      fmt::format("at most {},{:03} of these per step ({} MiB)", StepInbox::kMaxOutside / kThousand,
                  StepInbox::kMaxOutside % kThousand, StepInbox::kMaxOutsideBytes >> 20);
  EXPECT_NE(page.find(limit), std::string::npos) << limit;
}

}  // namespace shoal::protocol_docs_test
