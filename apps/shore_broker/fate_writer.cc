#include "apps/shore_broker/fate_writer.h"

namespace shoal {

FateWriter::FateWriter(Bus& bus) : bus_(bus) {
  message_.num_fates = 0;
  message_.fates.resize(kMaxFatesPerMessage);
  for (fate_t& fate : message_.fates) fate.kind = "report";
}

void FateWriter::Add(int64_t utime, const Decision& decision, std::string_view source,
                     std::string_view destination) {
  if (message_.num_fates == kMaxFatesPerMessage) Flush(utime);
  fate_t& fate = message_.fates[static_cast<size_t>(message_.num_fates++)];
  fate.source = source;
  fate.destination = destination;
  fate.number = decision.number;
  fate.cause = CauseText(decision.cause);
  fate.range_m = decision.range_m;
  fate.limit_m = decision.limit_m;
  fate.age_s = decision.age_s;
  fate.age_limit_s = decision.age_limit_s;
}

void FateWriter::Flush(int64_t utime) {
  if (message_.num_fates == 0) return;
  message_.utime = utime;
  Publish(bus_, channel_, message_);
  message_.num_fates = 0;
}

}  // namespace shoal
