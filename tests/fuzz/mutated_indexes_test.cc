// Indexes beside logs that were damaged: what reads them answers as it does without an index, with
// no crash and no more memory than a bound. The same mutations in every run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <functional>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/bus/record/index_file.h"
#include "lib/bus/record/log_commands.h"
#include "lib/bus/record/log_times.h"
#include "lib/tools/view/recorded_testing.h"
#include "tests/fuzz/mutation.h"

namespace shoal::mutated_indexes_test {

constexpr int kNumMutations = 5000;
constexpr size_t kMax_bytes = size_t{512} << 20;
/// Numbers without end, 0, and what an index and what zstd compresses begin with.
constexpr std::array<std::string_view, 6> kHarm = {
    std::string_view("\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 8),
    std::string_view("\xFF\xFF\xFF\x7F", 4),
    std::string_view("\0\0\0\0\0\0\0\0", 8),
    std::string_view("\0\0\0\x0F\0\0\0\0", 8),
    std::string_view("SHOALIDX", 8),
    std::string_view("\x28\xB5\x2F\xFD", 4)};

/// A log of two seconds, and what is made of it.
class IndexedLog {
 public:
  IndexedLog() { (void)OpenTraffic(directory_, TrafficMaker(5).Make(20)); }

  std::string Info() const {
    std::ostringstream out;
    std::ostringstream err;
    const int code = LogInfo({.path = path_, .least_indexed_bytes = 0}, out, err);
    return std::to_string(code) + out.str() + err.str();
  }

  std::string Times() const {
    const LogTimes times = TimesOf(Reader(), {}, 0);
    std::string text =
        fmt::format("{} events, {} to {} us, {} places from {}, {} strays, {} jumps",
                    times.num_events, times.zero_utime, times.end_us, times.places.size(),
                    times.places.front().offset, times.num_strays, times.num_jumps);
    for (const std::string& channel : times.channels) text += " " + channel;
    return text;
  }

  std::unique_ptr<RecordedView> View() const {
    auto view = RecordedView::Open(path_, {.least_indexed_bytes = 0});
    EXPECT_TRUE(view.ok()) << view.error();
    return std::move(*view);
  }

  /// All that the three readers of an index show. Those that find no part of their own in it add
  /// one.
  std::string Answers() const {
    const auto view = View();
    return Info() + Times() + view->SetupJson(false) + view->TrailsJson() + view->EventsJson() +
           view->FrameJson(1.3) + view->LinksJson(2) + view->FatesJson({}, 1.1);
  }

  std::string Index() const { return TextOfFile(index_path_); }
  void SetIndex(const std::string& text) const {
    WriteBytes(index_path_, Bytes(text.begin(), text.end()));
  }
  LogReader Reader() const { return std::move(*LogReader::Open(path_)); }

 private:
  const TestDirectory directory_;
  const std::string path_ = directory_.File("mission.lcm");
  const std::string index_path_ = IndexPath(path_);
};

TEST(MutatedIndexes, ChangeNoAnswer) {
  const IndexedLog log;
  const std::string read = log.Answers();
  const std::string index = log.Index();
  ASSERT_EQ(log.Answers(), read);
  EXPECT_TRUE(LastsWithin(kMax_bytes, [&] {
    std::mt19937_64 generator(29);
    int num_rewritten = 0;
    for (int i = 0; i < kNumMutations; ++i) {
      const std::string mutated = Mutated(index, kHarm, generator);
      log.SetIndex(mutated);
      if (log.Answers() != read) {
        std::fprintf(stderr, "mutation %d gives another answer\n", i);
        return false;
      }
      if (log.Index() != mutated) ++num_rewritten;
    }
    if (num_rewritten > kNumMutations / 2) return true;
    std::fprintf(stderr, "%d of %d rewritten\n", num_rewritten, kNumMutations);
    return false;
  })) << "a crash, more than 512 MB, or what is shown above";
}

/// Returns the key of the first part of an index (index_file.h).
std::string FirstKey(const std::string& index) {
  constexpr size_t kKeyLength_at = 40;
  return index.substr(kKeyLength_at + 4, static_cast<uint8_t>(index[kKeyLength_at]));
}

/// Where the digest fits, an answer may be wrong, and must still be one.
TEST(MutatedIndexes, ThatAreMadeToMisleadCrashNothing) {
  const IndexedLog log;
  struct Part {
    IndexPart number;
    std::string key = {};
    std::vector<uint8_t> bytes = {};
    std::function<bool()> is_answered;
  };
  std::vector<Part> parts;
  parts.push_back({.number = IndexPart::kInfo,
                   .is_answered = [&] { return log.Info().find("events") != std::string::npos; }});
  parts.push_back({.number = IndexPart::kTimes,
                   .is_answered = [&] { return log.Times().find("events") != std::string::npos; }});
  parts.push_back({.number = IndexPart::kView, .is_answered = [&] {
                     const auto view = log.View();
                     return nlohmann::json::accept(view->FrameJson(1.3)) &&
                            nlohmann::json::accept(view->TrailsJson()) &&
                            nlohmann::json::accept(view->EventsJson()) &&
                            nlohmann::json::accept(view->LinksJson(2)) &&
                            nlohmann::json::accept(view->FatesJson({}, 1.1));
                   }});
  for (Part& part : parts) {
    log.SetIndex("");
    ASSERT_TRUE(part.is_answered());
    part.key = FirstKey(log.Index());
    const auto bytes = ReadIndexPart(log.Reader(), part.number, part.key, 0);
    ASSERT_TRUE(bytes);
    part.bytes = *bytes;
  }
  EXPECT_TRUE(LastsWithin(kMax_bytes, [&] {
    std::mt19937_64 generator(31);
    for (int i = 0; i < kNumMutations; ++i) {
      const Part& part = parts[static_cast<size_t>(i) % parts.size()];
      const std::string mutated = Mutated({part.bytes.begin(), part.bytes.end()}, kHarm, generator);
      KeepIndexPart(log.Reader(), part.number, part.key,
                    std::vector<uint8_t>(mutated.begin(), mutated.end()), 0);
      if (!part.is_answered()) {
        std::fprintf(stderr, "mutation %d gives no answer\n", i);
        return false;
      }
    }
    return true;
  })) << "a crash, more than 512 MB, or what is shown above";
}

}  // namespace shoal::mutated_indexes_test
