#include "lib/helm/behaviors/behavior_set.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/helm/behaviors/contact_recipe.h"
#include "lib/helm/behaviors/reported_variables.h"
#include "lib/helm/decision/decide.h"
#include "lib/helm/decision/shapes.h"
#include "lib/helm/modes/condition.h"
#include "lib/helm/modes/value_text.h"

namespace shoal {
namespace {

constexpr double kSpeedBelowTask_mps = 1.6;  // Over which a task's aim falls off, as waypoint's.

const Contacts kNoContacts;
const std::vector<Obstacle> kNoObstacles;

bool StartsSpawning(const BehaviorOptions& options) {
  return options.templating != Templating::kNone;
}

std::unique_ptr<Behavior> Make(const HelmSetup& setup, const BehaviorOptions& options) {
  return setup.make ? setup.make(options) : MakeBehavior(options);
}

/// Splits the item `name` off an update.
std::optional<std::string> TakeName(std::vector<UpdateItem>& items) {
  const auto found = std::find_if(items.begin(), items.end(),
                                  [](const UpdateItem& item) { return item.key == "name"; });
  if (found == items.end()) return std::nullopt;
  std::string name = std::move(found->value);
  items.erase(found);
  return name;
}

HelmPoint PointOf(const DomainPoint& point, const Domain& domain) {
  HelmPoint values;
  if (point.course) values.course_deg = *point.course;
  if (point.speed) values.speed_mps = domain.speed_mps.At(*point.speed);
  if (point.depth) values.depth_m = domain.depth_m.At(*point.depth);
  return values;
}

int NearestCourse(double course_deg) {
  const int course = static_cast<int>(std::ceil(course_deg - 0.5)) % Domain::kNumCourses;
  return course < 0 ? course + Domain::kNumCourses : course;
}

/// Returns true where what a behavior allows excludes a point.
bool Excludes(const AllowedPart& allowed, const DomainPoint& point) {
  const bool excludes_speed = point.course && point.speed && !allowed.speeds.empty() &&
                              !allowed.speeds[static_cast<size_t>(*point.course)].Has(*point.speed);
  return excludes_speed || (point.depth && allowed.depths && !allowed.depths->Has(*point.depth));
}

std::string WordsOf(const HelmPoint& point) {
  const auto rounded = [](double value) {
    return TextOf(VariableValue(std::round(value * 100) / 100));
  };
  std::string words;
  if (point.course_deg) words += " course " + rounded(*point.course_deg) + " deg";
  if (point.speed_mps) words += " speed " + rounded(*point.speed_mps) + " m/s";
  if (point.depth_m) words += " depth " + rounded(*point.depth_m) + " m";
  return words;
}

/// Returns true where the decision is what the task commands alone, as near as the grid has it.
bool IsNearest(const DomainPoint& point, const TaskAim& task, const Domain& domain) {
  if (!point.speed || *point.speed != domain.speed_mps.Nearest(task.speed_mps)) return false;
  if (point.depth && task.depth_m && *point.depth != domain.depth_m.Nearest(*task.depth_m)) {
    return false;
  }
  return *point.speed == 0 || (point.course && *point.course == NearestCourse(task.course_deg));
}

}  // namespace

Objective ObjectiveOf(const TaskAim& task, const Domain& domain) {
  std::vector<double> speed;
  if (domain.speed_mps.count > 0) {
    const double summit = domain.speed_mps.At(domain.speed_mps.Nearest(task.speed_mps));
    speed = PeakOverAxis(domain.speed_mps, summit, 0, std::max(summit, kSpeedBelowTask_mps));
  }
  Objective objective;
  if (task.speed_mps > 0 && !speed.empty()) {
    objective = Couple(PeakOverCourse(NearestCourse(task.course_deg), 0, 180), speed, 50, 50);
  } else if (!speed.empty()) {
    objective.speed = speed;
    objective = NormaliseTo100(std::move(objective), domain);
  }
  if (task.depth_m && domain.depth_m.count > 0) {
    const double summit = domain.depth_m.At(domain.depth_m.Nearest(*task.depth_m));
    const double reach =
        std::max(std::abs(domain.depth_m.Last() - domain.depth_m.first), domain.depth_m.step);
    objective.depth = PeakOverAxis(domain.depth_m, summit, 0, reach);
    for (double& value : objective.depth) value /= objective.scale;
    objective = NormaliseTo100(std::move(objective), domain);
  }
  return objective;
}

/// A behavior of the file that is only copied, and what it was copied for.
struct BehaviorSet::Recipe {
  BehaviorOptions options;
  int num_spawned = 0;
  bool is_exhausted = false;            ///< max_spawnings was reached, and a warning given.
  std::set<std::string> on_alert = {};  ///< Contacts or obstacles in its range.
};

/// What the steps of one iteration share.
struct BehaviorSet::Iteration {
  const BehaviorInputs& inputs;
  HelmNotes& notes;
};

namespace {

/// Adds the vessel's own variables that conditions name.
void AddOwnVariables(const HelmSetup& setup, Variables* variables) {
  const auto add = [&](const std::vector<std::string>& conditions) {
    for (const std::string& text : conditions) {
      const auto condition = Condition::Parse(text);
      if (!condition.ok()) continue;
      const std::vector<std::string> used = condition->VariablesUsed();
      for (const OwnVariable& own : kOwnVariables) {
        if (std::find(used.begin(), used.end(), own.name) != used.end()) {
          variables->Set(own.name, 0.0, 0);
        }
      }
    }
  };
  for (const ModeOptions& mode : setup.modes) add(mode.condition);
  for (const BehaviorOptions& behavior : setup.behaviors) add(ConditionsOf(behavior));
}

}  // namespace

BehaviorSet::BehaviorSet(HelmSetup setup) : setup_(std::move(setup)) {
  auto modes = ModeTree::Parse(setup_.modes);
  SHOAL_CHECK(modes.ok(), "modes of a helm are checked before it starts");
  modes_ = std::move(*modes);
  for (const auto& [variable, value] : setup_.variables) variables_.Set(variable, value, 0);
  AddOwnVariables(setup_, &variables_);
  for (const BehaviorOptions& options : setup_.behaviors) {
    if (StartsSpawning(options)) recipes_.push_back({.options = options});
    if (options.templating == Templating::kSpawn) continue;
    runners_.push_back(
        std::make_unique<BehaviorRunner>(options, Make(setup_, options), BehaviorOrigin{}));
  }
}

BehaviorSet::~BehaviorSet() = default;
BehaviorSet::BehaviorSet(BehaviorSet&&) noexcept = default;
BehaviorSet& BehaviorSet::operator=(BehaviorSet&&) noexcept = default;

std::vector<std::string> BehaviorSet::Names() const {
  std::vector<std::string> names;
  names.reserve(runners_.size());
  for (const auto& runner : runners_) names.push_back(runner->options().name);
  return names;
}

bool BehaviorSet::HasRunnerNamed(std::string_view name) const {
  return std::any_of(runners_.begin(), runners_.end(),
                     [&](const auto& runner) { return runner->options().name == name; });
}

void BehaviorSet::TakeSettings(const HelmInputs& inputs, HelmOutcome& outcome) {
  for (const ReceivedSetting& setting : inputs.settings) {
    if (variables_.Set(setting.variable, setting.value, inputs.time_s)) continue;
    outcome.warnings.push_back(
        "the setting " + setting.variable + " = " + TextOf(setting.value) + " of " +
        setting.source + " was refused: " + variables_.WhyNot(setting.variable, setting.value));
  }
}

void BehaviorSet::Spawn(Recipe& recipe, BehaviorOptions options, const BehaviorOrigin& origin,
                        const Iteration& now) {
  if (recipe.num_spawned >= recipe.options.max_spawnings) {
    if (!recipe.is_exhausted) {
      now.notes.warnings.push_back(recipe.options.name + ": max_spawnings = " +
                                   std::to_string(recipe.options.max_spawnings) + " is reached; " +
                                   options.name + " does not begin");
    }
    recipe.is_exhausted = true;
    return;
  }
  const std::string problem = Problem(options);
  if (!problem.empty()) {
    now.notes.warnings.push_back(options.name + " does not begin: " + problem);
    return;
  }
  ++recipe.num_spawned;
  options.templating = Templating::kNone;
  now.notes.events.push_back({"spawn", options.name});
  // Behind what the recipe, or one after it in the file, has made already: the file's order.
  const auto place_of = [&](const std::string& name) {
    return std::find_if(setup_.behaviors.begin(), setup_.behaviors.end(),
                        [&](const BehaviorOptions& each) { return each.name == name; });
  };
  const auto own_place = place_of(recipe.options.name);
  const auto before = std::find_if(runners_.begin(), runners_.end(), [&](const auto& runner) {
    const std::string& recipe_name = runner->origin().recipe;
    return place_of(recipe_name.empty() ? runner->options().name : recipe_name) > own_place;
  });
  auto behavior = Make(setup_, options);
  runners_.insert(
      before, std::make_unique<BehaviorRunner>(std::move(options), std::move(behavior), origin));
}

void BehaviorSet::SpawnForContacts(const Iteration& now) {
  for (Recipe& recipe : recipes_) {
    const auto range = AlertRangeOf(recipe.options.what);
    if (!range) continue;
    const ContactOptions& filter = *ContactOptionsOf(recipe.options.what);
    std::erase_if(recipe.on_alert,
                  [&](const std::string& name) { return !now.inputs.contacts->contains(name); });
    for (const auto& [name, contact] : *now.inputs.contacts) {
      const bool alerts =
          Passes(filter, contact) && IsAlert(*range, now.inputs.own.motion, contact.now);
      if (!alerts) {
        recipe.on_alert.erase(name);
      } else if (recipe.on_alert.insert(name).second) {
        BehaviorOptions options = recipe.options;
        options.name += name;
        *ContactOf(options.what) = name;
        if (HasRunnerNamed(options.name)) continue;
        Spawn(recipe, std::move(options), {.recipe = recipe.options.name, .contact = name}, now);
      }
    }
  }
}

void BehaviorSet::SpawnForObstacles(const Iteration& now) {
  for (Recipe& recipe : recipes_) {
    const auto* avoid = std::get_if<AvoidObstacleOptions>(&recipe.options.what);
    if (avoid == nullptr) continue;
    for (const Obstacle& obstacle : *now.inputs.obstacles) {
      const double distance_m = DistanceTo(obstacle.polygon_m, now.inputs.own.motion.position_m);
      if (distance_m > avoid->pwt_outer_dist) {
        recipe.on_alert.erase(obstacle.id);
      } else if (recipe.on_alert.insert(obstacle.id).second) {
        BehaviorOptions options = recipe.options;
        options.name += obstacle.id;
        auto& own = std::get<AvoidObstacleOptions>(options.what);
        own.id = obstacle.id;
        own.polygon = obstacle.polygon_m;
        if (HasRunnerNamed(options.name)) continue;
        Spawn(recipe, std::move(options), {.recipe = recipe.options.name, .obstacle = obstacle.id},
              now);
      }
    }
  }
}

/// "contact = henry # action = disable": behaviors that can be disabled rest while it holds.
void BehaviorSet::TakeAbleFilter(HelmNotes* notes) {
  constexpr size_t kMaxDisabled = 1000;
  const Variables::Entry* filter = variables_.Find("BHV_ABLE_FILTER");
  if (filter == nullptr) return;
  for (const VariableValue& value : filter->fresh) {
    std::string text = TextOf(value);
    std::replace(text.begin(), text.end(), ',', '#');
    std::string contact;
    std::string action;
    const auto items = ParseUpdate(text);
    if (items.ok()) {
      for (const UpdateItem& item : *items) {
        if (item.key == "contact") contact = item.value;
        if (item.key == "action") action = item.value;
      }
    }
    if (contact.empty() || (action != "disable" && action != "enable")) {
      notes->warnings.push_back("BHV_ABLE_FILTER = " + TextOf(value) +
                                ": write contact = NAME, action = disable or enable");
    } else if (action == "enable") {
      disabled_contacts_.erase(contact);
    } else if (disabled_contacts_.size() < kMaxDisabled) {
      disabled_contacts_.insert(contact);
    }
  }
}

void BehaviorSet::ApplyUpdate(const std::string& variable, const std::string& text,
                              const Iteration& now) {
  auto items = ParseUpdate(text);
  if (!items.ok()) {
    now.notes.warnings.push_back("update of " + variable + ": " + items.error());
    return;
  }
  if (!setup_.read_update) {
    now.notes.warnings.push_back("update of " + variable + ": this helm takes no updates");
    return;
  }
  const std::optional<std::string> name = TakeName(*items);
  bool is_taken = false;
  for (const auto& runner : runners_) {
    const BehaviorOptions& options = runner->options();
    if (options.updates != variable) continue;
    if (name && options.name != *name && options.name != runner->origin().recipe + *name) continue;
    runner->Update(text, *items, setup_.read_update, now.inputs, now.notes);
    is_taken = true;
  }
  if (is_taken || !name) return;
  for (Recipe& recipe : recipes_) {
    if (recipe.options.updates != variable) continue;
    BehaviorOptions options = recipe.options;
    options.name += *name;
    auto updated = setup_.read_update(options, *items, now.inputs.own.motion.position_m);
    if (!updated.ok()) {
      now.notes.warnings.push_back(options.name + " does not begin: " + updated.error());
      return;
    }
    BehaviorOrigin origin = {.recipe = recipe.options.name};
    const std::string* contact = ContactOf(updated->what);
    if (contact != nullptr) origin.contact = *contact;
    Spawn(recipe, std::move(*updated), origin, now);
    return;
  }
  now.notes.warnings.push_back("update of " + variable + ": no behavior is called " + *name);
}

void BehaviorSet::ApplyUpdates(const Iteration& now) {
  std::vector<std::string> done;
  for (const BehaviorOptions& options : setup_.behaviors) {
    const std::string& variable = options.updates;
    if (variable.empty() || std::find(done.begin(), done.end(), variable) != done.end()) continue;
    done.push_back(variable);
    const Variables::Entry* entry = variables_.Find(variable);
    if (entry == nullptr) continue;
    for (const VariableValue& value : entry->fresh) ApplyUpdate(variable, TextOf(value), now);
  }
}

HelmAim BehaviorSet::AimOf(const RunReport& report) {
  HelmAim aim;
  aim.name = report.options->name;
  aim.kind = KindOf(report.options->what);
  aim.state = Name(report.state);
  if (!report.answer.state.empty()) aim.state += ", " + report.answer.state;
  aim.is_constraint = report.is_constraint;
  aim.role = report.answer.role;
  aim.view = report.answer.view;
  return aim;
}

void BehaviorSet::Decide(const HelmInputs& inputs, const std::vector<RunReport>& reports,
                         HelmOutcome& outcome) {
  objectives_.clear();
  if (inputs.task) {
    objectives_.push_back({inputs.task->pwt, ObjectiveOf(*inputs.task, setup_.domain)});
    outcome.aims.push_back(
        {.name = inputs.task->name, .kind = inputs.task->kind, .state = "active"});
  }
  const size_t num_before = outcome.aims.size();
  std::vector<const AllowedPart*> limits;  // Of the aims from num_before on.
  AllowedPart allowed;
  bool has_goal = inputs.task.has_value();
  bool has_other = false;
  for (const RunReport& report : reports) {
    if (report.state != RunState::kRunning && report.state != RunState::kActive) continue;
    objectives_.push_back({report.weight, report.answer.objective.value_or(Objective())});
    outcome.aims.push_back(AimOf(report));
    limits.push_back(&report.answer.allowed);
    Restrict(&allowed, report.answer.allowed);
    if (report.state != RunState::kActive) continue;
    has_other = true;
    has_goal = has_goal || !report.is_constraint;
  }
  const bool only_task = inputs.task && !has_other;
  // Alone, a task without weight counts too.
  if (only_task && objectives_.front().weight <= 0) objectives_.front().weight = 1;

  decision_ = shoal::Decide(setup_.domain, objectives_, allowed);
  for (size_t i = 0; i < objectives_.size(); ++i) outcome.aims[i].weight = objectives_[i].weight;
  if (inputs.explains) Explain(&outcome);
  if (!only_task && !has_other) {
    outcome.all_stop = "NothingToDo";
  } else if (setup_.goals_mandatory && !has_goal) {
    outcome.all_stop = "NoGoalBehavior";
  } else if (!decision_.point.speed) {
    outcome.all_stop = "MissingDecVars:speed";
  } else if (!decision_.point.course && *decision_.point.speed > 0) {
    outcome.all_stop = "MissingDecVars:course";
  } else {
    outcome.has_decision = true;
    outcome.commands = PointOf(decision_.point, setup_.domain);
    outcome.utility = decision_.utility;
    outcome.only_task = only_task && !decision_.wanted;
    if (decision_.wanted) {
      outcome.wanted = PointOf(*decision_.wanted, setup_.domain);
      for (size_t i = 0; i < limits.size(); ++i) {
        if (!Excludes(*limits[i], *decision_.wanted)) continue;
        outcome.aims[num_before + i].state += ", excludes" + WordsOf(*outcome.wanted);
      }
    }
    outcome.is_task_point = inputs.task && IsNearest(decision_.point, *inputs.task, setup_.domain);
  }
}

void BehaviorSet::Explain(HelmOutcome* outcome) const {
  const auto shares = shoal::Explain(setup_.domain, objectives_, decision_);
  for (size_t i = 0; i < shares.size(); ++i) {
    HelmAim& aim = outcome->aims.at(i);
    if (aim.weight <= 0) continue;
    aim.best = PointOf(shares[i].best_point, setup_.domain);
    aim.value = shares[i].value;
    aim.loss = shares[i].loss;
  }
}

double BehaviorSet::UtilityAt(const HelmPoint& point) const {
  const auto nearest = [](const std::optional<double>& value, const Axis& axis) {
    return value && axis.count > 0 ? std::optional(axis.Nearest(*value)) : std::nullopt;
  };
  DomainPoint indices = {.speed = nearest(point.speed_mps, setup_.domain.speed_mps),
                         .depth = nearest(point.depth_m, setup_.domain.depth_m)};
  if (point.course_deg) indices.course = NearestCourse(*point.course_deg);
  double utility = 0;
  for (const auto& [weight, objective] : objectives_) {
    if (weight > 0) utility += weight * ValueOf(objective, indices);
  }
  return utility;
}

void BehaviorSet::JudgeAllStop(const std::string& error, HelmOutcome& outcome) {
  if (!error.empty()) outcome.all_stop = error;
  if (!lasting_error_.empty()) outcome.all_stop = lasting_error_;
  const bool is_error = !error.empty() || !lasting_error_.empty();
  if (is_error) {
    outcome.has_decision = false;
    outcome.only_task = false;
    outcome.is_task_point = false;
    outcome.commands = {};
  }
  iterations_without_decision_ = outcome.has_decision ? 0 : iterations_without_decision_ + 1;
  outcome.keeps_last = !is_error && iterations_without_decision_ == 1;
  if (outcome.all_stop == last_all_stop_) return;
  last_all_stop_ = outcome.all_stop;
  outcome.events.push_back({"all_stop", outcome.all_stop});
}

void BehaviorSet::TakePosts(double time_s, HelmOutcome& outcome) {
  variables_.ForgetFresh();
  for (const VariablePost& post : outcome.posts) {
    if (!post.destination.empty() || variables_.Set(post.variable, post.value, time_s)) continue;
    outcome.warnings.push_back("the flag " + post.variable + " = " + TextOf(post.value) +
                               " was refused: " + variables_.WhyNot(post.variable, post.value));
  }
}

HelmOutcome BehaviorSet::Iterate(const HelmInputs& inputs) {
  HelmOutcome outcome;
  objectives_.clear();
  decision_ = {};
  TakeSettings(inputs, outcome);
  if (!inputs.drives || !inputs.own) {
    outcome.keeps_last = true;
    iterations_without_decision_ = 0;
    commanded_ = {};
    return outcome;
  }
  for (const OwnVariable& own : kOwnVariables) {
    if (variables_.Find(own.name) == nullptr) continue;
    variables_.Set(own.name, own.value(*inputs.own), inputs.time_s);
  }
  HelmNotes notes;
  const BehaviorInputs own = {
      .time_s = inputs.time_s,
      .own = *inputs.own,
      .domain = &setup_.domain,
      .contacts = inputs.contacts != nullptr ? inputs.contacts : &kNoContacts,
      .obstacles = inputs.obstacles != nullptr ? inputs.obstacles : &kNoObstacles,
      .variables = &variables_,
      .last_course_deg = commanded_.course_deg,
      .last_speed_mps = commanded_.speed_mps,
      .avoids = avoids_,
      .goals_rest = inputs.goals_rest};
  const Iteration now = {own, notes};
  SpawnForContacts(now);
  SpawnForObstacles(now);
  ApplyUpdates(now);
  TakeAbleFilter(&notes);
  for (const auto& runner : runners_) {
    const auto* colregs = std::get_if<ColregsOptions>(&runner->options().what);
    if (colregs == nullptr || !colregs->can_disable) continue;
    runner->Disable(disabled_contacts_.contains(colregs->contact.contact));
  }
  for (const std::string& change : modes_.Apply(variables_, inputs.time_s)) {
    notes.events.push_back({"mode", change});
  }

  std::vector<RunReport> reports;
  reports.reserve(runners_.size());
  std::string error;
  for (const auto& runner : runners_) {
    reports.push_back(
        runner->Iterate(own, EndReason(runner->options(), runner->origin(), own), notes));
    const RunReport& report = reports.back();
    outcome.parks = outcome.parks || report.answer.parks;
    outcome.busy_s = std::max(outcome.busy_s, report.answer.busy_s);
    if (report.answer.crashes) outcome.crash = runner->options().name;
    if (report.answer.error.empty()) continue;
    const std::string reason =
        "BehaviorError:" + runner->options().name + ": " + report.answer.error;
    if (error.empty()) error = reason;
    if (runner->is_over() && lasting_error_.empty()) lasting_error_ = reason;
  }
  outcome.posts = std::move(notes.posts);
  outcome.events = std::move(notes.events);
  for (std::string& warning : notes.warnings) outcome.warnings.push_back(std::move(warning));
  Decide(inputs, reports, outcome);
  JudgeAllStop(error, outcome);
  commanded_ = outcome.commands;
  avoids_ = std::any_of(reports.begin(), reports.end(), [](const RunReport& report) {
    return report.state == RunState::kActive && report.is_constraint && report.answer.role;
  });
  TakePosts(inputs.time_s, outcome);
  std::erase_if(runners_, [](const auto& runner) { return runner->is_over(); });
  if (!modes_.variables().empty()) {
    const Variables::Entry* mode = variables_.Find(modes_.variables().front());
    if (mode != nullptr) outcome.mode = TextOf(mode->value);
  }
  return outcome;
}

void BehaviorSet::Clear() {
  lasting_error_.clear();
  for (const auto& runner : runners_) runner->Clear();
}

}  // namespace shoal
