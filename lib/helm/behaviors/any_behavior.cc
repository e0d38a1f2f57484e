#include "lib/helm/behaviors/any_behavior.h"

#include <type_traits>
#include <utility>

#include "lib/base/check/check.h"

namespace shoal {

namespace {

// Which class runs which options: the type that Of() has for them.
struct ClassOfOptions {
  static WaypointBehavior Of(const WaypointOptions&);
  static LoiterBehavior Of(const LoiterOptions&);
  static StationKeepBehavior Of(const StationKeepOptions&);
  static AvoidCollisionBehavior Of(const AvoidCollisionOptions&);
  static ConstantDepthBehavior Of(const ConstantDepthOptions&);
  static ColregsBehavior Of(const ColregsOptions&);
  static ConstantSpeedBehavior Of(const ConstantSpeedOptions&);
  static ConstantHeadingBehavior Of(const ConstantHeadingOptions&);
  static AvoidObstacleBehavior Of(const AvoidObstacleOptions&);
  static TimerBehavior Of(const TimerOptions&);
  static PeriodicSurfaceBehavior Of(const PeriodicSurfaceOptions&);
  static TrailBehavior Of(const TrailOptions&);
  static MaxDepthBehavior Of(const MaxDepthOptions&);
  static MaxSpeedBehavior Of(const MaxSpeedOptions&);
  static CutRangeBehavior Of(const CutRangeOptions&);
  static ConvoyBehavior Of(const ConvoyOptions&);
  static GoToDepthBehavior Of(const GoToDepthOptions&);
  static LegRunBehavior Of(const LegRunOptions&);
  static OpRegionBehavior Of(const OpRegionOptions&);
  static MemoryTurnLimitBehavior Of(const MemoryTurnLimitOptions&);
  static PeriodicSpeedBehavior Of(const PeriodicSpeedOptions&);
  static ShadowBehavior Of(const ShadowOptions&);
  static FixedTurnBehavior Of(const FixedTurnOptions&);
  static ZigzagBehavior Of(const ZigzagOptions&);
  static FullStopBehavior Of(const FullStopOptions&);
  static TestFailureBehavior Of(const TestFailureOptions&);
  static MaintainHeadingBehavior Of(const MaintainHeadingOptions&);
  static HeadingBiasBehavior Of(const HeadingBiasOptions&);
  static HysteresisBehavior Of(const HysteresisOptions&);
  static MinAltitudeBehavior Of(const MinAltitudeOptions&);
  static RubberBandBehavior Of(const RubberBandOptions&);
};

template <class Options>
using ClassOf = decltype(ClassOfOptions::Of(std::declval<const Options&>()));

template <size_t... kIndices>
std::vector<AnyBehavior> OneOfEach(std::index_sequence<kIndices...>) {
  return {AnyBehavior(std::in_place_index<kIndices>)...};
}

}  // namespace

std::string_view KindOf(const AnyBehavior& what) {
  return std::visit([](const auto& options) { return options.kKind; }, what);
}

std::vector<AnyBehavior> OneBehaviorOfEachKind() {
  return OneOfEach(std::make_index_sequence<std::variant_size_v<AnyBehavior>>());
}

std::unique_ptr<Behavior> MakeBehavior(const BehaviorOptions& options) {
  return std::visit(
      []<class Options>(const Options& what) -> std::unique_ptr<Behavior> {
        return std::make_unique<ClassOf<Options>>(what);
      },
      options.what);
}

void Reconfigure(Behavior& behavior, const AnyBehavior& what) {
  std::visit(
      [&]<class Options>(const Options& options) {
        auto* same_kind = dynamic_cast<BehaviorWith<Options>*>(&behavior);
        SHOAL_CHECK(same_kind != nullptr, "an update has options of the behavior's own kind");
        same_kind->Reconfigure(options);
      },
      what);
}

std::string* ContactOf(AnyBehavior& what) {
  return std::visit(
      [](auto& options) -> std::string* {
        if constexpr (requires { options.contact.contact; }) {
          return &options.contact.contact;
        } else {
          return nullptr;
        }
      },
      what);
}

}  // namespace shoal
