#include "apps/shoal/host_doctor.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <cstdlib>

#include "lib/base/check/result.h"
#include "lib/base/time/time_units.h"
#include "lib/run/hosts/curve_link.h"
#include "lib/run/hosts/link_message.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

constexpr int kNumPings = 200;
constexpr size_t kNumLoads = 8;
constexpr size_t kLoad_bytes = size_t{4} << 20;
constexpr int64_t kPingPatience_us = 5 * kSecond_us;
/// A clock that is off by more misleads whoever compares logs by wall time.
constexpr int64_t kGreatOffset_us = 100'000;

/// Sends pings over a link and awaits each answer.
class HostPings {
 public:
  HostPings(const std::string& address, const std::string& public_key, const HostKey& key)
      : link_(address, public_key, key) {}

  /// Sends one ping with a load; returns the host's clock, or why there is no answer.
  Result<int64_t> Ping(size_t load_bytes) {
    LinkMessage ping{.kind = LinkKind::kPing};
    ping.parts.push_back({.name = "load", .data = Bytes(load_bytes)});
    const Bytes bytes = EncodeLinkMessage(ping, next_sequence_++);
    const int64_t deadline = MonotonicMicroseconds() + kPingPatience_us;
    bool is_sent = false;
    while (MonotonicMicroseconds() < deadline) {
      if (!is_sent) is_sent = link_.Send(bytes);
      if (const std::optional<Bytes> answer = link_.Receive()) return TimeIn(*answer);
      if (!link_.error().empty()) return Error{link_.error()};
      if (link_.state() == HomeLink::State::kKeyRefused) {
        return Error{"it does not accept this computer's key: start it with --allow"};
      }
      pollfd waited{.fd = link_.fd(), .events = POLLIN, .revents = 0};
      constexpr int kRetry_ms = 10;
      ::poll(&waited, 1, kRetry_ms);
    }
    return Error{link_.state() == HomeLink::State::kHandshakeFailed
                     ? "what listens there does not prove the key that --host-key gives"
                     : fmt::format("no answer within {} s: is `shoal host` running there, and does "
                                   "a firewall let its TCP port in?",
                                   kPingPatience_us / kSecond_us)};
  }

 private:
  Result<int64_t> TimeIn(const Bytes& answer) {
    const Result<LinkMessage> pong = intake_.Take(answer);
    if (!pong.ok()) return Error{"it answers with " + pong.error()};
    return std::strtoll(pong->TextOf("utc_us").c_str(), nullptr, 10);
  }

  HomeLink link_;
  LinkIntake intake_;
  uint64_t next_sequence_ = 0;
};

Result<HostFacts> MeasureHost(HostPings& pings) {
  HostFacts facts;
  // The first one awaits the connection.
  if (const Result<int64_t> first = pings.Ping(0); !first.ok()) return Error{first.error()};
  for (int i = 0; i < kNumPings; ++i) {
    const int64_t begin = MonotonicMicroseconds();
    const int64_t sent = UnixMicroseconds();
    const Result<int64_t> there = pings.Ping(0);
    if (!there.ok()) return Error{there.error()};
    facts.offsets_us.push_back(ClockOffset_us(sent, *there, UnixMicroseconds()));
    facts.round_trips_us.push_back(MonotonicMicroseconds() - begin);
  }
  const int64_t begin = MonotonicMicroseconds();
  for (size_t i = 0; i < kNumLoads; ++i) {
    const Result<int64_t> there = pings.Ping(kLoad_bytes);
    if (!there.ok()) return Error{there.error()};
  }
  facts.load_us = MonotonicMicroseconds() - begin;
  facts.load_bytes = static_cast<int64_t>(kNumLoads * kLoad_bytes);
  return facts;
}

int64_t AtShare(std::vector<int64_t> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(static_cast<double>(values.size() - 1) * share)];
}

}  // namespace

int64_t ClockOffset_us(int64_t sent_us, int64_t there_us, int64_t received_us) {
  return ((there_us - sent_us) + (there_us - received_us)) / 2;
}

std::vector<Diagnosis> DiagnoseHost(const HostFacts& facts, double tick_s) {
  const auto milliseconds = [](int64_t us) { return static_cast<double>(us) / 1e3; };
  const int64_t median_us = std::max<int64_t>(AtShare(facts.round_trips_us, 0.5), 1);
  const int64_t tail_us = std::max<int64_t>(AtShare(facts.round_trips_us, 0.99), 1);
  const double tick_us = tick_s * 1e6;
  const double warp = tick_us / static_cast<double>(median_us);
  const double steady = tick_us / static_cast<double>(tail_us);
  std::vector<Diagnosis> diagnoses;
  diagnoses.push_back({.text = fmt::format("round trip: {:.2f} ms at least, {:.2f} ms (median), "
                                           "{:.2f} ms (99 %)",
                                           milliseconds(AtShare(facts.round_trips_us, 0)),
                                           milliseconds(median_us), milliseconds(tail_us))});
  diagnoses.push_back(
      {.health = steady < 1 ? Health::kWarn : Health::kOk,
       .text = fmt::format("warp: the way allows {:.1f} at steps of {} s, and {:.1f} with 99 % of "
                           "the answers in time; the vehicles' own work comes on top",
                           warp, tick_s, steady)});
  // The offset that came with the shortest way is the least wrong.
  const auto shortest = std::min_element(facts.round_trips_us.begin(), facts.round_trips_us.end());
  const int64_t offset_us =
      facts.offsets_us[static_cast<size_t>(shortest - facts.round_trips_us.begin())];
  Diagnosis clock{.text =
                      fmt::format("clock: the host's is {:.2f} ms {} (within {:.2f} ms)",
                                  milliseconds(std::abs(offset_us)),
                                  offset_us < 0 ? "behind" : "ahead", milliseconds(*shortest / 2))};
  if (std::abs(offset_us) > kGreatOffset_us) {
    clock.health = Health::kWarn;
    clock.text += "; missions do not use it, logs of the host's own do";
    clock.remedies = {"timedatectl set-ntp true"};
  }
  diagnoses.push_back(clock);
  const double rate = static_cast<double>(2 * facts.load_bytes) /
                      static_cast<double>(std::max<int64_t>(facts.load_us, 1));
  diagnoses.push_back({.text = fmt::format("throughput: {:.1f} MB/s, of {} MiB there and back",
                                           rate, facts.load_bytes >> 20)});
  return diagnoses;
}

int RunHostDoctor(const HostDoctorOptions& options) {
  const auto fail = [&](const std::string& why, int code) {
    fmt::print("FAIL  host {}: {}\n", options.address, why);
    return code;
  };
  if (options.public_key.empty()) {
    return fail("its public key is needed: --host-key KEY, or the .pub file of `shoal host keygen`",
                kExitUsage);
  }
  const Result<std::string> public_key = FindPublicKey(options.public_key, "");
  if (!public_key.ok()) return fail(public_key.error(), kExitUsage);
  const Result<HostKey> key = ReadHostKey(HostKeyPath(options.key_file));
  if (!key.ok()) return fail(key.error(), kExitUsage);
  HostPings pings(options.address, *public_key, *key);
  const Result<HostFacts> facts = MeasureHost(pings);
  if (!facts.ok()) return fail(facts.error(), kExitEnvironment);
  const std::vector<Diagnosis> diagnoses = DiagnoseHost(*facts, options.tick_s);
  fmt::print("{}", DiagnosisLines(diagnoses));
  return DoctorExitCode(diagnoses);
}

}  // namespace shoal
