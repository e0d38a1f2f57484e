// For tests of BehaviorSet: a helm whose behaviors answer what the test wants.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/base/text/numbers.h"
#include "lib/helm/behaviors/behavior_set.h"
#include "lib/helm/decision/shapes.h"
#include "lib/helm/modes/value_text.h"

namespace shoal {

/// Returns the answer of a behavior that wants a course and a speed.
inline BehaviorAnswer Wants(double course_deg, double speed_mps, double relevance = 1) {
  const Domain domain;
  BehaviorAnswer answer;
  answer.objective = Couple(PeakOverCourse(course_deg, 0, 180),
                            PeakOverAxis(domain.speed_mps, speed_mps, 0, 4), 50, 50);
  answer.relevance = relevance;
  return answer;
}

inline BehaviorAnswer Wants90(const BehaviorInputs&) { return Wants(90, 2); }

/// Reads "speed = 2" of a waypoint, "pwt = 50" and "condition = ..."; others are refused.
inline Result<BehaviorOptions> ReadSpeed(const BehaviorOptions& options,
                                         std::span<const UpdateItem> items,
                                         const Eigen::Vector2d&) {
  BehaviorOptions updated = options;
  for (const UpdateItem& item : items) {
    if (item.key == "speed") {
      std::get<WaypointOptions>(updated.what).speed = NumberIn(item.value).value_or(-1);
    } else if (item.key == "pwt") {
      updated.pwt = NumberIn(item.value).value_or(-1);
    } else if (item.key == "condition") {
      updated.condition = {item.value};
    } else {
      return Error{"unknown key '" + item.key + "'"};
    }
  }
  return updated;
}
class TestHelm {
 public:
  using Answer = std::function<BehaviorAnswer(const BehaviorInputs&)>;

  HelmSetup setup = {.vehicle = "alpha"};
  std::map<std::string, Answer> answers;     ///< By the behavior's name; else: runs, wants nothing.
  std::map<std::string, int> reconfigured;   ///< How often.
  std::map<std::string, int> num_completed;  ///< From outside.
  Contacts contacts;
  std::vector<Obstacle> obstacles;
  std::optional<TaskAim> task;
  OwnMotion own;
  double time_s = 0;
  bool drives = true;
  bool has_nav = true;

  /// Adds a behavior of the kind of `what`.
  BehaviorOptions& Add(const std::string& name, AnyBehavior what = WaypointOptions()) {
    setup.behaviors.push_back({.name = name, .what = std::move(what)});
    return setup.behaviors.back();
  }

  HelmOutcome Tick(std::vector<ReceivedSetting> settings = {}) {
    if (!set) Start();
    HelmInputs inputs = {.time_s = time_s,
                         .drives = drives,
                         .contacts = &contacts,
                         .obstacles = &obstacles,
                         .settings = std::move(settings),
                         .task = task};
    if (has_nav) inputs.own = own;
    time_s += 0.25;
    return set->Iterate(inputs);
  }
  HelmOutcome TickWith(const std::string& variable, const std::string& value) {
    return Tick({{variable, ValueIn(value), "test"}});
  }
  /// Ticks for that long; returns the last outcome.
  HelmOutcome TickFor(double seconds) {
    HelmOutcome outcome;
    for (int i = 0; i < static_cast<int>(seconds / 0.25 + 0.5); ++i) outcome = Tick();
    return outcome;
  }

  std::string ValueOf(const std::string& variable) const {
    const Variables::Entry* entry = set->variables().Find(variable);
    return entry == nullptr ? "" : TextOf(entry->value);
  }
  bool Has(const std::string& name) const {
    const std::vector<std::string> names = set->Names();
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  std::optional<BehaviorSet> set;

 private:
  template <class Options>
  class Scripted final : public BehaviorWith<Options> {
   public:
    Scripted(TestHelm& helm, std::string name, const Options& options)
        : BehaviorWith<Options>(options), helm_(helm), name_(std::move(name)) {}
    BehaviorAnswer Run(const BehaviorInputs& inputs) override {
      const auto answer = helm_.answers.find(name_);
      return answer == helm_.answers.end() ? BehaviorAnswer() : answer->second(inputs);
    }
    BehaviorAnswer Complete(const BehaviorInputs&) override {
      ++helm_.num_completed[name_];
      return {};
    }
    void Reconfigure(const Options& options) override {
      BehaviorWith<Options>::Reconfigure(options);
      ++helm_.reconfigured[name_];
    }
    bool is_constraint() const override { return name_.starts_with("limit"); }

   private:
    TestHelm& helm_;
    std::string name_;
  };

  void Start() {
    setup.make = [this](const BehaviorOptions& options) {
      return std::visit(
          [&]<class Options>(const Options& what) -> std::unique_ptr<Behavior> {
            return std::make_unique<Scripted<Options>>(*this, options.name, what);
          },
          options.what);
    };
    set.emplace(setup);
  }
};

/// Returns a contact at a place, that rests.
inline ContactView ContactAt(const std::string& name, double x_m, double y_m) {
  ContactView contact = {.name = name};
  contact.reported.position_m = {x_m, y_m};
  contact.now = contact.reported;
  return contact;
}

inline bool HasEvent(const HelmOutcome& outcome, const std::string& kind, const std::string& text) {
  return std::find(outcome.events.begin(), outcome.events.end(), HelmEvent{kind, text}) !=
         outcome.events.end();
}

}  // namespace shoal
