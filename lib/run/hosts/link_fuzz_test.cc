// What a link brings may be anything: messages with turned, cut, repeated and foreign bytes under a
// digest, and a seal, that fit them. Nothing may crash, read beyond its input, or keep more than
// it.
#include <gtest/gtest.h>
#include <sodium.h>

#include <random>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/hosts/home_relay.h"
#include "lib/run/hosts/host_offer.h"
#include "lib/run/hosts/host_relay.h"
#include "lib/run/run/network_testing.h"
#include "shoal/step_dones_t.hpp"

namespace shoal::link_fuzz_test {

constexpr int64_t kMissionId = 4711;
constexpr size_t kDigest_bytes = 32;

class Mutator {
 public:
  /// Turns, cuts, repeats or replaces some bytes of `bytes` from `first` on.
  void Mutate(size_t first, Bytes* bytes) {
    for (size_t i = 1 + Below(3); i > 0 && bytes->size() > first; --i) {
      const size_t at = first + Below(bytes->size() - first);
      const auto place = bytes->begin() + static_cast<std::ptrdiff_t>(at);
      const size_t length = std::min(1 + Below(16), bytes->size() - at);
      const Bytes piece(place, place + static_cast<std::ptrdiff_t>(length));
      switch (Below(5)) {
        case 0:
          bytes->erase(place, place + static_cast<std::ptrdiff_t>(length));
          break;
        case 1:
          bytes->insert(place, piece.begin(), piece.end());
          break;
        case 2:  // Counts and lengths like these are believed most easily.
          std::fill_n(place, length, static_cast<uint8_t>(Below(2) == 0 ? 0x00 : 0xff));
          break;
        case 3:
          *place = static_cast<uint8_t>(Below(256));
          break;
        default:
          *place = static_cast<uint8_t>(*place ^ 1 << Below(8));
      }
    }
  }
  size_t Below(size_t limit) {
    return std::uniform_int_distribution<size_t>(0, limit - 1)(random_);
  }

