#include "apps/viewer/status_board.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace shoal {

namespace {

constexpr int64_t kAskInterval_us = 1'000'000;
/// A page whose last request is older has closed the panel.
constexpr int64_t kLookLasts_us = 4'000'000;
/// A participant whose page is older, while the panel is open, no longer answers.
constexpr int64_t kSilence_us = 10'000'000;
constexpr size_t kMaxWarnings = 100;

void Cut(std::vector<std::string>* warnings) {
  if (warnings->size() > kMaxWarnings) warnings->resize(kMaxWarnings);
  constexpr size_t kLongestWarning = 1'000;
  for (std::string& each : *warnings) each.resize(std::min(each.size(), kLongestWarning));
}

size_t SizeOf(const appcast_t& page) {
  size_t size = page.app.size() + page.page.size();
  for (const std::string& each : page.config_warnings) size += each.size();
  for (const std::string& each : page.run_warnings) size += each.size();
  return size;
}

double RoundedSeconds(int64_t us) { return std::round(static_cast<double>(us) / 1e5) / 10; }

}  // namespace

void StatusBoard::Take(const appcast_t& page, int64_t now_us) {
  Page taken = {.appcast = page, .taken_us = now_us};
  taken.appcast.page.resize(std::min(page.page.size(), kMaxText_bytes));
  Cut(&taken.appcast.config_warnings);
  Cut(&taken.appcast.run_warnings);
  const std::lock_guard lock(mutex_);
  const size_t size = SizeOf(taken.appcast);
  if (!HasRoom(page.app, size)) {
    DropSilent(now_us);
    if (!HasRoom(page.app, size)) return;
  }
  Page& kept = pages_[page.app];
  num_bytes_ += size - SizeOf(kept.appcast);
  kept = std::move(taken);
}

bool StatusBoard::HasRoom(const std::string& app, size_t size) const {
  const auto known = pages_.find(app);
  if (known == pages_.end()) return pages_.size() < kMaxPages && num_bytes_ + size <= kMax_bytes;
  return num_bytes_ - SizeOf(known->second.appcast) + size <= kMax_bytes;
}

/// Drops the pages of those participants that have not answered for long: unregistered or dead
/// ones.
void StatusBoard::DropSilent(int64_t now_us) {
  if (dropped_us_ != INT64_MIN && now_us - dropped_us_ < kAskInterval_us) return;
  dropped_us_ = now_us;
  std::erase_if(pages_, [&](const auto& item) {
    if (now_us - item.second.taken_us <= kSilence_us) return false;
    num_bytes_ -= SizeOf(item.second.appcast);
    return true;
  });
}

std::string StatusBoard::Json(int64_t now_us) {
  const std::lock_guard lock(mutex_);
  looked_us_ = now_us;
  std::vector<const Page*> pages;
  for (const auto& [app, page] : pages_) pages.push_back(&page);
  std::stable_partition(pages.begin(), pages.end(), [](const Page* page) {
    return !page->appcast.config_warnings.empty() || !page->appcast.run_warnings.empty();
  });
  nlohmann::json list = nlohmann::json::array();
  for (const Page* page : pages) {
    const appcast_t& appcast = page->appcast;
    // As floating point, since the time of an unregistered participant may be any number.
    const double t_s =
        (static_cast<double>(appcast.utime) - static_cast<double>(start_utime_)) / 1e6;
    list.push_back({{"app", appcast.app},
                    {"t", std::round(t_s * 1e3) / 1e3},
                    {"step", appcast.step},
                    {"age_s", RoundedSeconds(now_us - page->taken_us)},
                    {"config_warnings", appcast.config_warnings},
                    {"run_warnings", appcast.run_warnings},
                    {"text", appcast.page}});
  }
  const nlohmann::json all = {{"pages", std::move(list)}};
  return all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

size_t StatusBoard::num_pages() const {
  const std::lock_guard lock(mutex_);
  return pages_.size();
}

bool StatusBoard::WantsPages(int64_t now_us) {
  const std::lock_guard lock(mutex_);
  if (looked_us_ == INT64_MIN || now_us - looked_us_ > kLookLasts_us) return false;
  if (asked_us_ != INT64_MIN && now_us - asked_us_ < kAskInterval_us) return false;
  asked_us_ = now_us;
  return true;
}

}  // namespace shoal
