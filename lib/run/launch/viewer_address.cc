#include "lib/run/launch/viewer_address.h"

#include <fmt/format.h>

#include <fstream>
#include <string_view>

#include "lib/base/time/time_units.h"

namespace shoal {

namespace {

constexpr int64_t kAddressPatience_us = 10 * kSecond_us;
constexpr int64_t kLookInterval_us = 100'000;

/// Returns the first line that begins with `begin`, once it is there as a whole.
std::string LineOf(const std::string& log_path, std::string_view begin) {
  std::ifstream in(log_path);
  for (std::string line; std::getline(in, line) && !in.eof();) {
    if (line.starts_with(begin)) return line;
  }
  return {};
}

}  // namespace

void ViewerAddress::Await(const std::string& log_path, int64_t wall_us) {
  log_path_ = log_path;
  started_us_ = wall_us;
  next_look_us_ = 0;
}

void ViewerAddress::OnTime(int64_t wall_us, LaunchTerminal* terminal) {
  if (log_path_.empty() || wall_us < next_look_us_) return;
  next_look_us_ = wall_us + kLookInterval_us;
  const std::string address = LineOf(log_path_, "viewer: http");
  if (address.empty() && wall_us - started_us_ < kAddressPatience_us) return;
  if (address.empty()) {
    terminal->Warn(
        fmt::format("the viewer has not written its address yet; its output: {}", log_path_));
  } else {
    terminal->Show(address);
  }
  log_path_.clear();
}

bool ViewerAddress::HasPage(const std::string& log_path) {
  return !LineOf(log_path, "viewer: a page is open").empty();
}

}  // namespace shoal
