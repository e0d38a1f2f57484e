#include "apps/shore_broker/fate_writer.h"

#include <utility>

namespace shoal {

FateWriter::FateWriter(Bus& bus, OnFates on_fates) : bus_(bus), on_fates_(std::move(on_fates)) {
  message_.num_fates = 0;
  message_.fates.resize(kMaxFatesPerMessage);
}

void FateWriter::Add(int64_t utime, const Decision& decision, std::string_view source,
                     std::string_view destination, const acoustic_path_t* path) {
  if (message_.num_fates == kMaxFatesPerMessage || num_paths_ == kMaxPathsPerMessage) Flush(utime);
  fate_t& fate = message_.fates[static_cast<size_t>(message_.num_fates++)];
  fate.kind = KindText(decision.kind);
  fate.source = source;
  fate.destination = decision.destination == kOthers ? "*" : destination;
  fate.count = decision.count;
  fate.number = decision.number;
  fate.cause = CauseText(decision.cause);
  fate.override_rule = OverrideText(decision.override_rule);
  fate.range_m = decision.range_m;
  fate.limit_m = decision.limit_m;
  fate.age_s = decision.age_s;
  fate.age_limit_s = decision.age_limit_s;
  fate.wait_s = decision.wait_s;
  fate.loss_pct = decision.loss_pct;
  fate.length_bytes = static_cast<int32_t>(decision.length_bytes);
  fate.length_limit_bytes = static_cast<int32_t>(decision.length_limit_bytes);
  fate.path.clear();
  if (path != nullptr) {
    fate.path.push_back(*path);
    ++num_paths_;
  }
  fate.num_paths = static_cast<int32_t>(fate.path.size());
}

void FateWriter::Flush(int64_t utime) {
  if (message_.num_fates == 0) return;
  message_.utime = utime;
  Publish(bus_, channel_, message_);
  if (on_fates_) {
    on_fates_(std::span(message_.fates).first(static_cast<size_t>(message_.num_fates)));
  }
  message_.num_fates = 0;
  num_paths_ = 0;
}

}  // namespace shoal
