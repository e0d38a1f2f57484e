#include "apps/recorder/recorder_app.h"

#include <fmt/format.h>

#include "lib/bus/bus/channels.h"

namespace shoal {

namespace {
/// LCM sends this to itself when a process joins a bus.
constexpr std::string_view kLcmSelfTest = "LCM_SELF_TEST";
/// Any program may publish on any number of channels; this bounds the page.
constexpr size_t kMaxChannelsShown = 500;
}  // namespace

RecorderApp::RecorderApp(const RecorderOptions& options, Bus& bus)
    : options_(options), utime_(options.start_utime), last_(channels_.end()) {
  Result<LogWriter> writer = LogWriter::Create(options_.path);
  if (writer.ok()) {
    writer_.emplace(std::move(*writer));
  } else {
    Note(Error{writer.error()});
  }
  bus.SubscribeAll([this](const Message& message) { Record(message); });
}

RecorderApp::ChannelCount& RecorderApp::CountOf(std::string_view channel) {
  auto found = last_;
  if (found != channels_.end() && found->first != channel) ++found;
  if (found == channels_.end() || found->first != channel) found = channels_.find(channel);
  if (found == channels_.end()) {
    const bool is_logged = channel != kLcmSelfTest && (options_.log_all || IsLogged(channel)) &&
                           options_.channels.Takes(channel);
    found = channels_.emplace(std::string(channel), ChannelCount{.is_logged = is_logged}).first;
  }
  last_ = found;
  return found->second;
}

void RecorderApp::Record(const Message& message) {
  ChannelCount& count = CountOf(message.channel);
  if (!count.is_logged) return;
  ++count.events;
  count.bytes += static_cast<int64_t>(message.data.size());
  if (writer_) {
    writer_->Append(utime_, message.channel, message.data);
  } else {
    ++dropped_;
  }
}

void RecorderApp::Note(const std::optional<Error>& error) {
  if (!error || !error_.empty()) return;
  error_ = error->message;
  log_.Warn(error_);
}

void RecorderApp::Tick(int64_t utime) {
  if (writer_) {
    Note(writer_->Flush());
    counters_ = writer_->counters();
  }
  utime_ = utime;
}

void RecorderApp::End() {
  if (!writer_) return;
  Note(writer_->Close());
  counters_ = writer_->counters();
  writer_.reset();
}

StatusPage RecorderApp::Status() const {
  StatusPage page;
  page.text =
      fmt::format("Log:      {}\nWritten:  {} events, {} bytes\nDropped:  {} events\n\n",
                  options_.path, counters_.events, counters_.bytes, counters_.dropped + dropped_);
  page.text += fmt::format("{:<32} {:>10} {:>12}\n", "Channel", "events", "bytes");
  size_t num_shown = 0;
  for (const auto& [channel, count] : channels_) {
    if (!count.is_logged) continue;
    if (++num_shown > kMaxChannelsShown) continue;
    page.text += fmt::format("{:<32} {:>10} {:>12}\n", channel, count.events, count.bytes);
  }
  if (num_shown > kMaxChannelsShown) {
    page.text += fmt::format("... and {} more channels\n", num_shown - kMaxChannelsShown);
  }
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
