// A computer between home and a host that has the keys of both, for tests of what a link does with
// batches that are torn, repeated or too large on their way.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "tests/missions/host_farm.h"

namespace shoal {

/// Stands before the first host of a farm: home connects to it, and it to the host. Hands on the
/// batches of both directions, or what it makes of them.
class Meddler {
 public:
  /// Returns what is handed on in place of a batch.
  using Change = std::function<std::vector<Bytes>(Bytes batch)>;

  /// The changes are called in another thread; empty: batches pass as they are.
  Meddler(const HostFarm& farm, Change to_home, Change to_host);
  ~Meddler();
  Meddler(const Meddler&) = delete;
  Meddler& operator=(const Meddler&) = delete;

  /// Where home finds it.
  const std::string& address() const { return address_; }

 private:
  void Run();

  const HostFarm& farm_;
  const Change to_home_;
  const Change to_host_;
  const std::string address_;
  std::atomic<bool> listens_ = false;
  std::atomic<bool> stops_ = false;
  std::thread thread_;
};

}  // namespace shoal
