#include "lib/tools/trials/trial_queue.h"

#include <algorithm>
namespace shoal {

TrialQueue::TrialQueue(const CampaignFolder& folder, const Shard& shard, const StoredTrials& stored)
    : folder_(folder),
      shard_(shard),
      stop_(StopValuesOf(folder)),
      cases_(folder.plan.cases.size()) {
  const int64_t repetitions = folder.campaign.repetitions;
  for (size_t i = 0; i < cases_.size(); ++i) {
    CaseState& each = cases_[i];
    for (int64_t repetition = 1; repetition <= repetitions; ++repetition) {
      if (shard_.Has(i, repetition)) ++num_planned_;
    }
    for (const auto& [repetition, trial] : stored.by_case[i]) {
      each.finished.insert(repetition);
      if (shard_.Has(i, repetition)) ++num_finished_;
      if (stop_) each.values[repetition] = stop_->Of(trial.result);
    }
    each.limit = repetitions;
    if (folder.campaign.stop && !folder.campaign.stop->looks.empty()) {
      each.limit = folder.campaign.stop->looks.front();
    }
    Advance(i);
  }
}

void TrialQueue::Advance(size_t number) {
  CaseState& each = cases_[number];
  while (!each.is_stopped) {
    while (each.next <= each.limit &&
           (!shard_.Has(number, each.next) || each.finished.contains(each.next))) {
      ++each.next;
    }
    if (each.next <= each.limit) {
      ready_.emplace(each.next, number);
      return;
    }
    if (each.limit == folder_.campaign.repetitions || !each.under_way.empty()) return;
    Look(number);
  }
}

void TrialQueue::Look(size_t number) {
  CaseState& each = cases_[number];
  const StopRule& rule = *folder_.campaign.stop;
  const auto stop = stop_->StopsAfter(each.values, each.limit);
  if (stop && *stop <= each.limit) {
    each.is_stopped = true;
    for (int64_t rest = each.limit + 1; rest <= folder_.campaign.repetitions; ++rest) {
      if (shard_.Has(number, rest) && !each.finished.contains(rest)) ++num_spared_;
    }
    return;
  }
  const auto next = std::upper_bound(rule.looks.begin(), rule.looks.end(), each.limit);
  each.limit = next == rule.looks.end() ? folder_.campaign.repetitions : *next;
}

std::optional<TrialJob> TrialQueue::Next() {
  if (ready_.empty()) return std::nullopt;
  const auto [repetition, number] = *ready_.begin();
  ready_.erase(ready_.begin());
  CaseState& each = cases_[number];
  each.under_way.insert(repetition);
  each.next = repetition + 1;
  Advance(number);
  return TrialJob{.case_number = number, .repetition = repetition};
}

void TrialQueue::Finish(const TrialJob& job, const TrialResult& result) {
  CaseState& each = cases_[job.case_number];
  each.under_way.erase(job.repetition);
  each.finished.insert(job.repetition);
  ++num_finished_;
  if (stop_) each.values[job.repetition] = stop_->Of(result);
  if (each.under_way.empty()) Advance(job.case_number);
}

}  // namespace shoal
