// Writes a text file of a folder that may have come from elsewhere.
//
//   TextFile table("csv/links.csv", "time_s,link\n");
//   if (!table.Append([](std::string* text) { *text += "0.1,a\n"; }) || !table.Flush())
//   Fail(errno);
#pragma once

#include <cstddef>
#include <string>
#include <utility>

namespace shoal {

/// Gathers text and appends it to a file in large pieces. The file is made again with the first
/// piece, mode 0644 less the umask, and takes the place of what bears its name: a symbolic or hard
/// link there is replaced, and what it leads to stays as it is. Open only while it writes: a log
/// may have more channels than a process may have files.
class TextFile {
 public:
  /// `text` is what the file begins with.
  TextFile(std::string path, std::string text)
      : path_(std::move(path)), pending_(std::move(text)) {}

  /// Lets `write(std::string*)` append to the text. Returns false where the file cannot be written,
  /// as do all calls after that one; errno holds the reason.
  template <class Write>
  [[nodiscard]] bool Append(const Write& write) {
    constexpr size_t kPieceSize = 256 << 10;
    if (error_ == 0) write(&pending_);
    return (error_ == 0 && pending_.size() < kPieceSize) || Flush();
  }

  /// Makes the file, or appends to it, what it does not hold yet. Returns as Append() does.
  [[nodiscard]] bool Flush();

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::string pending_;
  bool is_made_ = false;
  int error_ = 0;  ///< The errno of the first failure.
};

}  // namespace shoal
