#include "lib/helm/behaviors/behavior_runner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/helm/behaviors/contact_recipe.h"
#include "lib/helm/modes/value_text.h"

namespace shoal {
namespace {

std::vector<std::pair<std::string_view, const std::vector<std::string>*>> CommonFlags(
    const BehaviorFlags& flags) {
  return {{"runflag", &flags.runflag},           {"runxflag", &flags.runxflag},
          {"idleflag", &flags.idleflag},         {"activeflag", &flags.activeflag},
          {"inactiveflag", &flags.inactiveflag}, {"endflag", &flags.endflag},
          {"spawnflag", &flags.spawnflag},       {"spawnxflag", &flags.spawnxflag},
          {"configflag", &flags.configflag}};
}

bool AllFinite(const std::vector<double>& values, size_t count) {
  return (values.empty() || values.size() == count) &&
         std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

bool IsSound(const Objective& objective, const Domain& domain) {
  return AllFinite(objective.course, Domain::kNumCourses) &&
         AllFinite(objective.speed, static_cast<size_t>(domain.speed_mps.count)) &&
         AllFinite(objective.depth, static_cast<size_t>(domain.depth_m.count)) &&
         std::isfinite(objective.offset) && std::isfinite(objective.scale);
}

/// Remaining seconds as whole ones above 10, else with one decimal.
double RoundedRemaining(double seconds) {
  return seconds > 10 ? std::ceil(seconds) : std::ceil(seconds * 10) / 10;
}

/// Returns the text with at most two decimals.
std::string Rounded(double value) { return TextOf(std::round(value * 100) / 100); }

bool MayBeRepeated(std::string_view update) {
  return update.find("toggle") != std::string_view::npos ||
         update.find("mod_") != std::string_view::npos;
}

}  // namespace

std::string_view Name(RunState state) {
  switch (state) {
    case RunState::kNew:
      return "new";
    case RunState::kIdle:
      return "idle";
    case RunState::kRunning:
      return "running";
    case RunState::kActive:
      return "active";
    case RunState::kCompleted:
      return "completed";
  }
  return "";
}

std::vector<std::string> ConditionsOf(const BehaviorOptions& options) {
  AnyBehavior what = options.what;
  const std::string* contact = ContactOf(what);
  if (contact == nullptr) return options.condition;
  std::string name = *contact;
  for (char& c : name) {
    if (!IsNameCharacter(c)) c = '_';
  }
  if (name.empty()) name = "CONTACT";
  std::vector<std::string> conditions = options.condition;
  for (std::string& text : conditions) {
    for (const auto& [macro, value] :
         {std::pair<std::string_view, std::string>("$[CONTACT]", UpperCase(name)),
          {"$[contact]", LowerCase(name)},
          {"$[Contact]", name}}) {
      for (size_t at = text.find(macro); at != text.npos;
           at = text.find(macro, at + value.size())) {
        text.replace(at, macro.size(), value);
      }
    }
  }
  return conditions;
}

std::string Problem(const BehaviorOptions& options) {
  const auto conditions = ParseConditions(ConditionsOf(options));
  if (!conditions.ok()) return conditions.error();
  std::vector<const std::vector<std::string>*> lists = EachOwnFlags(options.what);
  for (const auto& [name, list] : CommonFlags(options.flags)) lists.push_back(list);
  for (const auto* list : lists) {
    const auto flags = ParseFlags(*list);
    if (!flags.ok()) return flags.error();
  }
  const ContactOptions* contact = ContactOptionsOf(options.what);
  if (contact == nullptr) return {};
  const auto moments = ParseMomentFlags(contact->cnflag);
  return moments.ok() ? "" : moments.error();
}

BehaviorRunner::BehaviorRunner(BehaviorOptions options, std::unique_ptr<Behavior> behavior,
                               BehaviorOrigin origin)
    : options_(std::move(options)), behavior_(std::move(behavior)), origin_(std::move(origin)) {
  Parse();
}

void BehaviorRunner::Parse() {
  const std::string problem = Problem(options_);
  SHOAL_CHECK(problem.empty(), "conditions and flags of a behavior are checked before it starts");
  conditions_ = *ParseConditions(ConditionsOf(options_));
  const BehaviorFlags& texts = options_.flags;
  flags_ = {*ParseFlags(texts.runflag),      *ParseFlags(texts.runxflag),
            *ParseFlags(texts.idleflag),     *ParseFlags(texts.activeflag),
            *ParseFlags(texts.inactiveflag), *ParseFlags(texts.endflag),
            *ParseFlags(texts.spawnflag),    *ParseFlags(texts.spawnxflag),
            *ParseFlags(texts.configflag)};
  own_flags_.clear();
  const ContactOptions* contact = ContactOptionsOf(options_.what);
  if (contact != nullptr) moment_flags_ = *ParseMomentFlags(contact->cnflag);
}

void BehaviorRunner::FireMoments(const BehaviorInputs& inputs, HelmNotes& notes) {
  if (moment_flags_.empty()) return;
  const auto contact = inputs.contacts->find(ContactOptionsOf(options_.what)->contact);
  if (contact == inputs.contacts->end()) return moments_.Forget();
  for (const Flag* flag : moments_.Update(inputs.own.motion, contact->second.now, moment_flags_)) {
    Fire({*flag}, inputs, notes);
  }
}

std::optional<std::string> BehaviorRunner::MacroValue(std::string_view name,
                                                      const BehaviorInputs& inputs) {
  if (name == "BHVNAME") return options_.name;
  if (name == "BHVTYPE") return std::string(KindOf(options_.what));
  if (name == "PWT") return TextOf(options_.pwt);
  if (name == "UTC" || name == "NOW") return Rounded(inputs.time_s);
  const VesselMotion& own = inputs.own.motion;
  if (name == "OSX") return Rounded(own.position_m.x());
  if (name == "OSY") return Rounded(own.position_m.y());
  if (name == "OSH") return Rounded(own.heading_deg);
  if (name == "OSV" || name == "OSS") return Rounded(own.speed_mps);
  if (name == "OSD") return Rounded(inputs.own.depth_m);
  if (name == "STATE_TIME") return Rounded(inputs.time_s - state_since_s_);
  if (name.starts_with("CTR") && name.size() <= 4 &&
      (name.size() == 3 || (name[3] >= '1' && name[3] <= '5'))) {
    auto found = counters_.find(name);
    if (found == counters_.end()) found = counters_.emplace(name, 0).first;
    return std::to_string(++found->second);
  }
  AnyBehavior what = options_.what;
  const std::string* contact_name = ContactOf(what);
  if (contact_name == nullptr) return std::nullopt;
  if (name == "CONTACT") return *contact_name;
  const auto contact = inputs.contacts->find(*contact_name);
  if (contact == inputs.contacts->end()) return std::nullopt;
  const VesselMotion& theirs = contact->second.now;
  const RelativeGeometry geometry = GeometryOf(own, theirs);
  if (name == "CNX") return Rounded(theirs.position_m.x());
  if (name == "CNY") return Rounded(theirs.position_m.y());
  if (name == "CNH") return Rounded(theirs.heading_deg);
  if (name == "CNV" || name == "CNS") return Rounded(theirs.speed_mps);
  if (name == "RANGE") return Rounded(geometry.range_m);
  if (name == "ROC") return Rounded(-geometry.range_rate_mps);
  if (name == "RELBNG") return Rounded(geometry.beta_deg);
  if (name == "CPA") return Rounded(geometry.cpa_m);
  if (name == "AGE") return Rounded(contact->second.age_s);
  return std::nullopt;
}

void BehaviorRunner::Fire(const std::vector<Flag>& flags, const BehaviorInputs& inputs,
                          HelmNotes& notes) {
  for (const Flag& flag : flags) {
    auto posts = flag.Fire(*inputs.variables,
                           [&](std::string_view name) { return MacroValue(name, inputs); });
    for (VariablePost& post : posts) {
      const Variables::Entry* entry = inputs.variables->Find(post.variable);
      const bool changes = entry == nullptr || entry->value != post.value;
      if (changes || !post.destination.empty()) {
        notes.events.push_back(
            {"flag", options_.name + ": " + post.variable + " = " + TextOf(post.value) +
                         (post.destination.empty() ? "" : " to " + post.destination)});
      }
      notes.posts.push_back(std::move(post));
    }
  }
}

void BehaviorRunner::FireOwn(const std::string& name, const BehaviorInputs& inputs,
                             HelmNotes& notes) {
  auto known = own_flags_.find(name);
  if (known == own_flags_.end()) {
    const std::vector<std::string>* texts = OwnFlags(options_.what, name);
    SHOAL_CHECK(texts != nullptr, "a behavior fires only lists of flags that its options have");
    known = own_flags_.emplace(name, *ParseFlags(*texts)).first;
  }
  Fire(known->second, inputs, notes);
}

void BehaviorRunner::Report(const std::vector<VariablePost>& posts, HelmNotes& notes) {
  for (const VariablePost& post : posts) {
    const auto last = reported_.find(post.variable);
    if (last != reported_.end() && last->second == post.value) continue;
    reported_[post.variable] = post.value;
    notes.posts.push_back(post);
  }
}

void BehaviorRunner::Warn(const std::string& warning, HelmNotes& notes) {
  if (!warning.empty() && warning != last_warning_) {
    notes.warnings.push_back(options_.name + ": " + warning);
  }
  last_warning_ = warning;
}

void BehaviorRunner::Enter(RunState state, HelmNotes& notes) {
  if (state == state_) return;
  notes.events.push_back({"state", options_.name + ": " + std::string(Name(state_)) + " -> " +
                                       std::string(Name(state))});
  state_ = state;
  state_since_s_ = last_time_s_;
}

void BehaviorRunner::Update(const std::string& text, std::span<const UpdateItem> items,
                            const ReadUpdate& read, const BehaviorInputs& inputs,
                            HelmNotes& notes) {
  if (text == last_update_ && !MayBeRepeated(text)) return;
  auto updated = read(options_, items, inputs.own.motion.position_m);
  std::string problem = updated.ok() ? Problem(*updated) : updated.error();
  if (!problem.empty()) {
    notes.warnings.push_back(options_.name + ": update '" + text + "' changes nothing: " + problem);
    return;
  }
  last_update_ = text;
  const bool is_other_behavior = options_.what != updated->what;
  options_ = std::move(*updated);
  Parse();
  if (is_other_behavior) Reconfigure(*behavior_, options_.what);
  notes.events.push_back({"update", options_.name + ": " + text});
  Fire(flags_.config, inputs, notes);
}

bool BehaviorRunner::ConditionsHold(const BehaviorInputs& inputs) const {
  if (is_disabled_) return false;
  if (inputs.goals_rest && !behavior_->is_constraint()) return false;
  if (!AllHold(conditions_, *inputs.variables)) return false;
  return std::all_of(
      options_.nostarve.begin(), options_.nostarve.end(), [&](const std::string& variable) {
        const Variables::Entry* entry = inputs.variables->Find(variable);
        return entry != nullptr && inputs.time_s - entry->set_s <= options_.nostarve_s;
      });
}

void BehaviorRunner::CountTime(const BehaviorInputs& inputs, HelmNotes& notes) {
  const double passed_s = inputs.time_s - last_time_s_;
  last_time_s_ = inputs.time_s;
  if (!options_.duration) return;
  if (!options_.duration_reset.empty()) {
    const std::string& text = options_.duration_reset;
    const size_t sign = text.find('=');
    const std::string variable(Trimmed(std::string_view(text).substr(0, sign)));
    const Variables::Entry* entry = inputs.variables->Find(variable);
    const auto resets = [&](const VariableValue& value) {
      if (sign == std::string::npos) return true;
      return TextOf(value) == TextOf(ValueIn(std::string_view(text).substr(sign + 1)));
    };
    if (entry != nullptr && std::any_of(entry->fresh.begin(), entry->fresh.end(), resets)) {
      if (used_s_) used_s_ = 0;
      return;
    }
  }
  const bool ran = state_ == RunState::kRunning || state_ == RunState::kActive;
  if (used_s_ && (ran || options_.duration_idle_decay)) *used_s_ += passed_s;
  if (!options_.duration_status.empty()) {
    const double left_s = std::max(0.0, *options_.duration - used_s_.value_or(0));
    Report({{options_.duration_status, RoundedRemaining(left_s)}}, notes);
  }
}

void BehaviorRunner::Publish(const BehaviorAnswer& answer, const BehaviorInputs& inputs,
                             HelmNotes& notes) {
  Report(answer.posts, notes);
  for (const std::string& name : answer.flags) FireOwn(name, inputs, notes);
  Warn(answer.warning, notes);
}

RunReport BehaviorRunner::Idle(const BehaviorInputs& inputs, HelmNotes& notes) {
  RunReport report = {.options = &options_, .state = RunState::kIdle};
  const bool is_entered = state_ != RunState::kIdle;
  moments_.Forget();
  report.answer = behavior_->Idle(inputs);
  report.answer.objective.reset();
  Publish(report.answer, inputs, notes);
  if (is_entered) {
    Fire(flags_.idle, inputs, notes);
    Fire(flags_.inactive, inputs, notes);
    Enter(RunState::kIdle, notes);
  }
  return report;
}

void BehaviorRunner::FireEndFlags(const std::string& reason, const BehaviorInputs& inputs,
                                  HelmNotes& notes) {
  notes.events.push_back(
      {"end", options_.name + ": completed" + (reason.empty() ? "" : ", " + reason)});
  Fire(flags_.end, inputs, notes);
  used_s_.reset();
}

RunReport BehaviorRunner::End(const std::string& reason, const BehaviorInputs& inputs,
                              HelmNotes& notes) {
  RunReport report = {
      .options = &options_, .state = RunState::kCompleted, .answer = behavior_->Complete(inputs)};
  report.answer.objective.reset();
  Publish(report.answer, inputs, notes);
  FireEndFlags(reason, inputs, notes);
  return report;
}

RunReport BehaviorRunner::Run(const BehaviorInputs& inputs, HelmNotes& notes) {
  const RunState before = state_;
  if (!used_s_) used_s_ = 0;
  RunReport report = {.options = &options_,
                      .state = RunState::kRunning,
                      .answer = behavior_->Run(inputs),
                      .is_constraint = behavior_->is_constraint()};
  BehaviorAnswer& answer = report.answer;
  if (answer.objective &&
      (!std::isfinite(answer.relevance) || !IsSound(*answer.objective, *inputs.domain))) {
    answer.objective.reset();
    if (answer.error.empty()) answer.error = "its preferences are not finite numbers";
  }
  if (answer.objective) {
    report.weight = options_.pwt * std::clamp(answer.relevance, 0.0, 1.0) * answer.urgency;
  }
  if (report.weight > 0) {
    report.state = RunState::kActive;
  } else {
    answer.objective.reset();
  }
  if (before == RunState::kIdle || before == RunState::kNew) Fire(flags_.run, inputs, notes);
  Fire(flags_.runx, inputs, notes);
  if (report.state == RunState::kActive && before != RunState::kActive) {
    Fire(flags_.active, inputs, notes);
  }
  if (report.state != RunState::kActive && before == RunState::kActive) {
    Fire(flags_.inactive, inputs, notes);
  }
  Publish(answer, inputs, notes);
  FireMoments(inputs, notes);
  Enter(report.state, notes);
  return report;
}

RunReport BehaviorRunner::Iterate(const BehaviorInputs& inputs, const std::string& end_reason,
                                  HelmNotes& notes) {
  const bool is_first = state_ == RunState::kNew;
  if (is_first) {
    last_time_s_ = inputs.time_s;
    state_since_s_ = inputs.time_s;
    Fire(flags_.spawn, inputs, notes);
    Fire(flags_.config, inputs, notes);
  }
  CountTime(inputs, notes);
  RunReport report;
  if (!end_reason.empty()) {
    report = End(end_reason, inputs, notes);
    is_over_ = true;
  } else if (!ConditionsHold(inputs)) {
    report = Idle(inputs, notes);
  } else if (options_.duration && used_s_ && *used_s_ >= *options_.duration) {
    report = End("its duration is over", inputs, notes);
    is_over_ = !options_.perpetual;
  } else {
    report = Run(inputs, notes);
    if (report.answer.completes) {
      FireEndFlags("", inputs, notes);
      is_over_ = !options_.perpetual;
      report.state = RunState::kCompleted;
    }
  }
  if (is_first) Fire(flags_.spawnx, inputs, notes);
  return report;
}

}  // namespace shoal
