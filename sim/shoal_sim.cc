#include "sim/shoal_sim.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/mission/model/mission.h"
#include "lib/run/command_line/build_facts.h"
#include "lib/run/command_line/version.h"
#include "sim/simulation.h"

namespace shoal::c_interface {

/// The messages of a channel, as far as they are wanted.
struct Kept {
  Bytes data;  ///< The last.
  int64_t count = 0;
  bool collects = false;
  std::deque<Bytes> waiting = {};  ///< To be taken.
  size_t waiting_bytes = 0;
  Bytes taken = {};
};

constexpr size_t kMaxBytes = size_t{1} << 24;
constexpr size_t kMaxWaitingBytes = size_t{1} << 26;
constexpr size_t kMaxCharacters = 63;
constexpr int64_t kStepsBetweenChecks = 64;  ///< Of faults, as `shoal sim` does.

bool IsChannelName(std::string_view name) {
  const auto is_legal = [](char c) { return shoal::IsNameCharacter(c) || c == '.'; };
  return !name.empty() && name.size() <= kMaxCharacters &&
         std::all_of(name.begin(), name.end(), is_legal);
}

}  // namespace shoal::c_interface

using shoal::c_interface::Kept;

struct shoal_sim {
  shoal::SimulationOptions options = {};
  std::optional<shoal::Simulation> simulation = {};
  std::map<std::string, Kept, std::less<>> kept = {};  ///< By channel.
  std::string error = {};
  std::string summary = {};
  bool has_ended = false;
};

namespace shoal::c_interface {

int Fail(shoal_sim* sim, shoal_sim_code code, std::string_view text) {
  sim->error = text;
  return code;
}

/// Calls `use()`, whose result is a code or a count. What it throws becomes an error.
template <class Use>
auto WithoutExceptions(shoal_sim* sim, Use use) -> decltype(use()) {
  if (sim == nullptr) return SHOAL_SIM_MISUSE;
  const char* what = "an unknown exception";
  try {
    return use();
  } catch (const std::bad_alloc&) {
    what = "out of memory";
  } catch (const std::exception& error) {
    try {
      return Fail(sim, SHOAL_SIM_INTERNAL, error.what());
    } catch (...) {
      what = "out of memory";
    }
  } catch (...) {
  }
  try {
    return Fail(sim, SHOAL_SIM_INTERNAL, what);
  } catch (...) {
    return SHOAL_SIM_INTERNAL;
  }
}

/// The same for what is set before the mission is open.
template <class Use>
int BeforeOpen(shoal_sim* sim, const void* text, Use use) {
  return WithoutExceptions(sim, [&]() -> int {
    if (text == nullptr) return Fail(sim, SHOAL_SIM_MISUSE, "a null pointer in place of a text");
    if (sim->simulation) {
      return Fail(sim, SHOAL_SIM_MISUSE, "the mission is open: set this before shoal_sim_open()");
    }
    use();
    return SHOAL_SIM_OK;
  });
}

int NotOpen(shoal_sim* sim) {
  return Fail(sim, SHOAL_SIM_MISUSE, "the mission is not open: call shoal_sim_open() first");
}

void Watch(shoal_sim* sim, const std::string& channel) {
  Kept* kept = &sim->kept[channel];
  sim->simulation->bus().SubscribeBytes(channel, [kept](const Message& message) {
    kept->data.assign(message.data.begin(), message.data.end());
    ++kept->count;
    if (!kept->collects) return;
    kept->waiting.push_back(kept->data);
    kept->waiting_bytes += kept->data.size();
  });
}

/// Has a channel's messages kept, the last or all.
int Keep(shoal_sim* sim, const char* channel, bool all) {
  return WithoutExceptions(sim, [&]() -> int {
    if (channel == nullptr || !IsChannelName(channel)) {
      return Fail(sim, SHOAL_SIM_MISUSE, "a channel has 1 to 63 letters, digits, '_' and '.'");
    }
    const auto found = sim->kept.find(std::string_view(channel));
    if (found != sim->kept.end() && found->second.collects >= all) return SHOAL_SIM_OK;
    if (sim->simulation && sim->simulation->step() >= 0) {
      return Fail(sim, SHOAL_SIM_MISUSE,
                  fmt::format("{}: {} a channel before the first step", channel,
                              all ? "collect" : "watch"));
    }
    const bool is_new = found == sim->kept.end();
    sim->kept[channel].collects = all;
    if (sim->simulation && is_new) Watch(sim, channel);
    return SHOAL_SIM_OK;
  });
}

/// Returns the first channel of which more than kMaxWaitingBytes wait to be taken, or null.
const std::string* Overfull(const shoal_sim& sim) {
  for (const auto& [channel, kept] : sim.kept) {
    if (kept.waiting_bytes > kMaxWaitingBytes) return &channel;
  }
  return nullptr;
}

int64_t Step(shoal_sim* sim, int64_t count) {
  Simulation& simulation = *sim->simulation;
  for (int64_t taken = 0; taken < count; ++taken) {
    if (const std::string* channel = Overfull(*sim)) {
      return Fail(sim, SHOAL_SIM_MISUSE,
                  fmt::format("{}: more than 64 MiB wait after step {}: call shoal_sim_take()",
                              *channel, simulation.step()));
    }
    if (!simulation.Step()) {
      sim->has_ended = true;
      if (const std::string fault = simulation.Fault(); !fault.empty()) {
        return Fail(sim, SHOAL_SIM_FAULT, fault);
      }
      return taken;
    }
    if (simulation.step() % kStepsBetweenChecks != 0) continue;
    if (const std::string fault = simulation.Fault(); !fault.empty()) {
      simulation.End();
      sim->has_ended = true;
      return Fail(sim, SHOAL_SIM_FAULT, fault);
    }
  }
  return count;
}

}  // namespace shoal::c_interface

