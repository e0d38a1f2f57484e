// What shoal-netcdf answers on its standard output, and what shoal reads there: both sides include
// this. The program may have read a file that was made to harm it, so nothing of the answer is
// believed: each length is checked against what is there before memory is taken.
//
//   "shoal-netcdf 2\n", then 'E' and a text: why there is no answer;
//                       or 'H', a header, names of coordinate variables, each with its numbers,
//                       and an empty name; or 'V' and numbers; then ".\n"
//
// Numbers have the byte order of the machine, on which both sides run.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/netcdf/netcdf_header.h"

namespace shoal {

inline constexpr std::string_view kNetcdfGreeting = "shoal-netcdf 2\n";
inline constexpr std::string_view kNetcdfEnd = ".\n";

inline constexpr size_t kMaxNetcdfText_bytes = 2000;  ///< Longer texts are cut off.
inline constexpr size_t kMaxNetcdfNumbers = 100;      ///< Of an attribute; more are left out.
inline constexpr size_t kMaxNetcdfNames = 4000;  ///< Of dimensions, variables, attributes each.
inline constexpr uint64_t kMaxNetcdfValues = 16'000'000;  ///< Of one variable.

/// Appends what NetcdfReply reads.
class NetcdfReplyWriter {
 public:
  template <class T>
  void Add(T number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  void AddText(std::string_view text) {
    text = text.substr(0, kMaxNetcdfText_bytes);
    Add(static_cast<uint32_t>(text.size()));
    bytes_ += text;
  }
  void AddNumbers(const double* numbers, size_t count) {
    Add(static_cast<uint64_t>(count));
    bytes_.append(reinterpret_cast<const char*>(numbers), count * sizeof(double));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes an answer apart. Where something is not there, it is empty or 0, and ok() false.
class NetcdfReply {
 public:
  explicit NetcdfReply(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  T Take() {
    T number{};
    const std::string_view bytes = TakeBytes(sizeof number);
    if (ok_) std::memcpy(&number, bytes.data(), sizeof number);
    return number;
  }
  std::string TakeText() { return std::string(TakeBytes(Take<uint32_t>())); }
  std::vector<double> TakeNumbers() {
    const auto count = Take<uint64_t>();
    if (count > rest_.size() / sizeof(double)) {
      ok_ = false;
      return {};
    }
    const std::string_view bytes = TakeBytes(count * sizeof(double));
    std::vector<double> numbers(count);
    if (count > 0) std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
  }
  bool TakeWord(std::string_view word) {
    if (TakeBytes(word.size()) != word) ok_ = false;
    return ok_;
  }
  /// Nothing was missing so far.
  bool ok() const { return ok_; }
  /// Nor is anything left.
  bool IsWhole() const { return ok_ && rest_.empty(); }

 private:
  std::string_view TakeBytes(size_t count) {
    ok_ = ok_ && count <= rest_.size();
    if (!ok_) return {};
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  std::string_view rest_;
  bool ok_ = true;
};

/// Returns whether a variable holds the coordinates of its one dimension, few enough for an answer
/// with the header.
[[nodiscard]] bool IsCoordinate(const NetcdfHeader& header, const NetcdfVariable& variable);

/// Appends a header.
void AddHeader(const NetcdfHeader& header, NetcdfReplyWriter* writer);

/// Returns the header, or nothing if it is not one: of another form, or with an index beyond its
/// dimensions.
[[nodiscard]] std::optional<NetcdfHeader> TakeHeader(NetcdfReply* reply);

}  // namespace shoal
