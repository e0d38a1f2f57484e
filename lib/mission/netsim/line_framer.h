// Cuts a stream of bytes into lines, in whatever pieces it comes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace shoal {

/// Keeps the beginning of a line until its LF comes, and never more than a line may have.
class LineFramer {
 public:
  /// @pre max_line_bytes > 0
  explicit LineFramer(size_t max_line_bytes) : max_line_bytes_(max_line_bytes) {}

  /// Calls `on_line` for each line that `bytes` end, without its LF and without a CR before that.
  /// A line with more bytes than allowed (LF not counted) is skipped and counted.
  void Push(std::string_view bytes, const std::function<void(std::string_view)>& on_line);

  int64_t num_too_long() const { return num_too_long_; }
  /// Memory taken by a line that has not ended.
  size_t capacity() const { return begun_.capacity(); }

 private:
  void Keep(std::string_view piece);
  void Forget();

  size_t max_line_bytes_;
  std::string begun_;
  bool is_too_long_ = false;  ///< The line that has begun; none of it is kept.
  int64_t num_too_long_ = 0;
};

}  // namespace shoal
