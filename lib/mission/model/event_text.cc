#include "lib/mission/model/event_text.h"

#include <fmt/format.h>

namespace shoal {

namespace {

struct EventWriter {
  std::string operator()(const CommandEvent& event) const {
    return fmt::format("{} to {}", event.command, event.vehicle);
  }
  std::string operator()(const SimCommandEvent& event) const {
    return fmt::format("{} to the simulator of {}", event.command, event.vehicle);
  }
  std::string operator()(const RuleEvent& event) const {
    std::string text = event.rule;
    if (!event.vehicle.empty()) text += " of " + event.vehicle;
    const ControlRow* row = FindControl(event.rule);
    if (row != nullptr && row->type != ControlType::kRequest) {
      text += " = " + ControlWord(*row, event.value);
    }
    return text;
  }
  std::string operator()(const MessageEvent& event) const {
    return fmt::format("{} of {} to {}{}", event.var_name, event.src_node, event.dest_node,
                       event.dest_group.empty() ? "" : " group " + event.dest_group);
  }
};

struct VehicleFinder {
  template <class T>
  std::string operator()(const T& event) const {
    return event.vehicle;
  }
  std::string operator()(const MessageEvent& event) const { return event.src_node; }
};

}  // namespace

std::string EventText(const Event& event) { return std::visit(EventWriter(), event.what); }

std::string VehicleOf(const Event& event) { return std::visit(VehicleFinder(), event.what); }

}  // namespace shoal
