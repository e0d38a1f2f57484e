#include "sim/judge_log.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "lib/bus/bus/handler_table.h"
#include "lib/bus/bus/seal.h"
#include "lib/bus/record/log_reader.h"
#include "lib/tools/metrics/trial_result.h"
#include "lib/tools/metrics/trial_watch.h"
#include "sim/director_app.h"

namespace shoal {

namespace {

/// Hands what a log holds to its subscribers. What they publish is in the log already.
class LogBus : public Bus {
 public:
  void PublishBytes(std::string_view, std::span<const uint8_t>) override {}
  void SubscribeBytes(const std::string& channel, Handler handler) override {
    handlers_.Add(channel, std::move(handler));
  }
  void SubscribeAll(Handler handler) override { handlers_.AddForAll(std::move(handler)); }

  void Handle(const LogEvent& event) {
    if (!handlers_.Wants(event.channel)) return;
    handlers_.Call(
        {.channel = event.channel, .publisher = "log", .data = Unseal(event.data).message});
  }

 private:
  HandlerTable handlers_;
};

TrialResult ErrorOf(std::string why) {
  return {.outcome = TrialOutcome::kError, .why = std::move(why), .metrics = {}};
}

}  // namespace

TrialResult JudgeLog(const Mission& mission, std::span<const MetricSpec> metrics,
                     const std::string& log_path) {
  Result<LogReader> reader = LogReader::Open(log_path);
  if (!reader.ok()) return ErrorOf(reader.error());
  LogBus bus;
  DirectorApp director(mission, bus);
  TrialWatch watch(mission, metrics);
  watch.Subscribe(bus);

  std::optional<LogEvent> event = reader->Next();
  // As in a simulation: the director ticks in a step once the messages of the one before have been
  // handled; that it ends the mission is looked at before the next.
  director.Tick(mission.UtimeOf(0));
  for (int64_t step = 0; step <= mission.LastStep(); ++step) {
    if (!event) break;
    while (event && event->utime <= mission.UtimeOf(step)) {
      bus.Handle(*event);
      event = reader->Next();
    }
    const bool is_last = step == mission.LastStep() || director.EndsMission();
    if (is_last) {
      director.End();
    } else {
      director.Tick(mission.UtimeOf(step + 1));
    }
    watch.EndStep(director.judge());
    if (!is_last) continue;
    if (!reader->error().empty()) return ErrorOf(reader->error());
    return ResultOf(mission, director.judge(), watch);
  }
  if (!reader->error().empty()) return ErrorOf(reader->error());
  return ErrorOf(fmt::format("{}: the log ends before the mission does, which lasts {:g} s",
                             log_path, mission.duration_s));
}

}  // namespace shoal
