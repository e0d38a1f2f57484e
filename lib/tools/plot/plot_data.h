// The curves of a log's vehicles, gathered event by event in bounded memory.
//
//   PlotDataBuilder builder(selection, setting);
//   while (const auto event = reader.Next()) builder.Add(*event);
//   const PlotData data = builder.Build();
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_format.h"
#include "lib/tools/plot/contact_marks.h"
#include "lib/tools/plot/plot_curve.h"
#include "lib/tools/plot/plot_setting.h"
#include "lib/tools/plot/time_marks.h"
#include "lib/tools/view/drawing_book.h"

namespace shoal {

/// Which part of a log.
struct PlotSelection {
  std::vector<std::string> vehicles;  ///< Without regard to case; empty: all.
  std::optional<double> from_s;       ///< Seconds since PlotData::zero_utime, included.
  std::optional<double> to_s;
};

/// One layer of a cascade of velocities: its weight, and the share of the budget that it asks for.
struct LayerCurves {
  ThinnedCurve weight, asks;
};

/// The layers that GUIDANCE can name, in the order of their figures.
inline constexpr std::array<std::string_view, 6> kPlottedLayers = {
    "survival", "sonar", "survival_and_sonar", "formation", "feed_forward", "waypoint"};

/// What is drawn of one vehicle. Curves over time count seconds since PlotData::zero_utime.
struct VehicleCurves {
  std::string name;    ///< By its own reports; otherwise by its channels.
  std::string color;   ///< As its reports have it; may be empty, or anything.
  ThinnedCurve track;  ///< x East, y North.
  std::optional<CurvePoint> start, end;
  std::vector<TimeMark> marks;
  std::vector<CurvePoint> steered_for;  ///< The waypoints that its helm reported, each once.
  ThinnedCurve depth_m, floor_m;        ///< Down positive; the floor under the vehicle.
  ThinnedCurve cross_track_m, crab_deg;
  ThinnedCurve expected_crab_deg;  ///< By ALOS: beta_hat.
  ThinnedCurve desired_depth_m, pitch_deg, desired_pitch_deg;
  std::array<LayerCurves, kPlottedLayers.size()> layers;
  ThinnedCurve nearest_m, target_m;  ///< To the nearest other vehicle; to the one it tracks.
  /// The age of its information about the vehicle that it follows; the oldest about any other.
  ThinnedCurve target_age_s, other_age_s;
  /// Distance from where it believes to be to where it is, and half of the long axis of the ellipse
  /// that should hold that with 95 %; where it believes to be.
  ThinnedCurve navigation_error_m, navigation_bound_m, believed_track;
  ThinnedCurve thrust_pct, propeller_rpm, rudder_deg, stern_plane_deg;
  ThinnedCurve speed_mps, desired_speed_mps, heading_deg, desired_heading_deg;
  bool dives = false;    ///< It was more than 0.1 m deep.
  bool has_rpm = false;  ///< The propeller, and likewise the others, was once not at zero.
  bool has_thrust = false;
  bool has_stern = false;
};

struct PlotData {
  std::vector<VehicleCurves> vehicles;  ///< In order of their names, in upper case.
  int64_t zero_utime = 0;               ///< What times of curves count from.
  bool zero_is_first = false;           ///< The log's first time; otherwise the mission's start.
  double first_s = 0;                   ///< Of all that was drawn.
  double last_s = 0;
  /// First and last time of the vehicles' messages in the log, selected or not; absent: there is
  /// none.
  std::optional<std::pair<double, double>> log_span_s;
  bool has_selected_times = false;  ///< Some of them lie within what is selected.
  int64_t mark_interval_s = 1;
  std::vector<CurvePoint> collisions;  ///< Each once, the first kMaxContacts.
  std::vector<CurvePoint> groundings;  ///< Likewise.
  std::vector<MapDrawing> drawings;    ///< Of programs, as they were drawn at the end.
  std::set<std::string> seen;          ///< Names in channels of all vehicles of the log.
  int64_t num_undecodable = 0;         ///< Messages on these channels that are of another type.
  int64_t num_impossible = 0;          ///< Values that no figure can show.
  bool has_too_many = false;           ///< More than kMaxPlotted vehicles: the rest is left out.
};

/// More collisions, and groundings, have no room in a figure.
inline constexpr size_t kMaxContacts = 1000;
/// A figure has no more vehicles than this.
inline constexpr size_t kMaxPlotted = 2000;

class PlotDataBuilder {
 public:
  PlotDataBuilder(PlotSelection selection, const PlotSetting& setting);

  void Add(const LogEvent& event);
  [[nodiscard]] PlotData Build();

 private:
  struct Vehicle {
    VehicleCurves curves;
    bool is_selected = true;
    std::string target;  ///< Its name in channels; empty: none.
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    std::optional<int64_t> nav_utime;        ///< Of position_m.
    std::optional<navigation_t> navigation;  ///< Waits for NAV of the same time.
    TimeMarks marks;
    std::string leg;                          ///< Which leg its helm was on; empty: none.
    std::optional<double> desired_speed_mps;  ///< The last; absent: no DESIRED has come.
    /// Of the reports that it knows; absent: of none.
    std::optional<int64_t> target_report_utime, other_report_utime;
  };

  Vehicle* Find(std::string_view channel_name);
  std::optional<double> TimeOf(int64_t utime);
  void Draw(ThinnedCurve* curve, double x, double y);
  void AddNav(Vehicle* vehicle, const nav_t& nav);
  void AddHelmState(Vehicle* vehicle, const helm_state_t& state);
  void AddActuators(Vehicle* vehicle, const actuators_t& actuators);
  void AddDesired(Vehicle* vehicle, const desired_t& desired);
  void AddGuidance(Vehicle* vehicle, const guidance_t& guidance);
  void AddSwarm(Vehicle* vehicle, const swarm_t& swarm);
  void DrawNavigation(Vehicle* vehicle);
  void AddNavigation(Vehicle* vehicle, const navigation_t& navigation);
  void DrawAge(double time_s, int64_t utime, std::optional<int64_t> report_utime,
               std::optional<int64_t>* before, ThinnedCurve* curve);
  void TakeReport(const node_report_t& report);
  void TakeDrawing(const LogEvent& event);
  void MeasureDistances();
  void MarkCollisions();
  void Mark(const Vehicle& vehicle, std::vector<CurvePoint>* marks);

  PlotSelection selection_;
  PlotData data_;
  std::optional<int64_t> zero_utime_;
  std::map<std::string, Vehicle, std::less<>> vehicles_;  ///< By their names in channels.
  std::map<std::string, std::string, std::less<>> targets_;
  ContactMarks contacts_;
  DrawingBook drawings_;
  int64_t round_utime_ = 0;  ///< Of the NAV that came last.
  bool round_is_open_ = false;
  bool has_drawn_ = false;
};

}  // namespace shoal
