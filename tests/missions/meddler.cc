#include "tests/missions/meddler.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <deque>
#include <memory>

#include "lib/run/hosts/curve_link.h"

namespace shoal {

namespace {

std::vector<Bytes> Changed(const Meddler::Change& change, Bytes batch) {
  return change ? change(std::move(batch)) : std::vector<Bytes>{std::move(batch)};
}

}  // namespace

Meddler::Meddler(const HostFarm& farm, Change to_home, Change to_host)
    : farm_(farm),
      to_home_(std::move(to_home)),
      to_host_(std::move(to_host)),
      address_("tcp://127.0.0.1:" + std::to_string(FreeTcpPorts(1))),
      thread_([this] { Run(); }) {
  EXPECT_TRUE(AwaitThat([this] { return listens_.load(); }));
}

Meddler::~Meddler() {
  stops_ = true;
  thread_.join();
}

void Meddler::Run() {
  const HostKey home_key = *ReadHostKey(farm_.home_key + ".key");
  const HostKey host_key = *ReadHostKey((farm_.folder / (farm_.hosts[0].name + ".key")).string());
  auto door = std::make_unique<HostDoor>();
  EXPECT_TRUE(door->Open(address_, host_key, {home_key.public_key}).ok());
  listens_ = true;
  HomeLink link(farm_.hosts[0].address, host_key.public_key, home_key);
  std::string home;
  std::deque<Bytes> for_host;  // Waits for the link to open.
  while (!stops_) {
    std::array<pollfd, 2> waited = {
        pollfd{.fd = link.fd(), .events = POLLIN, .revents = 0},
        pollfd{.fd = door ? door->fd() : -1, .events = POLLIN, .revents = 0}};
    poll(waited.data(), waited.size(), for_host.empty() ? 5 : 1);
    while (auto batch = link.Receive()) {
      for (const Bytes& each : Changed(to_home_, std::move(*batch))) {
        if (door) door->Send(home, each);
      }
    }
    while (auto arrival = door ? door->Receive() : std::nullopt) {
      home = arrival->peer;
      for (Bytes& each : Changed(to_host_, std::move(arrival->bytes))) {
        for_host.push_back(std::move(each));
      }
    }
    while (!for_host.empty() && link.Send(for_host.front())) for_host.pop_front();
    if (link.state() == HomeLink::State::kLost) door.reset();  // As the host's own end would be.
  }
}

}  // namespace shoal
