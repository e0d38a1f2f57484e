#include "apps/viewer/growing_log.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "apps/viewer/access.h"
#include "lib/run/run/reading_bar.h"

namespace shoal {

class PartView : public ViewSource {
 public:
  explicit PartView(std::unique_ptr<RecordedView> part) : part_(std::move(part)) {}

  void SetShare(double share) { share_ = share; }
  /// From now on shows only the begin of the log. The setup gets another name of its start, so that
  /// open pages load it again, and a note with the reason.
  void Fail(const std::string& why) {
    std::string json = part_->SetupJsonWith(
        NewToken(),
        fmt::format("only the log's begin is shown, since the rest cannot be read: {}", why));
    const std::lock_guard lock(mutex_);
    failed_json_ = std::move(json);
  }

  std::string SetupJson(bool commands) override {
    {
      const std::lock_guard lock(mutex_);
      if (!failed_json_.empty()) return failed_json_;
    }
    std::string json = part_->SetupJson(commands);
    json.insert(1, fmt::format("\"indexing\":{:.3f},", share_.load()));
    return json;
  }
  std::string FrameJson(double t_s) override { return part_->FrameJson(t_s); }
  std::string TrailsJson() override { return part_->TrailsJson(); }
  std::string LinksJson(double t_s) override { return part_->LinksJson(t_s); }
  Result<std::string> MediumLinksJson(std::string_view medium, double t_s) override {
    return part_->MediumLinksJson(medium, t_s);
  }
  std::string FatesJson(const FateQuery& query, double t_s) override {
    return part_->FatesJson(query, t_s);
  }
  std::string EventsJson() override { return part_->EventsJson(); }
  std::string VerdictJson() override { return part_->VerdictJson(); }
  BackgroundFolder Backgrounds() override { return part_->Backgrounds(); }
  Result<std::string> LinkJson(std::string_view from, std::string_view to, double t_s) override {
    return part_->LinkJson(from, to, t_s);
  }
  Result<std::string> VehicleJson(std::string_view name, double t_s, double window_s) override {
    return part_->VehicleJson(name, t_s, window_s);
  }

 private:
  const std::unique_ptr<RecordedView> part_;
  std::atomic<double> share_ = 0;
  std::mutex mutex_;
  std::string failed_json_;  ///< The setup after Fail(); empty: the log is still being read.
};

Result<std::unique_ptr<GrowingLog>> GrowingLog::Open(const std::string& path,
                                                     const std::string& mission_file,
                                                     std::function<int64_t()> now_us) {
  const int64_t begin_us = now_us();
  bool is_whole = true;
  Result<std::unique_ptr<RecordedView>> first = RecordedView::Open(
      path, {.mission_file = mission_file, .boot = NewToken(), .progress = [&](double) {
               is_whole = now_us() - begin_us < kFirst_us;
               return is_whole;
             }});
  if (!first.ok()) return Error{first.error()};
  std::unique_ptr<GrowingLog> log(new GrowingLog);
  if (is_whole) {
    log->source_ = std::move(*first);
    return log;
  }
  log->part_ = std::make_shared<PartView>(std::move(*first));
  log->source_ = log->part_;
  log->reading_ =
      std::thread([raw = log.get(), path, mission_file] { raw->ReadAll(path, mission_file); });
  return log;
}

void GrowingLog::ReadAll(const std::string& path, const std::string& mission_file) {
  ReadingBar bar(path);
  Result<std::unique_ptr<RecordedView>> whole = RecordedView::Open(
      path, {.mission_file = mission_file, .boot = NewToken(), .progress = [&](double share) {
               part_->SetShare(share);
               bar.Show(share);
               return !stopped_;
             }});
  if (stopped_) return;
  if (!whole.ok()) {
    fmt::print(stderr, "shoal-viewer: {}\n", whole.error());
    part_->Fail(whole.error());
    return;
  }
  const std::lock_guard lock(mutex_);
  source_ = std::move(*whole);
}

std::shared_ptr<ViewSource> GrowingLog::source() const {
  const std::lock_guard lock(mutex_);
  return source_;
}

void GrowingLog::AwaitAll() {
  if (reading_.joinable()) reading_.join();
}

GrowingLog::~GrowingLog() {
  stopped_ = true;
  AwaitAll();
}

}  // namespace shoal
