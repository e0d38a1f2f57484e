// Every test has a label and a time limit, and what a person reads of the tests is true of them.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace shoal::every_test_test {

/// Returns what ctest knows of its tests, as it writes it.
nlohmann::json ShownTests() {
  const std::string command =
      "ctest --test-dir '" + std::string(SHOAL_BINARY_DIR) + "' --show-only=json-v1";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (pipe == nullptr) return {};
  std::string text;
  std::array<char, 65536> part{};
  for (size_t size = 0; (size = fread(part.data(), 1, part.size(), pipe.get())) > 0;) {
    text.append(part.data(), size);
  }
  return nlohmann::json::parse(text, nullptr, false);
}

TEST(EveryTest, HasALabelAndATimeLimit) {
  const std::set<std::string> labels = {"unit", "process", "browser", "slurm", "bench-smoke"};
  const nlohmann::json shown = ShownTests();
  ASSERT_TRUE(shown.is_object() && shown.contains("tests"));
  std::vector<std::string> without;
  for (const nlohmann::json& test : shown["tests"]) {
    bool has_label = false;
    bool has_limit = false;
    for (const nlohmann::json& property : test["properties"]) {
      if (property["name"] == "TIMEOUT") has_limit = property["value"].get<double>() > 0;
      if (property["name"] != "LABELS") continue;
      for (const nlohmann::json& label : property["value"]) has_label |= labels.contains(label);
    }
    if (!has_label || !has_limit) without.push_back(test["name"]);
  }
  EXPECT_GT(shown["tests"].size(), 1000U);
  EXPECT_EQ(without, std::vector<std::string>());
}

}  // namespace shoal::every_test_test
