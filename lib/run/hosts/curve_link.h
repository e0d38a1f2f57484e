// Links between computers: ZeroMQ over TCP, encrypted and authenticated by CURVE. Nothing waits;
// each end has a descriptor to poll.
//
//   HostDoor door;                                     // shoal host
//   if (auto bound = door.Open("tcp://*:7700", key, {"home's public key"}); !bound.ok()) ...
//   while (auto arrival = door.Receive()) door.Send(arrival->peer, answer);
//
//   HomeLink link("tcp://lab2:7700", host_public_key, key);   // shoal run
//   while (auto bytes = link.Receive()) ...
//
// Before a descriptor is waited for, Receive must have returned nothing: ZeroMQ's descriptor
// reports changes, not states. An end that has other work takes a LinkTurn at a time, and does not
// wait before the next.
//
// Of a connection, neither end holds more than a few messages that have arrived (beyond these TCP
// holds the sender back), and kMaxWaiting_bytes of what the other end does not take.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/bus.h"
#include "lib/run/hosts/host_keys.h"
#include "lib/run/hosts/link_outbox.h"

namespace shoal {

/// The end that listens. Accepts only computers whose public keys it was given.
class HostDoor {
 public:
  HostDoor();
  ~HostDoor();
  HostDoor(const HostDoor&) = delete;
  HostDoor& operator=(const HostDoor&) = delete;

  /// Listens at `address`, "tcp://ADDRESS:PORT". The error names the address and what to try.
  [[nodiscard]] Result<bool> Open(const std::string& address, const HostKey& key,
                                  const std::set<std::string>& allowed_keys);

  struct Arrival {
    std::string peer;  ///< To be answered by Send.
    std::string key;   ///< The public key of the peer, which has proved it.
    Bytes bytes;       ///< Empty where it was no message of one frame.
  };
  /// Returns what has arrived next; nothing where there is no more. Sends what waits.
  std::optional<Arrival> Receive();
  /// Returns false where the peer is gone, or takes nothing any more.
  bool Send(const std::string& peer, std::span<const uint8_t> bytes);
  /// True where the peer has not taken what waited for it, and gets nothing any more.
  bool IsStuck(const std::string& peer) const;
  /// Returns how much waits for the peer.
  size_t WaitingBytes(const std::string& peer) const;
  /// Drops what waits for a peer.
  void Forget(const std::string& peer);

  /// Returns the public keys that were refused since the last call.
  std::vector<std::string> TakeRefusedKeys();

  /// Returns how many connections since Open have ended without a proof of a key. Those whose
  /// handshake takes more than 3 s are ended here: one that nothing comes over holds a descriptor
  /// for no longer.
  int64_t NumUnproved();
  int fd() const;

 private:
  struct Sockets;
  std::unique_ptr<Sockets> sockets_;
};

/// The end that connects, to one host.
class HomeLink {
 public:
  enum class State {
    kConnecting,
    kOpen,
    kKeyRefused,       ///< The host does not know this computer's key.
    kHandshakeFailed,  ///< Something answers, and not as the host of this key.
    kLost              ///< The connection was open, and ended.
  };

  HomeLink(const std::string& address, const std::string& host_public_key, const HostKey& key);
  ~HomeLink();
  HomeLink(const HomeLink&) = delete;
  HomeLink& operator=(const HomeLink&) = delete;

  /// Returns what has arrived next; nothing where there is no more. Learns of the link's state, and
  /// sends what waits.
  std::optional<Bytes> Receive();
  bool Send(std::span<const uint8_t> bytes);
  /// What the host has not taken yet.
  const LinkOutbox& outbox() const;
  State state() const { return state_; }
  /// Why the address cannot be used at all, or empty.
  const std::string& error() const { return error_; }
  int fd() const;

 private:
  void ReadEvents();

  struct Sockets;
  std::unique_ptr<Sockets> sockets_;
  State state_ = State::kConnecting;
  std::string error_;
};

}  // namespace shoal