 private:
  std::mt19937 random_{20};
};

/// One of each kind that has parts of its own.
std::vector<Bytes> Examples() {
  HostOffer offer{.build = {.version = "1", .build = "b", .arithmetic = "a"},
                  .host = "lab2",
                  .files = {{.path = "m.toml", .text = "[mission]"}, {.path = "g", .text = ""}},
                  .overrides = {"mission.seed=2"},
                  .digest = "d",
                  .participants = {"helm_alpha"},
                  .secret = {},
                  .timeout_s = 0.9};
  LinkMessage batch{.kind = LinkKind::kTick, .mission_id = kMissionId, .step = 3};
  batch.AddText("NAV_ALPHA", "abcdefgh");
  batch.AddText("TICK", "");
  const HostExit exit{.name = "helm_alpha", .pid = 12, .how = "exited", .last_lines = {"a", "b"}};
  std::vector<Bytes> examples;
  for (const LinkMessage& each :
       {ToLinkMessage(offer, kMissionId), batch, ToLinkMessage(exit, kMissionId)}) {
    examples.push_back(EncodeLinkMessage(each, 0));
  }
  return examples;
}

TEST(LinkFuzz, TakesNoMoreThanItWasGiven) {
  Mutator mutator;
  const std::vector<Bytes> examples = Examples();
  int num_taken = 0;
  constexpr int kMutations = 100'000;
  for (int i = 0; i < kMutations; ++i) {
    Bytes bytes = examples[mutator.Below(examples.size())];
    bytes.resize(bytes.size() - kDigest_bytes);
    mutator.Mutate(mutator.Below(3) == 0 ? 0 : 4, &bytes);  // Mostly past the magic number.
    const size_t size = bytes.size();
    bytes.resize(size + kDigest_bytes);
    crypto_generichash(bytes.data() + size, kDigest_bytes, bytes.data(), size, nullptr, 0);
    LinkIntake intake;
    const Result<LinkMessage> taken = intake.Take(bytes);
    EXPECT_EQ(intake.num_refused(), taken.ok() ? 0 : 1);
    if (!taken.ok()) continue;
    ++num_taken;
    size_t content = 0;
    for (const LinkPart& part : taken->parts) content += part.name.size() + part.data.size();
    ASSERT_LE(content, bytes.size());
    const Result<HostOffer> offer = OfferOf(*taken);
    if (offer.ok()) {
      ASSERT_LE(offer->files.size(), taken->parts.size());
    }
    ASSERT_LE(ExitOf(*taken).last_lines.size(), taken->parts.size());
  }
  // Both what is refused and what comes through are many.
  EXPECT_GT(num_taken, kMutations / 20);
  EXPECT_LT(num_taken, kMutations * 19 / 20);
}

/// Encodes a message, mutates it and seals it with the mission's secret, as a faulty program would.
template <class T>
Bytes SealedMutation(Mutator* mutator, const T& message, const std::string& publisher, int64_t step,
                     std::string_view channel) {
  Bytes bytes;
  EncodeInto(message, &bytes);
  mutator->Mutate(mutator->Below(4) == 0 ? 0 : 8, &bytes);  // Mostly with its fingerprint.
  AppendSeal({.publisher = publisher, .mission_id = kMissionId, .step = step, .sequence = 0}, {},
             channel, &bytes);
  return bytes;
}

tick_t TickOf(int64_t step) {
  tick_t tick{};
  tick.mission_id = kMissionId;
  tick.step = step;
  tick.joined = {"b", "d"};
  tick.joined_pids = {1, 1};
  tick.num_joined = 2;
  tick.totals = {{.publisher = "b", .channel = "NAV_BRAVO", .count = 1}};
  tick.num_totals = 1;
  return tick;
}

step_dones_t AnswersOf(int64_t step) {
  step_dones_t answers{};
  for (const std::string name : {"b", "d"}) {
    step_done_t& done = answers.dones.emplace_back();
    done.mission_id = kMissionId;
    done.step = step;
    done.participant = name;
    done.pid = 1;
  }
  answers.num_dones = 2;
  return answers;
}

TEST(LinkFuzz, MeetsRelaysThatDecodeWhatIsSealed) {
  Mutator mutator;
  FakeNetwork network;
  const PortPlan plan(7665, Layout::kShared, {});
  FakeNetwork::Node& home_node = network.Add();
  FakeNetwork::Node& host_node = network.Add();
  int num_to_host = 0;
  int num_to_home = 0;
  HomeRelay home({.name = "home", .mission_id = kMissionId}, plan, home_node,
                 {{.participants = {"b", "d"},
                   .wants = [](std::string_view) { return true; },
                   .may_publish = ChannelsFrom({"b", "d"}, {"b", "d"}, {})}},
                 [&](size_t, const LinkMessage&) { ++num_to_host; });
  HostRelay host({.name = "host", .mission_id = kMissionId}, plan, host_node, {"b", "d"},
                 [&](const LinkMessage&) { ++num_to_home; });
  home.SetConnected(0, true);
  constexpr int kSteps = 20'000;
  int num_begun = 0;
  for (int64_t step = 0; step < kSteps; ++step) {
    LinkMessage batch{.kind = LinkKind::kTick, .mission_id = kMissionId, .step = step};
    batch.parts.push_back(
        {.name = std::string(topics::kTick),
         .data = SealedMutation(&mutator, TickOf(step), "clock", step, topics::kTick)});
    num_begun += host.OnMessage(batch, step).empty() ? 1 : 0;
    const Bytes answers = SealedMutation(&mutator, AnswersOf(step), "b", step, topics::kStepDones);
    host.OnDatagram(plan.done_port(), topics::kStepDones, answers, step);
    home.OnMessage(0,
                   {.kind = LinkKind::kDone,
                    .mission_id = kMissionId,
                    .step = step,
                    .parts = {{.name = std::string(topics::kStepDones), .data = answers}}},
                   step);
    home.OnDatagram(plan.tick_port(), topics::kTick, batch.parts.front().data, step);
    host.OnTime(step);
    home.OnTime(step);
  }
  // Many get through, and many are refused.
  EXPECT_GT(num_begun, kSteps / 20);
  EXPECT_LT(num_begun, kSteps * 19 / 20);
  EXPECT_GT(num_to_home, kSteps / 100);
  EXPECT_GT(home.num_refused(), kSteps / 20);
  EXPECT_LT(home.num_refused(), kSteps);
  // One batch per step at most, whatever it holds.
  EXPECT_LE(num_to_home, kSteps);
  EXPECT_LE(num_to_host, kSteps);
}

}  // namespace shoal::link_fuzz_test
