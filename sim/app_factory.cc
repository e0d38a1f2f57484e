#include "sim/app_factory.h"

#include "apps/acomms/acomms_app.h"
#include "apps/gateway/gateway_app.h"
#include "apps/helm/helm_app.h"
#include "apps/node_reporter/node_reporter_app.h"
#include "apps/shore_broker/shore_broker_app.h"
#include "apps/vehicle_sim/vehicle_sim_app.h"
#include "lib/base/check/check.h"
#include "lib/bus/bus/memory_bus.h"
#include "sim/director_app.h"

namespace shoal {

std::unique_ptr<App> MakeApp(const RosterEntry& entry, const Mission& mission, Bus& bus) {
  if (entry.app == "shore_broker") return std::make_unique<ShoreBrokerApp>(mission, bus);
  SHOAL_CHECK(entry.vehicle_place < mission.vehicles.size() &&
                  mission.vehicles[entry.vehicle_place].name == entry.vehicle,
              "a roster names only vehicles of its mission");
  const Vehicle& vehicle = mission.vehicles[entry.vehicle_place];
  if (entry.app == "vehicle_sim") return std::make_unique<VehicleSimApp>(mission, vehicle, bus);
  if (entry.app == "helm") return std::make_unique<HelmApp>(mission, vehicle, bus);
  if (entry.app == "acomms") return std::make_unique<AcommsApp>(mission, vehicle, bus);
  if (entry.app == "gateway") return std::make_unique<GatewayApp>(mission, vehicle, bus);
  SHOAL_CHECK(entry.app == "node_reporter", "a roster names only shoal's own apps");
  return std::make_unique<NodeReporterApp>(mission, vehicle, bus);
}

LaunchedApps AppsToLaunch() {
  return {.make_director = [](const Mission& mission,
                              Bus& bus) { return std::make_unique<DirectorApp>(mission, bus); },
          .subscriptions_of =
              [](const RosterEntry& entry, const Mission& mission) {
                MemoryBus hub;
                const std::unique_ptr<App> app = MakeApp(entry, mission, hub.Join(entry.name));
                const std::vector<std::string_view> channels = hub.SubscribedChannels();
                return std::vector<std::string>(channels.begin(), channels.end());
              }};
}

std::unique_ptr<Broker> MakeShoreBroker(const BrokerSetup& setup, Bus& bus) {
  return std::make_unique<ShoreBrokerApp>(setup, bus);
}

std::unique_ptr<Broker> MakeSharedBroker(const Mission& mission, Bus& bus, BrokerShare share) {
  return std::make_unique<ShoreBrokerApp>(SetupOf(mission), bus, std::move(share));
}

}  // namespace shoal
