// Surveys that are divided among vehicles: which share is whose, and whether each of them does its
// own.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

/// Vehicles by their names in lower case: in the order of the shares.
using Members = std::map<std::string, const Vehicle*>;

/// What is the same for all members of one survey, so that a large group is checked once.
class Divider {
 public:
  explicit Divider(const Mission& mission) : mission_(mission) {}

  void Divide(const Vehicle& vehicle, const TablePlace& place, SurveyTask* task) {
    const Survey& survey = SurveyOf(*task);
    const auto own = survey.members.find(LowerCase(vehicle.name));
    if (own == survey.members.end()) {
      place.Refuse("divide_among", fmt::format("{} itself is not among them", vehicle.name));
      return;
    }
    task->share = {.place = static_cast<size_t>(std::distance(survey.members.begin(), own)),
                   .members = survey.members.size()};
    if (survey.num_lanes < survey.members.size()) {
      place.Refuse("divide_among", fmt::format("{} vehicles cannot share {} lane{}: lower "
                                               "lane_spacing_m, or leave vehicles out",
                                               survey.members.size(), survey.num_lanes,
                                               survey.num_lanes == 1 ? "" : "s"));
    } else if (survey.idle != nullptr) {
      place.Refuse(
          "divide_among",
          fmt::format("{} has no survey like this one, so that its share would be left out: "
                      "give it a task with the same polygon, lane_spacing_m, "
                      "lane_angle_deg, lane_ends and divide_among",
                      survey.idle->name));
    }
  }

 private:
  struct Survey {
    SurveyArea area;
    const Members& members;
    size_t num_lanes = 0;
    const Vehicle* idle = nullptr;  ///< A member that does not take part; null: there is none.
  };

  const Members& MembersOf(const SurveyTask& task) {
    const auto [found, is_new] = members_.try_emplace(task.divide_among);
    if (!is_new) return found->second;
    for (const std::string& name : task.divide_among) {
      for (const Vehicle* vehicle : mission_.VehiclesNamed(name)) {
        found->second.emplace(LowerCase(vehicle->name), vehicle);
      }
    }
    return found->second;
  }

  bool IsOf(const SurveyTask& task, const SurveyArea& area, const Members& members) {
    if (task.area != area) return false;
    const Members& others = MembersOf(task);
    return &others == &members || others == members;
  }

  bool TakesPart(const Vehicle& member, const SurveyArea& area, const Members& members) {
    return std::any_of(member.tasks.begin(), member.tasks.end(), [&](const Task& task) {
      const auto* survey = std::get_if<SurveyTask>(&task.what);
      return survey != nullptr && IsOf(*survey, area, members);
    });
  }

  const Survey& SurveyOf(const SurveyTask& task) {
    for (const Survey& known : surveys_) {
      if (IsOf(task, known.area, known.members)) return known;
    }
    Survey& survey = surveys_.emplace_back(Survey{
        .area = task.area, .members = MembersOf(task), .num_lanes = LanesOver(task.area).size()});
    for (const auto& [key, member] : survey.members) {
      if (survey.idle == nullptr && !TakesPart(*member, survey.area, survey.members)) {
        survey.idle = member;
      }
    }
    return survey;
  }

  const Mission& mission_;
  std::map<std::vector<std::string>, Members> members_;  ///< By what divide_among holds.
  std::deque<Survey> surveys_;
};

}  // namespace

void ResolveSurveyShares(Mission& mission, const TablePlace& file) {
  const auto for_each = [&](const auto& act) {
    for (size_t i = 0; i < mission.vehicles.size(); ++i) {
      Vehicle& vehicle = mission.vehicles[i];
      for (size_t k = 0; k < vehicle.tasks.size(); ++k) {
        auto* survey = std::get_if<SurveyTask>(&vehicle.tasks[k].what);
        if (survey == nullptr || survey->divide_among.empty() || survey->area.polygon_m.empty()) {
          continue;
        }
        act(vehicle, file.Below("vehicle", i).Below("task", k), survey);
      }
    }
  };
  for_each([&](const Vehicle&, const TablePlace& place, SurveyTask* survey) {
    for (std::string& name : survey->divide_among) {
      ResolveAddressees(place, "divide_among", name, mission);
    }
  });
  Divider divider(mission);
  for_each([&](const Vehicle& vehicle, const TablePlace& place, SurveyTask* survey) {
    if (place.IsSound()) divider.Divide(vehicle, place, survey);
  });
}

}  // namespace shoal
