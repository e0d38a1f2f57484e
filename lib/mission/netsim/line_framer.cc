#include "lib/mission/netsim/line_framer.h"

namespace shoal {

namespace {

/// Memory that a client keeps between lines.
constexpr size_t kKeptLine_bytes = 4096;

std::string_view WithoutCr(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

void LineFramer::Keep(std::string_view piece) {
  if (is_too_long_) return;
  if (begun_.size() + piece.size() > max_line_bytes_) {
    is_too_long_ = true;
    ++num_too_long_;
    Forget();
    return;
  }
  begun_ += piece;
}

void LineFramer::Forget() {
  if (begun_.capacity() > kKeptLine_bytes) std::string().swap(begun_);
  begun_.clear();
}

void LineFramer::Push(std::string_view bytes,
                      const std::function<void(std::string_view)>& on_line) {
  for (size_t end = bytes.find('\n'); end != bytes.npos; end = bytes.find('\n')) {
    const std::string_view piece = bytes.substr(0, end);
    bytes.remove_prefix(end + 1);
    Keep(piece);
    if (!is_too_long_) on_line(WithoutCr(begun_));
    is_too_long_ = false;
    Forget();
  }
  Keep(bytes);
}

}  // namespace shoal
