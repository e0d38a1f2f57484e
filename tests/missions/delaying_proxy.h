// A long way between two computers, for tests and benchmarks on one.
#pragma once

#include <memory>

namespace shoal {

/// Carries TCP connections from a port of its own on loopback to another there, each byte after a
/// delay; or, from a moment on, no longer: the connections stay open, and nothing comes.
class DelayingProxy {
 public:
  /// Begins to listen. `delay_s`: of each direction.
  DelayingProxy(int target_port, double delay_s);
  ~DelayingProxy();
  DelayingProxy(const DelayingProxy&) = delete;
  DelayingProxy& operator=(const DelayingProxy&) = delete;

  /// Where it listens; 0: it could not.
  int port() const { return port_; }
  /// Carries nothing from now on, and keeps all connections open.
  void Stall();

 private:
  struct State;
  std::unique_ptr<State> state_;
  int port_ = 0;
};

}  // namespace shoal
