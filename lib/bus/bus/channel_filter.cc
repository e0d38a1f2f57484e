#include "lib/bus/bus/channel_filter.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>

#include "lib/bus/bus/lcm_assembler.h"

namespace shoal {

namespace {

constexpr uint32_t kUdpHeader = 8;  ///< Stands before the datagram, where a filter looks.
constexpr uint32_t kMagicAt = kUdpHeader;
constexpr uint32_t kNameAt = kUdpHeader + 8;
constexpr size_t kWord = 4;
constexpr uint32_t kAccept = 0xffffffff;
constexpr uint32_t kRefuse = 0;

class Program {
 public:
  /// @pre `patterns` are sorted, and none begins with another
  explicit Program(std::span<const std::string> patterns) {
    Add(BPF_LD | BPF_W | BPF_ABS, kMagicAt);
    Add(BPF_JMP | BPF_JEQ | BPF_K, kLcmFragmentMagic, 0, 1);
    Add(BPF_RET | BPF_K, kAccept);
    Add(BPF_JMP | BPF_JEQ | BPF_K, kLcmWholeMagic, 1, 0);
    Add(BPF_RET | BPF_K, kRefuse);
    AddNode(patterns, 0);
  }

  std::vector<sock_filter> Take() { return std::move(code_); }

 private:
  void Add(uint32_t code, uint32_t k, uint8_t if_true = 0, uint8_t if_false = 0) {
    code_.push_back({.code = static_cast<uint16_t>(code), .jt = if_true, .jf = if_false, .k = k});
  }

  static uint32_t WordAt(const std::string& pattern, size_t begin) {
    uint32_t word = 0;
    for (size_t i = begin; i < begin + kWord; ++i) {
      word = word << 8 | (i < pattern.size() ? static_cast<uint8_t>(pattern[i]) : 0U);
    }
    return word;
  }

  /// Compares the word at `begin` of the name with those of `patterns`, which agree before it.
  void AddNode(std::span<const std::string> patterns, size_t begin) {
    if (patterns.front().size() == begin) {
      Add(BPF_RET | BPF_K, kAccept);
      return;
    }
    struct Branch {
      size_t jump;  ///< Where the jump to the branch stands.
      std::span<const std::string> patterns;
    };
    std::vector<Branch> branches;
    const auto load = kNameAt + static_cast<uint32_t>(begin);
    Add(BPF_LD | BPF_W | BPF_ABS, load);
    for (size_t i = 0; i < patterns.size();) {
      if (patterns[i].size() < begin + kWord) {
        ++i;
        continue;
      }
      const uint32_t word = WordAt(patterns[i], begin);
      size_t end = i + 1;
      while (end < patterns.size() && patterns[end].size() >= begin + kWord &&
             WordAt(patterns[end], begin) == word) {
        ++end;
      }
      Add(BPF_JMP | BPF_JEQ | BPF_K, word, 0, 1);
      branches.push_back({.jump = code_.size(), .patterns = patterns.subspan(i, end - i)});
      Add(BPF_JMP | BPF_JA, 0);  // A conditional jump reaches 255 instructions only.
      i = end;
    }
    // Those that end within the word.
    for (const std::string& pattern : patterns) {
      if (pattern.size() >= begin + kWord) continue;
      const size_t rest = pattern.size() - begin;
      Add(BPF_LD | BPF_W | BPF_ABS, load);
      Add(BPF_ALU | BPF_AND | BPF_K, ~(0xffffffffU >> (8 * rest)));
      Add(BPF_JMP | BPF_JEQ | BPF_K, WordAt(pattern, begin), 0, 1);
      Add(BPF_RET | BPF_K, kAccept);
    }
    Add(BPF_RET | BPF_K, kRefuse);
    for (const Branch& branch : branches) {
      code_[branch.jump].k = static_cast<uint32_t>(code_.size() - branch.jump - 1);
      AddNode(branch.patterns, begin + kWord);
    }
  }

  std::vector<sock_filter> code_;
};

/// Cuts the patterns to `size` bytes, sorts them and leaves out those that begin with another.
std::vector<std::string> CutTo(size_t size, std::vector<std::string> patterns) {
  for (std::string& pattern : patterns) pattern = pattern.substr(0, size);
  std::sort(patterns.begin(), patterns.end());
  std::vector<std::string> kept;
  for (std::string& pattern : patterns) {
    if (kept.empty() || !pattern.starts_with(kept.back())) kept.push_back(std::move(pattern));
  }
  return kept;
}

}  // namespace

std::vector<sock_filter> ChannelFilter(const std::vector<std::string>& names,
                                       size_t max_instructions) {
  std::vector<std::string> patterns;  // With the 0 that ends a name.
  patterns.reserve(names.size());
  for (const std::string& name : names) patterns.push_back(name + '\0');
  if (patterns.empty()) return {};
  size_t longest = 0;
  for (const std::string& pattern : patterns) longest = std::max(longest, pattern.size());
  for (size_t size = (longest + kWord - 1) / kWord * kWord; size > 0; size -= kWord) {
    const std::vector<std::string> cut = CutTo(size, patterns);
    std::vector<sock_filter> code = Program(cut).Take();
    if (code.size() <= max_instructions) return code;
  }
  return {};
}

}  // namespace shoal
