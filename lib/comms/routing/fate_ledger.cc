#include "lib/comms/routing/fate_ledger.h"

namespace shoal {

int64_t FateLedger::TakeNumber(Kind kind, Contact* source) {
  const auto place = static_cast<size_t>(kind);
  ++num_offered_[place];
  return source == nullptr ? num_of_unknown_[place]++ : source->num_sent[place]++;
}

void FateLedger::Record(const RoutingRules& rules, const Decision& decision, Contact* source,
                        Contact* receiver, std::vector<Decision>* decisions) {
  Decision& recorded = decisions->emplace_back(decision);
  if (decision.cause == Cause::kDelivered && GoesOverMedia(rules, decision.kind)) {
    recorded.cause = Cause::kInTransit;
  }
  const auto kind = static_cast<size_t>(recorded.kind);
  const auto cause = static_cast<size_t>(recorded.cause);
  counts_[kind][cause] += decision.count;
  if (source != nullptr) {
    recorded.source = source->index;
    source->sent[kind][cause] += decision.count;
  }
  if (receiver != nullptr) {
    recorded.destination = receiver->index;
    receiver->received[kind][cause] += decision.count;
  }
}

void FateLedger::RecordRefusal(Kind kind, Cause cause, Contact* source) {
  ++counts_[static_cast<size_t>(kind)][static_cast<size_t>(cause)];
  if (source != nullptr) ++source->sent[static_cast<size_t>(kind)][static_cast<size_t>(cause)];
}

void FateLedger::Conclude(Kind kind, Cause cause, Contact* source, Contact* receiver) {
  const auto place = static_cast<size_t>(kind);
  const auto move = [&](CauseCounts* counts) {
    int64_t& num_in_transit = (*counts)[static_cast<size_t>(Cause::kInTransit)];
    if (num_in_transit == 0) return;  // Another vehicle, that has taken the name.
    --num_in_transit;
    ++(*counts)[static_cast<size_t>(cause)];
  };
  move(&counts_[place]);
  if (source != nullptr) move(&source->sent[place]);
  if (receiver != nullptr) move(&receiver->received[place]);
}

int64_t FateLedger::NumInTransit() const {
  int64_t sum = 0;
  for (const CauseCounts& counts : counts_) sum += counts[static_cast<size_t>(Cause::kInTransit)];
  return sum;
}

}  // namespace shoal