namespace c_interface = shoal::c_interface;

int shoal_sim_abi_version(void) { return SHOAL_SIM_ABI_VERSION; }

const char* shoal_sim_version(void) {
  try {
    static const std::string version = shoal::TextOf(shoal::OwnBuild());
    return version.c_str();
  } catch (...) {
    return shoal::kVersion;
  }
}

shoal_sim* shoal_sim_new(const char* mission_file) {
  try {
    auto sim = std::make_unique<shoal_sim>();
    if (mission_file != nullptr) sim->options.mission_file = mission_file;
    return sim.release();
  } catch (...) {
    return nullptr;
  }
}

void shoal_sim_free(shoal_sim* sim) {
  c_interface::WithoutExceptions(sim, [&]() -> int {
    if (sim->simulation) sim->simulation->End();
    return SHOAL_SIM_OK;
  });
  delete sim;
}

const char* shoal_sim_error(const shoal_sim* sim) {
  return sim == nullptr ? "a null pointer in place of a shoal_sim" : sim->error.c_str();
}

int shoal_sim_set(shoal_sim* sim, const char* override_text) {
  return c_interface::BeforeOpen(sim, override_text,
                                 [&] { sim->options.overrides.emplace_back(override_text); });
}

int shoal_sim_set_seed(shoal_sim* sim, uint64_t seed) {
  return c_interface::BeforeOpen(sim, &seed, [&] { sim->options.seed = seed; });
}

int shoal_sim_set_log(shoal_sim* sim, const char* path) {
  return c_interface::BeforeOpen(sim, path, [&] { sim->options.log_path = path; });
}

int shoal_sim_watch(shoal_sim* sim, const char* channel) {
  return c_interface::Keep(sim, channel, false);
}

int shoal_sim_collect(shoal_sim* sim, const char* channel) {
  return c_interface::Keep(sim, channel, true);
}

int shoal_sim_open(shoal_sim* sim) {
  return c_interface::WithoutExceptions(sim, [&]() -> int {
    if (sim->simulation) {
      return c_interface::Fail(sim, SHOAL_SIM_MISUSE, "the mission is open already");
    }
    auto opened = shoal::Simulation::Open(sim->options);
    if (!opened.ok()) return c_interface::Fail(sim, SHOAL_SIM_MISSION, opened.error());
    sim->simulation.emplace(std::move(*opened));
    for (const auto& [channel, kept] : sim->kept) c_interface::Watch(sim, channel);
    return SHOAL_SIM_OK;
  });
}

int64_t shoal_sim_step(shoal_sim* sim, int64_t count) {
  return c_interface::WithoutExceptions(sim, [&]() -> int64_t {
    if (!sim->simulation) return c_interface::NotOpen(sim);
    if (count < 0) {
      return c_interface::Fail(sim, SHOAL_SIM_MISUSE, "the number of steps is negative");
    }
    return c_interface::Step(sim, count);
  });
}

int shoal_sim_end(shoal_sim* sim) {
  return c_interface::WithoutExceptions(sim, [&]() -> int {
    if (!sim->simulation) return c_interface::NotOpen(sim);
    sim->simulation->End();
    sim->has_ended = true;
    const std::string fault = sim->simulation->Fault();
    return fault.empty() ? SHOAL_SIM_OK : c_interface::Fail(sim, SHOAL_SIM_FAULT, fault);
  });
}

