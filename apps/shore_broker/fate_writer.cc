#include "apps/shore_broker/fate_writer.h"

#include <bit>
#include <utility>

namespace shoal {

namespace {

/// Of a message's own members, the fingerprint and all lengths.
constexpr size_t kHead_bytes = 8 + 8 + size_t{8} * 4;
/// Of a text, besides its characters.
constexpr size_t kTextRest_bytes = 5;
constexpr size_t kSenderRest_bytes = 2 * kTextRest_bytes + 8 + 4;
constexpr size_t kCaseRest_bytes = 2 * kTextRest_bytes + size_t{4} * 8 + size_t{2} * 4 + 4;
/// Of a fate: two indices, and the numbers that it may have of its own.
constexpr size_t kMostOfFate_bytes = 2 * 2 + 8 + 8 + 4;

}  // namespace

size_t FateWriter::HashOfCase::operator()(const Case& of) const {
  constexpr uint64_t kOdd = 0x9e3779b97f4a7c15;
  uint64_t hash = static_cast<uint64_t>(of.cause) << 8 | static_cast<uint64_t>(of.override_rule);
  for (const uint64_t each :
       {of.limit_m, of.age_s, of.loss_pct, static_cast<uint64_t>(of.length_bytes)}) {
    hash = std::rotl(hash ^ each, 29) * kOdd;
  }
  return hash ^ hash >> 32;
}

FateWriter::FateWriter(Bus& bus, OnFates on_fates)
    : bus_(bus), on_fates_(std::move(on_fates)), message_{}, list_{} {}

void FateWriter::Add(int64_t utime, const Decision& decision, std::string_view source,
                     std::string_view destination, const acoustic_path_t* path) {
  if (decision.destination == kOthers) destination = "*";
  const size_t path_bytes =
      path == nullptr ? 0 : static_cast<size_t>(path->_getEncodedSizeNoHash());
  // Were each part of it new.
  const size_t most_bytes = kMostOfFate_bytes + path_bytes + kSenderRest_bytes + source.size() +
                            kCaseRest_bytes + CauseText(decision.cause).size() +
                            OverrideText(decision.override_rule).size() +
                            KindText(decision.kind).size() + kTextRest_bytes + destination.size();
  if (num_bytes_ + most_bytes > kMaxMessage_bytes) Flush(utime);
  if (num_bytes_ == 0) num_bytes_ = kHead_bytes;
  AddSender(decision, source);
  message_.destination.push_back(NameOf(decision.destination, destination));
  const int16_t which = CaseOf(decision, path != nullptr);
  message_.which_case.push_back(which);
  num_bytes_ += 4;
  if (last_case_.has_range) {
    message_.range_m.push_back(decision.range_m);
    num_bytes_ += 8;
  }
  if (last_case_.has_wait) {
    message_.wait_s.push_back(decision.wait_s);
    num_bytes_ += 8;
  }
  if (last_case_.has_count) {
    message_.count.push_back(decision.count);
    num_bytes_ += 4;
  }
  if (path != nullptr) {
    message_.path.push_back(*path);
    num_bytes_ += path_bytes;
  }
}

void FateWriter::AddSender(const Decision& decision, std::string_view source) {
  if (!message_.senders.empty()) {
    fate_sender_t& last = message_.senders.back();
    if (last.number == decision.number && last.source == source &&
        last.kind == KindText(decision.kind)) {
      ++last.num_fates;
      return;
    }
  }
  fate_sender_t& sender = message_.senders.emplace_back();
  sender.kind = KindText(decision.kind);
  sender.source = source;
  sender.number = decision.number;
  sender.num_fates = 1;
  num_bytes_ += kSenderRest_bytes + sender.kind.size() + source.size();
}

/// Leaves the case in last_case_.
int16_t FateWriter::CaseOf(const Decision& decision, bool has_path) {
  const Case of = {.cause = decision.cause,
                   .override_rule = decision.override_rule,
                   .has_range = decision.range_m != -1,
                   .has_wait = decision.wait_s != -1,
                   .has_count = decision.count != 1,
                   .has_path = has_path,
                   .length_bytes = static_cast<int32_t>(decision.length_bytes),
                   .length_limit_bytes = static_cast<int32_t>(decision.length_limit_bytes),
                   .limit_m = std::bit_cast<uint64_t>(decision.limit_m),
                   .age_s = std::bit_cast<uint64_t>(decision.age_s),
                   .age_limit_s = std::bit_cast<uint64_t>(decision.age_limit_s),
                   .loss_pct = std::bit_cast<uint64_t>(decision.loss_pct)};
  if (last_case_index_ >= 0 && of == last_case_) return last_case_index_;
  last_case_ = of;
  const auto [it, is_new] = cases_.try_emplace(of, static_cast<int16_t>(message_.cases.size()));
  last_case_index_ = it->second;
  if (!is_new) return last_case_index_;
  fate_case_t& made = message_.cases.emplace_back();
  made.cause = CauseText(decision.cause);
  made.override_rule = OverrideText(decision.override_rule);
  made.limit_m = decision.limit_m;
  made.age_s = decision.age_s;
  made.age_limit_s = decision.age_limit_s;
  made.loss_pct = decision.loss_pct;
  made.length_bytes = of.length_bytes;
  made.length_limit_bytes = of.length_limit_bytes;
  made.has_range = static_cast<int8_t>(of.has_range);
  made.has_wait = static_cast<int8_t>(of.has_wait);
  made.has_count = static_cast<int8_t>(of.has_count);
  made.has_path = static_cast<int8_t>(of.has_path);
  num_bytes_ += kCaseRest_bytes + made.cause.size() + made.override_rule.size();
  return last_case_index_;
}

int16_t FateWriter::NameOf(int32_t contact, std::string_view name) {
  const auto place = static_cast<size_t>(contact);
  if (contact >= 0) {
    if (place >= name_of_contact_.size()) name_of_contact_.resize(place + 1, -1);
    const int16_t known = name_of_contact_[place];
    // A contact may be forgotten, and its place be another's.
    if (known >= 0 && message_.names[static_cast<size_t>(known)] == name) return known;
  }
  auto found = names_.find(name);
  if (found == names_.end()) {
    found = names_.emplace(name, static_cast<int16_t>(message_.names.size())).first;
    message_.names.emplace_back(name);
    num_bytes_ += kTextRest_bytes + name.size();
  }
  if (contact >= 0) name_of_contact_[place] = found->second;
  return found->second;
}

void FateWriter::Flush(int64_t utime) {
  if (message_.destination.empty()) return;
  message_.utime = utime;
  const auto size = [](const auto& list) { return static_cast<int32_t>(list.size()); };
  message_.num_senders = size(message_.senders);
  message_.num_cases = size(message_.cases);
  message_.num_names = size(message_.names);
  message_.num_fates = size(message_.destination);
  message_.num_ranges = size(message_.range_m);
  message_.num_waits = size(message_.wait_s);
  message_.num_counts = size(message_.count);
  message_.num_paths = size(message_.path);
  Publish(bus_, channel_, message_);
  if (on_fates_ && ListOf(message_, &list_)) on_fates_(list_.fates);
  message_.senders.clear();
  message_.cases.clear();
  message_.names.clear();
  message_.destination.clear();
  message_.which_case.clear();
  message_.range_m.clear();
  message_.wait_s.clear();
  message_.count.clear();
  message_.path.clear();
  num_bytes_ = 0;
  last_case_index_ = -1;
  cases_.clear();
  name_of_contact_.assign(name_of_contact_.size(), -1);
  names_.clear();
}

}  // namespace shoal
