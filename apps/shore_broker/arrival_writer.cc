#include "apps/shore_broker/arrival_writer.h"

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"

namespace shoal {

namespace {

/// fate_arrivals_t: where nothing arrives.
constexpr double kNoLevel_db = -999;

double LevelOf(double power) { return power > 0 ? 10 * Log10(power) : kNoLevel_db; }

}  // namespace

void ArrivalWriter::Add(int64_t utime, const Decision& decision, const Shipment& shipment,
                        const LegEnd& end) {
  SHOAL_CHECK(end.reception != nullptr && end.reception->rays, "it came by rays");
  if (message_.arrivals.size() == kMaxPerMessage) Flush(utime);
  const RayReception& rays = *end.reception->rays;
  const bool has_arrived = rays.num_arrivals > 0;
  fate_arrivals_t& fate = message_.arrivals.emplace_back();
  fate.kind = KindText(decision.kind);
  fate.source = shipment.source;
  fate.destination = end.leg.destination;
  fate.number = decision.number;
  fate.cause = CauseText(decision.cause);
  fate.num_arrivals = rays.num_arrivals;
  fate.delay_spread_s = has_arrived ? rays.delay_spread_s : -1;
  fate.surface_bounces = has_arrived ? rays.num_surface : -1;
  fate.bottom_bounces = has_arrived ? rays.num_bottom : -1;
  fate.signal_db = LevelOf(rays.signal);
  fate.interference_db = LevelOf(rays.interference);
  fate.doppler_mps = rays.doppler_mps;
  fate.shadow = ShadowText(rays.shadow);
}

void ArrivalWriter::Flush(int64_t utime) {
  if (message_.arrivals.empty()) return;
  message_.utime = utime;
  message_.num_arrivals = static_cast<int32_t>(message_.arrivals.size());
  Publish(bus_, channel_, message_);
  message_.arrivals.clear();
}

}  // namespace shoal
