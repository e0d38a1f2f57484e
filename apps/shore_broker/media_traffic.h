// All media of a mission: which of them carries a transmission to each receiver, and when it
// arrives there.
//
//   MediaTraffic traffic(setup);
//   traffic.Place("alpha", position_m);                  // with every report
//   traffic.PlaceTruth("alpha", position_m);             // with every NAV, which then holds
//   traffic.Send(utime, std::move(shipment), rules.reports_over, take);
//   traffic.Deliver(utime, take);
//
// A medium can carry a leg where both ends have it and its rules hold where they are at that
// moment: direct always, an acoustic network whatever becomes of the packet there, radio by
// lib/sea/media/radio_link.h. Of a MediaChoice the first that can carry the leg does. Where none
// can, the fate is that of the first that both have.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/shore_broker/acoustic_traffic.h"
#include "apps/shore_broker/radio_traffic.h"
#include "apps/shore_broker/shipment.h"
#include "lib/run/broker/broker_setup.h"

namespace shoal {

class MediaTraffic {
 public:
  explicit MediaTraffic(const BrokerSetup& setup);

  /// True where vehicles have media of their own, which their positions decide about.
  bool has_media() const { return has_media_; }
  /// The network of [acoustics].
  const AcousticTraffic& acoustic() const { return *acoustics_.front(); }

  /// Sets the position of a vehicle as its report has it; one that is not of the mission has all
  /// media.
  void Place(std::string_view name, const Eigen::Vector3d& position_m);
  /// Sets where it is in truth: its reports' positions are not asked for any more.
  void PlaceTruth(std::string_view name, const Eigen::Vector3d& position_m,
                  const Eigen::Vector3d& velocity_mps = Eigen::Vector3d::Zero());

  /// Sends the shipment. Calls `take` for the legs that end at once: by direct, and those that no
  /// medium can carry.
  void Send(int64_t utime, Shipment shipment, const MediaChoice& choice, const TakeLegEnd& take);
  /// Calls `take` for each leg that has ended until `utime`, in order of time.
  void Deliver(int64_t utime, const TakeLegEnd& take);

  /// Returns why no acoustic network of a choice can send on the channel with this id; empty: one
  /// can, or none is among them.
  std::string ChannelProblem(const MediaChoice& choice, int id);

  /// Legs without a fate; copies count as one.
  int64_t num_in_transit() const;
  /// Returns a mission time before which Deliver has nothing to report, unless more is sent.
  std::optional<int64_t> NextUtime() const;

  /// The gateway that this vehicle is; null: it is not one.
  const GatewayOptions* GatewayAt(std::string_view name) const;
  /// The names of all gateways.
  std::vector<std::string> Gateways() const;

 private:
  enum class Carrier { kDirect, kAcoustic, kRadio };
  struct Medium {
    std::string name;
    Carrier carrier = Carrier::kDirect;
    size_t acoustic = 0;      ///< Of kAcoustic: which of acoustics_.
    RadioOptions radio = {};  ///< Of kRadio, as the next.
    RadioTerms terms = {};
  };
  struct Node {
    std::string key;
    size_t number = 0;  ///< In order of appearance.
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    bool is_true = false;      ///< The position is NAV's.
    std::vector<uint8_t> has;  ///< By medium.
    double antenna_height_m = -1;
    GatewayOptions gateway;
    /// The names of random numbers of what this node sends over radio, by medium and kind, then by
    /// the receiver's number: a name takes longer to make than all else about a leg.
    std::vector<std::vector<std::optional<RadioDraws>>> draws;
  };
  /// The node of a contact of the router, by its index: found once, and again where another has
  /// taken the index.
  struct KnownNode {
    std::string name;
    const Node* node = nullptr;
  };
  /// What one medium would make of a leg.
  struct Answer {
    std::optional<Cause> cause;  ///< Absent: it can carry the leg.
    RadioLink radio = {};
  };

  /// Returns the node of this name; a new one has all media. Null where there is no room: made-up
  /// names must not fill the memory.
  Node* FindOrAdd(std::string_view name);
  /// Returns the node of this name, or one that has no radio.
  const Node& NodeOf(std::string_view name) const;
  /// Returns the node of a leg's receiver, likewise.
  const Node& ReceiverOf(const ShipmentLeg& leg);
  const RadioDraws& DrawsOf(size_t medium, Kind kind, Node* source, const Node& receiver);
  void SetPosition(std::string_view name, const Eigen::Vector3d& position_m,
                   const Eigen::Vector3d& velocity_mps, Node* node);
  const std::vector<size_t>& Resolve(const MediaChoice& choice);
  Answer Ask(const Medium& medium, const Node& source, const Node& receiver) const;
  void SendOver(size_t medium, int64_t utime, std::string_view source,
                const std::shared_ptr<const Shipment>& shipment, std::vector<ShipmentLeg>* legs,
                const TakeLegEnd& take);
  /// Hands a leg's end on, unless it is a copy that decides nothing.
  void End(const LegEnd& end, const TakeLegEnd& take);

  const BrokerSetup& setup_;
  bool has_media_;
  std::vector<Medium> media_;
  std::vector<std::unique_ptr<AcousticTraffic>> acoustics_;
  RadioTraffic radio_;
  std::map<std::string, Node, std::less<>> nodes_;  ///< By key of the name.
  Node unknown_node_;
  std::vector<KnownNode> known_nodes_;                    ///< By index of the router's contact.
  std::vector<std::vector<ShipmentLeg>> legs_by_medium_;  ///< Of one shipment; kept for its memory.
  std::map<std::string, std::vector<size_t>, std::less<>> resolved_;  ///< By TextOf a choice.
  std::optional<int64_t> delivered_utime_;                            ///< Of the last Deliver.
  int64_t num_surplus_ = 0;  ///< Copies whose ends decide nothing.
};

}  // namespace shoal
