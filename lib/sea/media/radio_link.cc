#include "lib/sea/media/radio_link.h"

#include <algorithm>

namespace shoal {

namespace {

/// Returns how high an antenna stands above the water; 0 where it does not.
double HeightOf(const RadioOptions& options, const RadioEnd& end) {
  const double own_m = end.antenna_height_m < 0 ? options.antenna_height_m : end.antenna_height_m;
  return std::max(own_m - end.position_m.z(), 0.0);
}

void AskSignal(const RadioOptions& options, const TwoRayTerms& terms, double height_m,
               double other_height_m, RadioLink* link) {
  link->path_loss_limit_db = options.power_dbm - options.sensitivity_dbm;
  double reach_m = 0;
  if (options.path_loss == PathLossModel::kTwoRay) {
    link->path_loss_db =
        TwoRayLoss_db(terms, link->range_m, options.frequency_mhz, height_m, other_height_m);
    reach_m = TwoRayReach_m(terms, options.frequency_mhz, height_m, other_height_m);
  } else {
    link->path_loss_db = LogDistanceLoss_db(link->range_m, options.frequency_mhz, options.exponent);
    reach_m = LogDistanceReach_m(link->path_loss_limit_db, options.frequency_mhz, options.exponent);
  }
  if (link->path_loss_db > link->path_loss_limit_db) {
    link->fault = RadioFault::kWeakSignal;
    link->limit_m = reach_m;
  } else {
    link->limit_m = link->limit_m < 0 ? reach_m : std::min(link->limit_m, reach_m);
  }
}

}  // namespace

RadioTerms TermsOf(const RadioOptions& options) {
  const double height_m = std::max(options.antenna_height_m, 0.0);
  RadioTerms terms;
  if (options.horizon) terms.horizon_m = RadioHorizon_m(height_m, height_m);
  if (options.path_loss == PathLossModel::kTwoRay) {
    terms.two_ray =
        TwoRayTermsOf(options.power_dbm - options.sensitivity_dbm, options.frequency_mhz, height_m);
  }
  return terms;
}

RadioLink DecideRadio(const RadioOptions& options, const RadioEnd& source,
                      const RadioEnd& receiver) {
  return DecideRadio(options, TermsOf(options), source, receiver);
}

RadioLink DecideRadio(const RadioOptions& options, const RadioTerms& terms, const RadioEnd& source,
                      const RadioEnd& receiver) {
  RadioLink link;
  link.depth_m = std::max({source.position_m.z(), receiver.position_m.z(), 0.0});
  link.depth_limit_m = options.surface_depth_m;
  if (link.depth_m > link.depth_limit_m) {
    link.fault = RadioFault::kSubmerged;
    return link;
  }
  link.range_m = (receiver.position_m - source.position_m).norm();
  const double height_m = HeightOf(options, source);
  const double other_height_m = HeightOf(options, receiver);
  if (options.horizon) {
    const double usual_m = options.antenna_height_m;
    link.horizon_m = height_m == usual_m && other_height_m == usual_m
                         ? terms.horizon_m
                         : RadioHorizon_m(height_m, other_height_m);
    link.limit_m = link.horizon_m;
    if (!(link.range_m < link.limit_m)) {
      link.fault = RadioFault::kBelowHorizon;
      return link;
    }
  }
  if (options.range_m >= 0) {
    const bool is_out = !(link.range_m < options.range_m);
    link.limit_m =
        link.limit_m < 0 || is_out ? options.range_m : std::min(link.limit_m, options.range_m);
    if (is_out) {
      link.fault = RadioFault::kOutOfRange;
      return link;
    }
  }
  if (options.path_loss != PathLossModel::kNone)
    AskSignal(options, terms.two_ray, height_m, other_height_m, &link);
  return link;
}

RadioDraws RadioDrawsOf(uint64_t seed, std::string_view medium, std::string_view kind,
                        std::string_view source, std::string_view receiver) {
  const auto key = [&](std::string_view purpose) {
    return StreamKey(seed, purpose).With(medium).With(kind).With(source).With(receiver);
  };
  return {.jitter = key("radio jitter"), .loss = key("radio loss")};
}

RadioPassage DrawPassage(const RadioOptions& options, int64_t num_bytes, const RadioDraws& draws,
                         int64_t number) {
  const auto draw = [&](const StreamKey& key) { return Stream(key.With(number)).Uniform(); };
  RadioPassage passage;
  if (options.rate_bps > 0) {
    passage.air_s = 8 * static_cast<double>(num_bytes) / options.rate_bps;
  }
  passage.delay_s = passage.air_s + options.latency_s;
  if (options.jitter_s > 0) passage.delay_s += options.jitter_s * draw(draws.jitter);
  if (options.loss > 0) passage.is_lost = draw(draws.loss) < options.loss;
  return passage;
}

}  // namespace shoal
