#include "apps/shoal_play/playback_app.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"

namespace shoal {

namespace {

constexpr std::string_view kLcmSelfTest = "LCM_SELF_TEST";
constexpr size_t kLongestChannel = 63;  ///< LCM sends no longer name.

}  // namespace

bool IsPlayed(std::string_view channel) {
  if (channel == kLcmSelfTest || channel.empty() || channel.size() > kLongestChannel) return false;
  return std::ranges::none_of(ChannelTable(), [&](const ChannelRow& row) {
    return row.topic == channel && (row.is_answer || row.home == ChannelHome::kTickPort ||
                                    row.home == ChannelHome::kDonePort);
  });
}

PlaybackApp::PlaybackApp(PlaybackLog* log, const ChannelChoice& channels, int64_t tick_us,
                         LogWriter* answers, Bus& bus)
    : log_(*log),
      channels_(channels),
      tick_us_(tick_us),
      answers_(answers),
      bus_(bus),
      next_(log_.Next()),
      rules_(log_.rules()),
      is_at_end_(!next_) {
  if (answers_ == nullptr) return;
  bus.SubscribeAll([this](const Message& message) {
    if (message.publisher == kPlaybackName || !IsPlayed(message.channel)) return;
    answers_->Append(utime_, message.channel, message.data);
    ++counts_.answers;
  });
}

void PlaybackApp::FlushAnswers() {
  if (answers_ == nullptr || !fault_.empty()) return;
  if (const auto error = answers_->Flush()) fault_ = error->message;
}

void PlaybackApp::Tick(int64_t utime) {
  FlushAnswers();
  utime_ = utime;
  if (!std::exchange(has_begun_, true)) PublishHolding();
  for (; next_ && next_->utime < utime + tick_us_; next_ = log_.Next()) PublishEvent(*next_);
  is_at_end_ = !next_;
}

void PlaybackApp::PublishHolding() {
  for (const HoldingMessage& message : log_.holding()) {
    if (!channels_.Takes(message.channel)) continue;
    bus_.PublishBytes(message.channel, message.data);
    ++counts_.repeated;
  }
}

void PlaybackApp::PublishEvent(const LogEvent& event) {
  if (!IsPlayed(event.channel)) {
    ++counts_.left_out;
    return;
  }
  if (!channels_.Takes(event.channel)) {
    ++counts_.not_chosen;
    return;
  }
  // Messages that lcm-logger has written may have a seal; here they get another.
  const std::span<const uint8_t> message = Unseal(event.data).message;
  if (event.channel == topics::kCommsRules) rules_.assign(message.begin(), message.end());
  bus_.PublishBytes(event.channel, message);
  ++counts_.played;
  counts_.bytes += static_cast<int64_t>(message.size());
}

StatusPage PlaybackApp::Status() const {
  StatusPage page;
  page.text = fmt::format(
      "PLAYBACK of {}: no mission runs here, and orders have no effect\n"
      "At:         {:.1f} s of {:.1f} s\n"
      "Played:     {} messages, {} bytes\n"
      "Left out:   {} of the stepping and of LCM, {} not chosen by --channels and --without\n",
      log_.path(), Seconds(utime_ - log_.first_utime()),
      Seconds(log_.last_utime() - log_.first_utime()), counts_.played, counts_.bytes,
      counts_.left_out, counts_.not_chosen);
  if (answers_ != nullptr) {
    page.text += fmt::format("Answers:    {} messages in {}\n", counts_.answers, answers_->path());
  }
  if (log_.num_damages() > 0) {
    page.run_warnings.push_back(
        fmt::format("{} damaged parts of the log are skipped; `shoal log "
                    "info {}` shows them",
                    log_.num_damages(), log_.path()));
  }
  return page;
}

std::vector<std::string> PlaybackApp::RequestChannels() const {
  return {channels::CommsRulesReq().name};
}

std::optional<App::RequestAnswer> PlaybackApp::Answer(std::string_view channel,
                                                      std::span<const uint8_t> /*data*/) const {
  if (channel != channels::CommsRulesReq().name || rules_.empty()) return std::nullopt;
  return RequestAnswer{.channel = channels::CommsRulesNow().name, .data = rules_};
}

}  // namespace shoal
