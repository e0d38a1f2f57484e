#include "lib/comms/moos_wire/moos_session.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/text/numbers.h"
#include "lib/base/text/terminal_text.h"

namespace shoal {
namespace {

constexpr std::string_view kTimingKey = "_async_timing";
constexpr std::string_view kHostPrefix = "hostname=";
/// The MOOSDB may ask for pauses; longer ones would end the connection.
constexpr double kLongestPause_s = 1;

}  // namespace

MoosSession::MoosSession(MoosSessionOptions options) : options_(std::move(options)) {
  SHOAL_CHECK(options_.warp > 0, "a warp is positive");
}

void MoosSession::Register(std::string_view key, double interval_s) {
  variables_[std::string(key)] = interval_s;
  has_new_subscriptions_ = true;
}

void MoosSession::RegisterPattern(std::string_view pattern, double interval_s) {
  patterns_[std::string(pattern)] = interval_s;
  has_new_subscriptions_ = true;
}

double MoosSession::Time_s(int64_t utc_us) const {
  return Bare_s(utc_us) + (keeps_own_clock_ ? 0 : skew_s_);
}

std::string MoosSession::Connect(int64_t wall_us, int64_t utc_us) {
  SHOAL_CHECK(state_ == State::kAway, "a session is connected once at a time");
  state_ = State::kGreeting;
  problem_.clear();
  reader_ = MoosPacketReader();
  waiting_.clear();
  mail_.clear();
  connected_us_ = wall_us;
  unanswered_since_us_.reset();
  num_answers_ = 0;
  timing_sent_us_ = wall_us - kTimingInterval_us;
  spoke_us_ = wall_us;
  quiet_until_us_ = wall_us;
  pause_us_ = 0;
  std::string bytes = MoosGreeting();
  const MoosMessage name = {.type = moos_type::kData,
                            .data_type = moos_data::kString,
                            .key = std::string(kMoosAsynchronous),
                            .time_s = Bare_s(utc_us),
                            .text = options_.name};
  AppendMoosPacket({&name, 1}, &bytes);
  return bytes;
}

void MoosSession::Disconnect() {
  state_ = State::kAway;
  counts_.discarded += std::count_if(waiting_.begin(), waiting_.end(), [](const auto& each) {
    return each.type == moos_type::kNotify;
  });
  waiting_.clear();
}

bool MoosSession::IsDeaf(int64_t wall_us) const {
  if (state_ == State::kGreeting) return wall_us - connected_us_ > kLongestHandshake_us;
  return state_ == State::kJoined && unanswered_since_us_ &&
         wall_us - *unanswered_since_us_ > kDeafAfter_us;
}

void MoosSession::Take(std::string_view bytes, int64_t wall_us, int64_t utc_us) {
  reader_.Take(bytes, [&](std::span<const MoosMessage> messages) {
    for (const MoosMessage& message : messages) OnMessage(message, wall_us, utc_us);
  });
  if (problem_.empty() && !reader_.problem().empty()) {
    problem_ = "it sent what is not MOOS's: " + reader_.problem();
  }
}

void MoosSession::OnMessage(const MoosMessage& message, int64_t wall_us, int64_t utc_us) {
  if (state_ == State::kGreeting) {
    if (message.type == moos_type::kWelcome) {
      OnWelcome(message, wall_us, utc_us);
    } else if (message.type == moos_type::kPoison) {
      state_ = State::kRefused;
      problem_ = "it refuses the name '" + options_.name + "': " + TerminalLine(message.text, 200);
    } else {
      problem_ = "it answered the name with a message of another type than a welcome";
    }
    return;
  }
  if (state_ == State::kJoined) OnAnswer(message, utc_us);
}

void MoosSession::OnWelcome(const MoosMessage& message, int64_t wall_us, int64_t utc_us) {
  state_ = State::kJoined;
  ++counts_.joined;
  community_ = message.community;
  skew_s_ = std::isfinite(message.value) ? message.value : 0;
  const std::string_view aux = message.source_aux;
  keeps_own_clock_ =
      aux.starts_with(kHostPrefix) && aux.substr(kHostPrefix.size()) == options_.host;
  const double unix_s = static_cast<double>(utc_us) / 1e6;
  if (unix_s > 0) warp_of_server_ = (Bare_s(utc_us) + skew_s_) / unix_s;
  spoke_us_ = wall_us;
  has_new_subscriptions_ = true;
}

void MoosSession::OnAnswer(const MoosMessage& message, int64_t utc_us) {
  if (message.type == moos_type::kTiming) {
    OnTiming(message, utc_us);
  } else if (message.type == moos_type::kNotify) {
    ++counts_.received;
    if (mail_.size() < kMaxWaiting) {
      mail_.push_back(message);
    } else {
      ++counts_.discarded;
    }
  }
}

void MoosSession::OnTiming(const MoosMessage& message, int64_t utc_us) {
  unanswered_since_us_.reset();
  ++num_answers_;
  const double pause_s = std::isfinite(message.value2) ? message.value2 : 0;
  pause_us_ = static_cast<int64_t>(std::clamp(pause_s, 0.0, kLongestPause_s) * 1e6);
  // The first comes with the welcome's delay in it.
  if (num_answers_ < 2 || !std::isfinite(message.value) || !std::isfinite(message.time_s)) return;
  const double measured_s = message.value - (message.time_s + Bare_s(utc_us)) / 2;
  skew_s_ = 0.9 * skew_s_ + 0.1 * measured_s;
}

void MoosSession::Stamp(MoosMessage* message, int64_t utc_us) {
  message->id = next_id_;
  next_id_ = next_id_ == INT32_MAX ? 0 : next_id_ + 1;
  message->source = options_.name;
  message->time_s = Time_s(utc_us);
}

void MoosSession::Queue(MoosMessage message, int64_t utc_us) {
  if (state_ != State::kJoined || waiting_.size() >= kMaxWaiting ||
      MoosMessageBytes(message) + kMinMoosPacketBytes > kMaxMoosPacketBytes) {
    if (message.type == moos_type::kNotify) ++counts_.discarded;
    return;
  }
  Stamp(&message, utc_us);
  waiting_.push_back(std::move(message));
}

void MoosSession::Notify(std::string_view key, double value, int64_t utc_us) {
  Queue(MoosNotify(options_.name, key, value), utc_us);
}

void MoosSession::Notify(std::string_view key, std::string_view text, int64_t utc_us) {
  Queue(MoosNotify(options_.name, key, text), utc_us);
}

void MoosSession::QueueRegister(const std::string& key, double interval_s, int64_t utc_us) {
  Queue({.type = moos_type::kRegister, .key = key, .value = interval_s}, utc_us);
}

void MoosSession::QueuePattern(const std::string& pattern, double interval_s, int64_t utc_us) {
  Queue({.type = moos_type::kWildcardRegister,
         .data_type = moos_data::kString,
         .key = options_.name,
         .text = "AppPattern=*,VarPattern=" + pattern + ",Interval=" + ShortestText(interval_s)},
        utc_us);
}

std::string MoosSession::Flush(int64_t wall_us, int64_t utc_us) {
  if (state_ != State::kJoined || wall_us < quiet_until_us_) return "";
  if (std::exchange(has_new_subscriptions_, false)) {
    for (const auto& [key, interval_s] : variables_) QueueRegister(key, interval_s, utc_us);
    for (const auto& [key, interval_s] : patterns_) QueuePattern(key, interval_s, utc_us);
  }
  std::vector<MoosMessage> messages;
  if (wall_us - timing_sent_us_ >= kTimingInterval_us) {
    timing_sent_us_ = wall_us;
    if (!unanswered_since_us_) unanswered_since_us_ = wall_us;
    messages.push_back({.type = moos_type::kTiming,
                        .key = std::string(kTimingKey),
                        .time_s = Bare_s(utc_us),
                        .value = 0});
  }
  if (waiting_.empty() && wall_us - spoke_us_ >= kFetchInterval_us) {
    Queue({.type = moos_type::kNull}, utc_us);
  }
  if (!waiting_.empty()) spoke_us_ = wall_us;
  for (MoosMessage& message : waiting_) {
    if (message.type == moos_type::kNotify) ++counts_.sent;
    messages.push_back(std::move(message));
  }
  waiting_.clear();
  if (messages.empty()) return "";
  quiet_until_us_ = wall_us + pause_us_;
  std::string bytes;
  AppendMoosPackets(messages, &bytes);
  return bytes;
}

std::vector<MoosMessage> MoosSession::TakeMail() { return std::exchange(mail_, {}); }

}  // namespace shoal