int shoal_sim_read(shoal_sim* sim, const char* channel, const void** data, size_t* size,
                   int64_t* count) {
  return c_interface::WithoutExceptions(sim, [&]() -> int {
    if (channel == nullptr || data == nullptr) {
      return c_interface::Fail(sim, SHOAL_SIM_MISUSE, "channel and data must not be null");
    }
    const auto found = sim->kept.find(std::string_view(channel));
    if (found == sim->kept.end()) {
      return c_interface::Fail(
          sim, SHOAL_SIM_MISUSE,
          fmt::format("{} is not watched: call shoal_sim_watch() before the first step", channel));
    }
    const Kept& kept = found->second;
    *data = kept.count == 0 ? nullptr : kept.data.data();
    if (size != nullptr) *size = kept.data.size();
    if (count != nullptr) *count = kept.count;
    return SHOAL_SIM_OK;
  });
}

int shoal_sim_take(shoal_sim* sim, const char* channel, const void** data, size_t* size) {
  return c_interface::WithoutExceptions(sim, [&]() -> int {
    if (channel == nullptr || data == nullptr) {
      return c_interface::Fail(sim, SHOAL_SIM_MISUSE, "channel and data must not be null");
    }
    const auto found = sim->kept.find(std::string_view(channel));
    if (found == sim->kept.end() || !found->second.collects) {
      return c_interface::Fail(
          sim, SHOAL_SIM_MISUSE,
          fmt::format("{} is not collected: call shoal_sim_collect() before the first step",
                      channel));
    }
    Kept& kept = found->second;
    if (kept.waiting.empty()) return 0;
    kept.taken = std::move(kept.waiting.front());
    kept.waiting.pop_front();
    kept.waiting_bytes -= kept.taken.size();
    *data = kept.taken.data();
    if (size != nullptr) *size = kept.taken.size();
    return 1;
  });
}

int shoal_sim_write(shoal_sim* sim, const char* channel, const void* data, size_t size) {
  return c_interface::WithoutExceptions(sim, [&]() -> int {
    if (!sim->simulation) return c_interface::NotOpen(sim);
    if (channel == nullptr || !c_interface::IsChannelName(channel)) {
      return c_interface::Fail(sim, SHOAL_SIM_MISUSE,
                               "a channel has 1 to 63 letters, digits, '_' and '.'");
    }
    if ((data == nullptr && size > 0) || size > c_interface::kMaxBytes) {
      return c_interface::Fail(sim, SHOAL_SIM_MISUSE, "the message is null, or longer than 16 MiB");
    }
    sim->simulation->bus().PublishBytes(channel, {static_cast<const uint8_t*>(data), size});
    return SHOAL_SIM_OK;
  });
}

int64_t shoal_sim_step_number(const shoal_sim* sim) {
  return sim == nullptr || !sim->simulation ? -1 : sim->simulation->step();
}

int64_t shoal_sim_utime(const shoal_sim* sim) {
  return sim == nullptr || !sim->simulation ? 0 : sim->simulation->utime();
}

int64_t shoal_sim_tick_us(const shoal_sim* sim) {
  return sim == nullptr || !sim->simulation ? 0 : sim->simulation->mission().tick_us;
}

int shoal_sim_has_ended(const shoal_sim* sim) { return sim != nullptr && sim->has_ended ? 1 : 0; }

int64_t shoal_sim_num_vehicles(const shoal_sim* sim) {
  if (sim == nullptr || !sim->simulation) return 0;
  return static_cast<int64_t>(sim->simulation->mission().vehicles.size());
}

const char* shoal_sim_vehicle(const shoal_sim* sim, int64_t index) {
  if (index < 0 || index >= shoal_sim_num_vehicles(sim)) return nullptr;
  return sim->simulation->mission().vehicles[static_cast<size_t>(index)].name.c_str();
}

int shoal_sim_passed(const shoal_sim* sim) {
  try {
    return sim != nullptr && sim->simulation && sim->simulation->Passed() ? 1 : 0;
  } catch (...) {
    return 0;
  }
}

const char* shoal_sim_summary(shoal_sim* sim) {
  const int code = c_interface::WithoutExceptions(sim, [&]() -> int {
    sim->summary = sim->simulation ? sim->simulation->Summary(sim->has_ended) : "";
    return SHOAL_SIM_OK;
  });
  return code == SHOAL_SIM_OK ? sim->summary.c_str() : "";
}
