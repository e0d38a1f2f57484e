#include "lib/comms/moos_wire/moos_variables.h"

#include <algorithm>
#include <functional>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/comms/moos_wire/moos_glob.h"

namespace shoal {
namespace {

bool Fits(const MoosPattern& pattern, const MoosMessage& last) {
  return MatchesMoosGlob(pattern.source, last.source) && MatchesMoosGlob(pattern.key, last.key);
}

size_t ValueBytes(const MoosMessage& message) {
  return message.text.size() + message.source.size() + message.source_aux.size() +
         message.community.size();
}

}  // namespace

MoosPattern ParseMoosPattern(std::string_view text) {
  MoosPattern pattern;
  for (const std::string_view part : TrimmedParts(text, ',')) {
    const size_t equals = part.find('=');
    if (equals == std::string_view::npos) continue;
    const std::string_view key = Trimmed(part.substr(0, equals));
    const std::string_view value = Trimmed(part.substr(equals + 1));
    if (IsSameWord(key, "AppPattern")) pattern.source = value;
    if (IsSameWord(key, "VarPattern")) pattern.key = value;
    if (IsSameWord(key, "Interval")) pattern.interval_s = NumberIn(value).value_or(0);
  }
  return pattern;
}

MoosVariables::Variable* MoosVariables::FindOrMake(const std::string& key) {
  const auto found = variables_.find(key);
  if (found != variables_.end()) return &found->second;
  if (key.size() > limits_.max_key_bytes || variables_.size() >= limits_.max_variables) {
    return nullptr;
  }
  return &variables_[key];
}

MoosVariables::Subscription* MoosVariables::SubscribeTo(MoosClientId client, Variable* variable) {
  const auto found = variable->subscribers.find(client);
  if (found != variable->subscribers.end()) return &found->second;
  if (num_subscriptions_ >= limits_.max_subscriptions) return nullptr;
  ++num_subscriptions_;
  return &variable->subscribers[client];
}

bool MoosVariables::Write(const MoosMessage& message, double time_s, MoosMail* mail) {
  Variable* variable = FindOrMake(message.key);
  if (variable == nullptr) {
    ++counts_.beyond;
    return false;
  }
  const bool is_first = !variable->last;
  if (!is_first && variable->last->data_type != message.data_type) {
    ++counts_.wrong_type;
    return false;
  }
  const size_t before = is_first ? 0 : ValueBytes(*variable->last);
  if (num_value_bytes_ - before + ValueBytes(message) > limits_.max_value_bytes) {
    ++counts_.beyond;
    return false;
  }
  num_value_bytes_ += ValueBytes(message) - before;
  variable->last = message;
  ++counts_.written;
  if (is_first) {
    for (const auto& [client, patterns] : patterns_) {
      const auto fitting = std::find_if(patterns.rbegin(), patterns.rend(),
                                        [&](const auto& each) { return Fits(each, message); });
      if (fitting == patterns.rend() || variable->subscribers.contains(client)) continue;
      if (Subscription* made = SubscribeTo(client, variable)) {
        made->interval_s = fitting->interval_s;
      }
    }
  }
  for (auto& [client, subscription] : variable->subscribers) {
    if (time_s - subscription.sent_s < subscription.interval_s) continue;
    subscription.sent_s = time_s;
    mail->emplace_back(client, message);
  }
  return true;
}

void MoosVariables::Present(MoosClientId client, double time_s, Variable* variable,
                            MoosMail* mail) {
  if (!variable->last) return;
  variable->subscribers[client].sent_s = time_s;
  mail->emplace_back(client, *variable->last);
  mail->back().second.id = kMoosNoId;
}

void MoosVariables::Subscribe(MoosClientId client, const std::string& key, double interval_s,
                              double time_s, MoosMail* mail) {
  Variable* variable = FindOrMake(key);
  Subscription* subscription = variable == nullptr ? nullptr : SubscribeTo(client, variable);
  if (subscription == nullptr) {
    ++counts_.beyond;
    return;
  }
  subscription->interval_s = interval_s;
  Present(client, time_s, variable, mail);
}

void MoosVariables::Unsubscribe(MoosClientId client, std::string_view key) {
  const auto found = variables_.find(key);
  if (found == variables_.end()) return;
  num_subscriptions_ -= found->second.subscribers.erase(client);
  if (!found->second.last && found->second.subscribers.empty()) variables_.erase(found);
}

void MoosVariables::SubscribePattern(MoosClientId client, const MoosPattern& pattern, double time_s,
                                     MoosMail* mail) {
  std::vector<MoosPattern>& patterns = patterns_[client];
  const bool is_known = std::any_of(patterns.begin(), patterns.end(), [&](const auto& each) {
    return each.source == pattern.source && each.key == pattern.key;
  });
  const bool is_long =
      pattern.source.size() > limits_.max_key_bytes || pattern.key.size() > limits_.max_key_bytes;
  if (is_long || (!is_known && patterns.size() >= limits_.max_patterns)) {
    ++counts_.beyond;
    return;
  }
  std::erase_if(patterns, [&](const auto& each) {
    return each.source == pattern.source && each.key == pattern.key;
  });
  patterns.push_back(pattern);
  for (auto& [key, variable] : variables_) {
    if (!variable.last || !Fits(pattern, *variable.last)) continue;
    Subscription* subscription = SubscribeTo(client, &variable);
    if (subscription == nullptr) {
      ++counts_.beyond;
      return;
    }
    subscription->interval_s = pattern.interval_s;
    Present(client, time_s, &variable, mail);
  }
}

void MoosVariables::UnsubscribePattern(MoosClientId client, const MoosPattern& pattern) {
  for (auto& [key, variable] : variables_) {
    if (!variable.last || !Fits(pattern, *variable.last)) continue;
    num_subscriptions_ -= variable.subscribers.erase(client);
  }
}

void MoosVariables::Remove(MoosClientId client) {
  patterns_.erase(client);
  for (auto& [key, variable] : variables_) {
    num_subscriptions_ -= variable.subscribers.erase(client);
  }
  std::erase_if(variables_, [](const auto& entry) {
    return !entry.second.last && entry.second.subscribers.empty();
  });
}

const MoosMessage* MoosVariables::Find(std::string_view key) const {
  const auto found = variables_.find(key);
  return found == variables_.end() || !found->second.last ? nullptr : &*found->second.last;
}

std::vector<std::string> MoosVariables::Names() const {
  std::vector<std::string> names;
  for (const auto& [key, variable] : variables_) {
    if (variable.last) names.push_back(key);
  }
  return names;
}

}  // namespace shoal
