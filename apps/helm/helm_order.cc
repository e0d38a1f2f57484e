#include "apps/helm/helm_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/helm/modes/flag.h"
#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

enum class Argument { kNone, kTask, kReason, kSetting };

struct Grammar {
  std::string_view word;
  size_t num_values;
  Argument argument;
};

/// Two values for each of one or more points.
constexpr size_t kPoints = std::numeric_limits<size_t>::max();

// In the order of OrderKind.
constexpr EnumTable<OrderKind, Grammar> kGrammar = {
    Grammar{"deploy", 0, Argument::kNone},       Grammar{"return", 0, Argument::kNone},
    Grammar{"station_keep", 0, Argument::kNone}, Grammar{"all_stop", 0, Argument::kReason},
    Grammar{"resume", 0, Argument::kNone},       Grammar{"park", 0, Argument::kNone},
    Grammar{"goto", 2, Argument::kNone},         Grammar{"speed", 1, Argument::kNone},
    Grammar{"task", 0, Argument::kTask},         Grammar{"move", kPoints, Argument::kTask},
    Grammar{"set", 0, Argument::kSetting},
};

/// Reads "VARIABLE = value", as flags are written.
Result<VariablePost> ReadSetting(std::string_view text) {
  const Result<Flag> flag = Flag::Parse(text);
  if (!flag.ok()) return Error{"set: " + flag.error()};
  if (flag->condition() || !flag->destination().empty() || !flag->MacrosUsed().empty()) {
    return Error{"set takes VARIABLE=value alone, without conditions, destinations and macros"};
  }
  return flag->Fire(Variables(), {}).front();
}

}  // namespace

Result<HelmOrder> ReadOrder(std::string_view command, std::string_view argument,
                            std::span<const double> values) {
  const auto grammar = std::find_if(kGrammar.begin(), kGrammar.end(),
                                    [&](const Grammar& row) { return row.word == command; });
  if (grammar == kGrammar.end()) {
    return Error{fmt::format("unknown command '{}'", Printable(command))};
  }
  const bool takes_points = grammar->num_values == kPoints;
  if (takes_points && (values.empty() || values.size() % 2 != 0)) {
    return Error{
        fmt::format("{} takes x and y of each point and not {} values", command, values.size())};
  }
  if (!takes_points && values.size() != grammar->num_values) {
    return Error{
        fmt::format("{} takes {} values and not {}", command, grammar->num_values, values.size())};
  }
  if (grammar->argument == Argument::kTask && argument.empty()) {
    return Error{fmt::format("{} needs the name of a task as its argument", command)};
  }
  if (grammar->argument == Argument::kNone && !argument.empty()) {
    return Error{fmt::format("{} takes no argument", command)};
  }
  if (grammar->argument == Argument::kReason && argument.size() > kMaxReasonLength) {
    return Error{fmt::format("the reason of {} has {} characters; {} are the most", command,
                             argument.size(), kMaxReasonLength)};
  }
  HelmOrder order{.kind = static_cast<OrderKind>(grammar - kGrammar.begin())};
  if (order.kind == OrderKind::kGoto) {
    order.point_m = {values[0], values[1]};
    if (!(order.point_m.cwiseAbs().maxCoeff() <= kMaxCoordinate_m) || !order.point_m.allFinite()) {
      return Error{"goto needs coordinates within 10,000 km"};
    }
  }
  if (order.kind == OrderKind::kSpeed) {
    order.speed_mps = values[0];
    if (!(order.speed_mps > 0) || !std::isfinite(order.speed_mps)) {
      return Error{"speed needs a number of m/s greater than zero"};
    }
  }
  if (grammar->argument == Argument::kSetting) {
    Result<VariablePost> setting = ReadSetting(argument);
    if (!setting.ok()) return Error{setting.error()};
    order.setting = *setting;
  }
  if (grammar->argument == Argument::kTask) order.task = argument;
  if (takes_points) order.places.assign(values.begin(), values.end());
  if (grammar->argument == Argument::kReason) order.reason = Printable(argument);
  return order;
}

Result<HelmOrder> ReadOrderText(std::string_view text) {
  const size_t equals = text.find('=');
  const std::string_view command = text.substr(0, equals);
  const std::string_view rest =
      equals == std::string_view::npos ? std::string_view() : text.substr(equals + 1);
  if (equals != std::string_view::npos && rest.empty()) {
    return Error{fmt::format("'{}' has nothing behind the '='", Printable(text))};
  }
  if (command == Name(OrderKind::kTask) || command == Name(OrderKind::kSet)) {
    return ReadOrder(command, rest, {});
  }
  std::vector<double> values;
  for (size_t begin = 0; begin < rest.size();) {
    const size_t end = std::min(rest.find(',', begin), rest.size());
    const std::string_view word = rest.substr(begin, end - begin);
    double value = 0;
    const std::from_chars_result read =
        std::from_chars(word.data(), word.data() + word.size(), value);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size()) {
      return Error{fmt::format("'{}' is not a number", Printable(word))};
    }
    values.push_back(value);
    begin = end + 1;
  }
  return ReadOrder(command, "", values);
}

std::string_view Name(OrderKind kind) { return kGrammar[kind].word; }

}  // namespace shoal
