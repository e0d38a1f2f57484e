#include "apps/shoal/send_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <span>

#include "lib/bus/channels.h"
#include "lib/bus/lcm_bus.h"
#include "lib/check/result.h"
#include "lib/run/roster.h"
#include "lib/run/run_app.h"
#include "lib/run/run_registry.h"

namespace shoal {

namespace {

/// How long an answer from the helm is waited for: a step, and the second of its own rhythm.
constexpr int64_t kAnswerPatience_us = 1'500'000;
/// How long a helm's page from before the command is waited for; it comes within a millisecond.
constexpr int64_t kPagePatience_us = 300'000;
constexpr int64_t kPageInterval_us = 100'000;  ///< Between two requests.
/// What a page says earlier may have been said before the command arrived: datagrams on different
/// ports may overtake one another.
constexpr int64_t kDelivery_us = 100'000;
/// The command arrives in the step that the page of before names, or the next; it is handled one
/// later at most.
constexpr int64_t kStepsToObey = 2;
/// What a helm's page warns of, with the reason behind it; apps/helm/helm_app.cc.
constexpr std::string_view kRefused = "HELM_COMMAND refused: ";

/// One command's shape.
struct CommandShape {
  std::string_view name;
  bool takes_text = false;            ///< One word, such as a task's name.
  std::vector<int> num_values = {0};  ///< Allowed counts of numbers.
  std::string_view help;
};

const std::vector<CommandShape>& HelmCommands() {
  static const std::vector<CommandShape> shapes = {
      {"deploy", false, {0}, "start the list of tasks, or go on with it"},
      {"return", false, {0}, "go home and stay there"},
      {"station_keep", false, {0}, "stay here"},
      {"all_stop", false, {0}, "stop the actuators"},
      {"resume", false, {0}, "go on after all_stop"},
      {"park", false, {0}, "end all tasks"},
      {"goto", false, {2}, "X Y: go to a point (metres East, North) and stay there"},
      {"speed", false, {1}, "V: go at V m/s until the next task"},
      {"task", true, {0}, "NAME: jump to a task"},
  };
  return shapes;
}

const std::vector<CommandShape>& SimCommands() {
  static const std::vector<CommandShape> shapes = {
      {"pause", false, {0}, "hold the vehicle where it is"},
      {"resume", false, {0}, "let it move again"},
      {"reset", false, {0, 4}, "[X Y HEADING SPEED]: back to the start, or to a pose"},
      {"drift", false, {2}, "X Y: add a drift of X m/s East, Y m/s North"},
  };
  return shapes;
}

std::string Rows(std::string_view prefix, const std::vector<CommandShape>& shapes) {
  std::string text;
  for (const CommandShape& shape : shapes) {
    text += fmt::format("  {:<28} {}\n", fmt::format("{}{}", prefix, shape.name), shape.help);
  }
  return text;
}

std::optional<double> ParseNumber(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Words after the command, as the command wants them.
struct Arguments {
  std::string text;
  std::vector<double> values;
};

Result<Arguments> ParseArguments(const std::vector<CommandShape>& shapes, const std::string& name,
                                 std::span<const std::string> words) {
  const auto shape = std::find_if(shapes.begin(), shapes.end(),
                                  [&](const CommandShape& each) { return each.name == name; });
  if (shape == shapes.end()) {
    return Error{fmt::format("unknown command '{}'; there are:\n{}", name, Rows("", shapes))};
  }
  Arguments arguments;
  if (shape->takes_text) {
    if (words.size() != 1) {
      return Error{fmt::format("usage: {} {}", shape->name, shape->help)};
    }
    arguments.text = words.front();
    return arguments;
  }
  for (const std::string& word : words) {
    const std::optional<double> value = ParseNumber(word);
    if (!value) return Error{fmt::format("'{}' is not a number", word)};
    arguments.values.push_back(*value);
  }
  if (std::find(shape->num_values.begin(), shape->num_values.end(),
                static_cast<int>(words.size())) == shape->num_values.end()) {
    return Error{fmt::format("usage: {} {}", shape->name, shape->help)};
  }
  return arguments;
}

std::optional<Channel<unc_control_t>> RuleChannel(const std::string& rule) {
  if (rule == "comms_range") return channels::UncCommsRange();
  if (rule == "stale_time") return channels::UncStaleTime();
  return std::nullopt;
}

/// Prints why nothing can have left, where that is so. Returns true where the bus works.
bool BusWorks(const LcmBus& bus) {
  if (!bus.error().empty()) fmt::print(stderr, "shoal: {}\n", bus.error());
  return bus.error().empty();
}

int SendRule(LcmBus& bus, const Channel<unc_control_t>& channel, const SendOptions& options) {
  std::optional<double> value;
  if (options.words.size() == 1) {
    // As in a mission file, where the word stands for -1.
    value = options.words.front() == "nolimit" ? -1 : ParseNumber(options.words.front());
  }
  if (!value) {
    fmt::print(stderr, "shoal: usage: shoal send {} NUMBER, or nolimit\n", options.target);
    return kExitUsage;
  }
  unc_control_t control{};
  control.value = *value;
  Publish(bus, channel, control);
  if (!BusWorks(bus)) return kExitEnvironment;
  fmt::print("sent {} = {}; `shoal status shore_broker` shows the rules in force\n", channel.name,
             options.words.front());
  return kExitOk;
}

/// What one helm has told, before and after the command.
struct HelmAnswer {
  std::optional<appcast_t> page_before;  ///< Absent: it does not answer requests.
  std::optional<appcast_t> page;         ///< The last that came after the command.
  std::optional<helm_state_t> state;     ///< The last that came after the command.
};

/// Returns why the helm refused, from a warning that its page did not have before; empty: it did
/// not, as far as the page says. Another count behind a warning makes it another warning.
std::string RefusalOf(const HelmAnswer& answer) {
  if (!answer.page_before || !answer.page) return {};
  const std::vector<std::string>& before = answer.page_before->run_warnings;
  for (const std::string& warning : answer.page->run_warnings) {
    if (!warning.starts_with(kRefused)) continue;
    if (std::find(before.begin(), before.end(), warning) != before.end()) continue;
    std::string reason = warning.substr(kRefused.size());
    if (const size_t count = reason.rfind(" ("); reason.ends_with(" times)")) reason.resize(count);
    return reason;
  }
  return {};
}

/// Speaks to the helms of some vehicles, and keeps what they say.
class HelmTalk {
 public:
  HelmTalk(LcmBus& bus, const std::vector<std::string>& vehicles) : bus_(bus) {
    for (const std::string& vehicle : vehicles) {
      HelmAnswer& answer = answers_[vehicle];
      Subscribe(bus, channels::HelmState(vehicle), [this, &answer](const helm_state_t& state) {
        if (sent_us_) answer.state = state;
      });
    }
    Subscribe(bus, channels::Appcast(), [this](const appcast_t& page) { OnPage(page); });
  }

  /// Gets the pages as they are before a command.
  void AskBefore() {
    const int64_t begin = MonotonicMicroseconds();
    while (MonotonicMicroseconds() - begin < kPagePatience_us && bus_.error().empty()) {
      if (!AskFor([](const HelmAnswer& answer) { return !answer.page_before; })) return;
      bus_.Poll(20'000);
    }
  }

  void Send(const helm_command_t& command) {
    bus_.Poll(0);
    for (const auto& [vehicle, answer] : answers_) {
      Publish(bus_, channels::HelmCommand(vehicle), command);
    }
    sent_us_ = MonotonicMicroseconds();
    next_request_us_ = *sent_us_ + kDelivery_us;
  }

  /// Waits until each helm has refused, or has gone on without refusing, or patience ends.
  void AwaitAnswers() {
    const auto is_open = [](const HelmAnswer& answer) {
      if (!RefusalOf(answer).empty()) return false;
      const bool is_page_late =
          answer.page_before &&
          (!answer.page || answer.page->step < answer.page_before->step + kStepsToObey);
      return is_page_late || !answer.state;
    };
    while (MonotonicMicroseconds() - *sent_us_ < kAnswerPatience_us) {
      if (!AskFor(is_open)) return;
      bus_.Poll(20'000);
    }
  }

  const std::map<std::string, HelmAnswer>& answers() const { return answers_; }

 private:
  /// Asks the helms that are still `open` for their pages, at intervals. Returns false where none
  /// is.
  template <class F>
  bool AskFor(F open) {
    const int64_t now = MonotonicMicroseconds();
    const bool asks = now >= next_request_us_;
    if (asks) next_request_us_ = now + kPageInterval_us;
    bool is_any_open = false;
    for (const auto& [vehicle, answer] : answers_) {
      if (!open(answer)) continue;
      is_any_open = true;
      if (!asks) continue;
      appcast_req_t request{};
      request.app = ParticipantName("helm", vehicle);
      Publish(bus_, channels::AppcastReq(), request);
    }
    return is_any_open;
  }

  void OnPage(const appcast_t& page) {
    for (auto& [vehicle, answer] : answers_) {
      if (page.app != ParticipantName("helm", vehicle)) continue;
      if (!sent_us_) {
        answer.page_before = page;
      } else if (MonotonicMicroseconds() - *sent_us_ >= kDelivery_us) {
        answer.page = page;
      }
    }
  }

  LcmBus& bus_;
  std::map<std::string, HelmAnswer> answers_;
  std::optional<int64_t> sent_us_;
  int64_t next_request_us_ = 0;
};

/// Publishes to each vehicle and shows what its helm says next.
int SendHelm(LcmBus& bus, const std::vector<std::string>& vehicles, const std::string& command,
             const Arguments& arguments) {
  helm_command_t message{};
  message.command = command;
  message.argument = arguments.text;
  message.values = arguments.values;
  message.num_values = static_cast<int32_t>(arguments.values.size());
  HelmTalk talk(bus, vehicles);
  talk.AskBefore();
  talk.Send(message);
  if (!BusWorks(bus)) return kExitEnvironment;
  fmt::print("sent {} to {}\n", command, fmt::join(vehicles, ", "));
  std::fflush(stdout);
  talk.AwaitAnswers();

  bool is_any_refused = false;
  size_t num_silent = 0;
  for (const std::string& vehicle : vehicles) {
    const HelmAnswer& answer = talk.answers().at(vehicle);
    if (const std::string refusal = RefusalOf(answer); !refusal.empty()) {
      is_any_refused = true;
      fmt::print(stderr, "{} refused: {}\n", vehicle, refusal);
    } else if (answer.state) {
      fmt::print("{}: {} {} ({})\n", vehicle, answer.state->state, answer.state->task,
                 answer.state->all_stop);
    } else {
      ++num_silent;
    }
  }
  if (num_silent > 0) {
    fmt::print("{} of {} helms have said nothing since; `shoal status` shows who is there\n",
               num_silent, vehicles.size());
  }
  return is_any_refused ? kExitUsage : kExitOk;
}

}  // namespace

std::string SendCommandsText() {
  return "VEHICLE is a vehicle's name or all.\n" + Rows("VEHICLE ", HelmCommands()) +
         Rows("VEHICLE sim ", SimCommands()) +
         fmt::format("  {:<28} {}\n  {:<28} {}\n", "comms_range R",
                     "the broker's rule, metres, or nolimit", "stale_time T",
                     "the broker's rule, seconds, or nolimit");
}

int RunSend(const SendOptions& options) {
  const auto usage = [](const std::string& why) {
    fmt::print(stderr, "shoal: {}\n", why);
    return static_cast<int>(kExitUsage);
  };
  const Result<RunningMission> mission = FindRunningMission(options.port_base);
  if (!mission.ok()) {
    fmt::print(stderr, "shoal: {}\n", mission.error());
    return kExitEnvironment;
  }
  std::vector<std::string> vehicles;
  for (const std::string& name : mission->vehicles) {
    if (options.target == "all" || UpperCase(name) == UpperCase(options.target)) {
      vehicles.push_back(name);
    }
  }
  LcmBus bus(mission->Ports());
  if (vehicles.empty()) {
    if (const auto rule = RuleChannel(options.target)) {
      return SendRule(bus, *rule, options);
    }
    return usage(
        fmt::format("no vehicle '{}' in {}; it has: {}; or say all, or one of the rules "
                    "comms_range, stale_time",
                    options.target, mission->name, fmt::join(mission->vehicles, ", ")));
  }
  if (options.words.empty()) return usage("say what: " + SendCommandsText());
  const std::span<const std::string> words(options.words);
  if (words[0] != "sim") {
    const auto arguments = ParseArguments(HelmCommands(), words[0], words.subspan(1));
    if (!arguments.ok()) return usage(arguments.error());
    return SendHelm(bus, vehicles, words[0], *arguments);
  }
  if (words.size() < 2) return usage("say what:\n" + Rows("sim ", SimCommands()));
  const auto arguments = ParseArguments(SimCommands(), words[1], words.subspan(2));
  if (!arguments.ok()) return usage(arguments.error());
  for (const std::string& vehicle : vehicles) {
    sim_command_t message{};
    message.command = words[1];
    message.values = arguments->values;
    message.num_values = static_cast<int32_t>(arguments->values.size());
    Publish(bus, channels::SimCommand(vehicle), message);
  }
  if (!BusWorks(bus)) return kExitEnvironment;
  fmt::print("sent sim {} to {}\n", words[1], fmt::join(vehicles, ", "));
  return kExitOk;
}

}  // namespace shoal
