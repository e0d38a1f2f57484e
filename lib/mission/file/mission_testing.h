// Random missions, for tests of the loader only.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/mission/file/track_of.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/model/mission.h"
#include "lib/mission/model/swarm_plan.h"

namespace shoal {

/// Draws missions that use every field; the same seed, the same missions.
class MissionDraw {
 public:
  explicit MissionDraw(uint64_t seed) : generator_(seed) {}

  Mission Draw() {
    Mission mission;
    mission.name = Text();
    mission.description = Text() + "\nsecond line\t\"quoted\" \\";
    mission.seed = static_cast<uint64_t>(Integer(0, INT64_MAX));
    // Underwater vehicles need short steps.
    mission.tick_us = Integer(1000, Coin() ? 200'000 : 10'000'000);
    mission.duration_s = Seconds(mission.tick_us * Integer(1, 1000));
    mission.start_utime = Integer(0, 9'000'000'000'000'000);
    mission.origin_lat_deg = Number(-90, 90);
    mission.origin_lon_deg = Number(-180, 180);
    if (Coin()) mission.op_area_m = {Point(), Point(), Point()};
    if (Coin()) mission.backgrounds = {"coast.geojson", "charts/bay.png"};
    mission.collisions = static_cast<CollisionVerdict>(Integer(0, 1));
    mission.on_loss = static_cast<OnLoss>(Integer(0, 2));
    mission.participant_timeout_s = Number(0.1, 3600);
    mission.broker = DrawProvider();
    mission.environment = DrawEnvironment();
    mission.comms = {.comms_range_m = Coin() ? -1 : Number(0, 1e7),
                     .critical_range_m = Number(0, 1e7),
                     .stale_time_s = Coin() ? -1 : Number(0, 1e7),
                     .stale_forget_s = Number(-1, 1e7),
                     .groups = Coin(),
                     .msg_groups = Coin(),
                     .ignore_group = Coin() ? "" : Text(),
                     .min_rpt_interval_s = Number(-1, 1e7),
                     .min_msg_interval_s = Number(-1, 1e7),
                     .max_msg_length_bytes = Integer(0, 1'000'000'000),
                     .drop_percentage = Number(0, 100),
                     .reports_over = Coin() ? Over("acoustic") : Over("direct"),
                     .messages_over = Coin() ? Over("acoustic") : Over("direct"),
                     .shared_node_reports_s = Coin() ? -1 : Number(0, 1e7),
                     .pulse_duration_s = Number(0, 1e7),
                     .view_node_rpt_pulses = Coin(),
                     .msg_color = Text(),
                     .msg_repeat_color = Text(),
                     .each_fate_up_to = Integer(0, 1'000'000)};
    DrawSurveyArea();
    mission.obstacles = {{"rock", Square()}, {"wreck", Square()}};
    DrawBeacons(&mission.beacons);
    for (int64_t i = 2; i > 0; --i) mission.vehicles.push_back(DrawVehicle(i));
    if (mission.tick_us <= 200'000) Submerge(&mission.vehicles[0]);
    mission_navigates_ =
        std::all_of(mission.vehicles.begin(), mission.vehicles.end(),
                    [](const Vehicle& vehicle) { return vehicle.navigation.is_fitted; });
    has_floor_ = mission.environment.floor.style != "none";
    const bool over_water = mission.comms.reports_over.Has(kAcousticMedium) ||
                            mission.comms.messages_over.Has(kAcousticMedium);
    if (over_water || Coin()) mission.acoustics = DrawAcoustics();
    const int first_address = mission.acoustics.options.broadcast_address < 1000 ? 1000 : 1;
    for (Vehicle& vehicle : mission.vehicles) {
      vehicle.acoustic_address = first_address + static_cast<int>(&vehicle - &mission.vehicles[0]);
      vehicle.acoustic_leader = Coin();
      if (Coin()) vehicle.modem_depth_m = Number(0, 1000);
    }
    mission.vehicles[0].acoustic_leader = true;
    if (mission.acoustics.is_used) DrawSwarm(&mission);
    if (Coin()) DrawNetsim(&mission);
    if (Coin()) DrawMedia(&mission);
    double at_s = 0;
    for (int64_t i = Integer(0, 4); i > 0; --i) {
      at_s = Number(at_s, mission.duration_s);
      mission.events.push_back(DrawEvent(at_s));
    }
    for (int64_t i = Integer(0, 2); i > 0; --i) {
      mission.participants.push_back({"planner_" + std::to_string(i), {Text(), "", Text()}});
    }
    if (Coin()) DrawHosts(&mission);
    for (int64_t i = Integer(0, 6); i > 0; --i) {
      mission.expectations.push_back(DrawExpectation(mission.duration_s));
    }
    SeedPaths(mission);
    if (Coin()) {
      AddPassive(&mission, "buoy", BuoyParams{.watch_radius_m = Number(0, 10'000)},
                 {.x_m = 5000, .y_m = 5000});
    } else if (Coin()) {
      AddTrack(&mission);
    }
    return mission;
  }

  /// Of a network with room for three channels at least.
  Acoustics DrawAcoustics() {
    AcousticOptions options = {.access_mode = static_cast<AccessMode>(Integer(0, 3)),
                               .channel_order = static_cast<ChannelOrder>(Integer(0, 1)),
                               .jitter = static_cast<JitterModel>(Integer(0, 1)),
                               .collisions = static_cast<CollisionModel>(Integer(0, 2)),
                               .packet_loss_model = static_cast<PacketLossModel>(Integer(0, 3)),
                               .bit_error_model = static_cast<BitErrorModel>(Integer(0, 3)),
                               .half_duplex = Coin()};
    options.sound_speed_mps = Number(1, 100'000);
    options.guard_band_khz = Number(0, 100);
    options.channel_bandwidth_khz = Number(1e-4, 100);
    options.bandwidth_khz =
        3 * options.channel_bandwidth_khz + 4 * options.guard_band_khz + Number(0.1, 1000);
    options.base_freq_khz = options.bandwidth_khz * 0.501 + Number(0, 1000);
    options.broadcast_address = static_cast<int>(Integer(0, 1'000'000'000));
    options.data_rate_bps = Number(0.1, 1e9);
    options.max_jitter_s = Number(0, 86'400);
    options.nominal_distance_m = Positive(1e9);
    options.packet_loss = Number(0, 1);
    options.packet_loss_distance_m = Positive(1e9);
    options.bit_error_rate = Number(0, 0.5);
    options.bit_error_distance_m = Positive(1e9);
    options.snr_nominal_db = Number(-1000, 1000);
    options.snr_slope = Number(0, 1000);
    if (Coin()) options.modem = DrawModem();
    if (options.modem && Coin()) options.packet_loss_model = PacketLossModel::kModem;
    if (options.modem && options.modem->code == BlockCode() &&
        options.packet_loss_model != PacketLossModel::kModem) {
      options.bit_error_model = BitErrorModel::kModem;
    }
    options.sea = {.water = {.temperature_degc = Number(-2, 30),
                             .salinity_ppt = Number(0, 40),
                             .depth_m = Number(0, 8000),
                             .ph = Number(6, 9)},
                   .noise = {.shipping = Number(0, 1), .wind_mps = Number(0, 40)},
                   .absorption = static_cast<AbsorptionModel>(Integer(0, 1)),
                   .spreading_exponent = Number(0.5, 4)};
    return {.is_used = true, .crc = Coin(), .options = options};
  }

 private:
  /// A track of the missions, in metres from the origin: it starts where its file has it.
  void AddTrack(Mission* mission) {
    const TrackOptions options = {
        .file = std::string(SHOAL_SOURCE_DIR) + "/missions/tracks/launch.csv",
        .time = Coin() ? TrackTime::kFirst : TrackTime::kAbsolute,
        .delay_s = Number(-1e7, 1e7)};
    AddPassive(mission, "track", options, StartOf(*TrackOf(*mission, options)));
  }

  /// It has no task that "all" could be expected to do.
  void AddPassive(Mission* mission, const std::string& name, const AnyModel& model,
                  const StartPose& start) {
    Vehicle vehicle;
    vehicle.name = name;
    vehicle.type = name;
    vehicle.model = model;
    vehicle.helm = Provider::kNone;
    vehicle.start = start;
    vehicle.return_task.point_m = {start.x_m, start.y_m};
    vehicle.acoustic_address = mission->vehicles.back().acoustic_address + 1;
    if (mission->HasMedia()) vehicle.media.names = {"direct"};
    mission->vehicles.push_back(vehicle);
    mission->events.clear();
    mission->expectations.clear();
  }

  /// Two more media, and what the vehicles have of them.
  void DrawHosts(Mission* mission) {
    HostOptions host{.name = "lab2",
                     .address = "tcp://10.0.0.2:7700",
                     .key = Text(),
                     .on_loss = static_cast<OnLoss>(Integer(0, 2)),
                     .timeout_s = Number(0.1, 3600)};
    if (Coin()) host.vehicles = {mission->vehicles[0].name};
    for (const Participant& each : mission->participants) host.participants.push_back(each.name);
    mission->hosts = {host, {.name = "lab3", .address = {}, .key = {}}};
  }

  void DrawMedia(Mission* mission) {
    MediumOptions radio = {.name = "vhf", .kind = MediumKind::kRadio};
    radio.radio = {.range_m = Coin() ? -1 : Number(0, 1e6),
                   .surface_depth_m = Number(0, 100),
                   .antenna_height_m = Number(0, 1000),
                   .horizon = Coin(),
                   .path_loss = static_cast<PathLossModel>(Integer(0, 2)),
                   .frequency_mhz = Number(0.01, 1e6),
                   .power_dbm = Number(-100, 100),
                   .sensitivity_dbm = Number(-250, 100),
                   .exponent = Number(1, 10),
                   .rate_bps = Number(0, 1e12),
                   .latency_s = Number(0, 86'400),
                   .jitter_s = Number(0, 86'400),
                   .loss = Number(0, 1)};
    MediumOptions sound = {.name = "sound", .kind = MediumKind::kAcoustic};
    sound.acoustics = DrawAcoustics();
    sound.acoustics.options.access_mode = AccessMode::kShared;
    mission->media = {radio, sound};
    for (Vehicle& vehicle : mission->vehicles) {
      vehicle.media.names = {"vhf", "acoustic"};
      if (Coin()) vehicle.media.antenna_height_m = Number(0, 1000);
    }
    const bool has_reporter = mission->vehicles.back().reporter != Provider::kNone;
    if (has_reporter && !mission->vehicles.back().is_outside && Coin()) {
      mission->vehicles.back().media.gateway = {.exists = true,
                                                .from = {"acoustic"},
                                                .to = {"vhf", "direct"},
                                                .reports = Coin(),
                                                .messages = Coin(),
                                                .queue = Integer(1, 100'000),
                                                .rate_hz = Positive(1000),
                                                .max_hops = Integer(1, 16)};
    }
    mission->comms.reports_over = {.names = {"vhf", "sound"}, .at_once = Coin()};
  }

  int64_t Integer(int64_t min, int64_t max) {
    return std::uniform_int_distribution<int64_t>(min, max)(generator_);
  }
  bool Coin() { return Integer(0, 1) == 1; }
  /// In [min, max], the ends more often than by chance.
  double Number(double min, double max) {
    const int64_t choice = Integer(0, 9);
    if (choice == 0) return min;
    if (choice == 1) return max;
    return std::clamp(std::uniform_real_distribution<double>(min, max)(generator_), min, max);
  }
  double Positive(double max) { return Number(1e-300, max); }
  Eigen::Vector2d Point() { return {Number(-1e6, 1e6), Number(-1e6, 1e6)}; }
  Provider DrawProvider() { return static_cast<Provider>(Integer(0, 2)); }

  std::string Text() {
    constexpr std::array<const char*, 12> kPieces = {
        "a", "Z", "7", " ", "\"", "\\", "'", "#", "=", "\xC3\xA9", "\xF0\x9F\x90\x9F", "]"};
    std::string text = "t";
    for (int64_t i = Integer(0, 12); i > 0; --i) {
      text += kPieces.at(static_cast<size_t>(Integer(0, kPieces.size() - 1)));
    }
    return text;
  }

  Environment DrawEnvironment() {
    Environment environment;
    CurrentWords& current = environment.current;
    if (Coin()) current.speed_mps = Coin() ? "0.25" : "0.125..0.5";
    if (Coin()) current.direction_deg = Coin() ? "-90" : "northeast";
    if (Coin()) current.speed_deviation_mps = "steady";
    if (Coin()) current.direction_deviation_deg = "10..20";
    if (Coin()) current.speed_half_period_s = "choppy";
    if (Coin()) current.direction_half_period_s = "30.5";
    if (Coin()) {
      environment.floor = {.style = "flat",
                           .depth_m = Number(0, 20'000),
                           .range_m = Number(0, 20'000),
                           .size_m = Number(1, 1e6),
                           .scale_m = Number(1, 1e6),
                           .slope_east = Number(-10, 10),
                           .slope_north = Number(-10, 10),
                           .grid = {},
                           .grid_is_depth = Coin() ? std::nullopt : std::optional(Coin()),
                           .grid_origin_m = Point(),
                           .grid_gap_depth_m = Coin() ? -1 : Number(0, 20'000)};
    }
    if (Coin()) {
      environment.plume = {.exists = true,
                           .source_m = DeepPoint(),
                           .rate_gps = Number(0, 1e9),
                           .current_mps = Number(0, 50),
                           .direction_deg = Number(-360, 360)};
    }
    environment.contact = static_cast<ContactRule>(Integer(0, 1));
    return environment;
  }

  void DrawBeacons(std::vector<BeaconOptions>* beacons) {
    beacons->push_back({.name = "asks",
                        .point_m = Point(),
                        .depth_m = Number(0, 20'000),
                        .position_sigma_m = Number(0, 10'000),
                        .kind = "two_way",
                        .interval_s = Number(0.1, 100'000),
                        .offset_s = Number(0, 1e7),
                        .turnaround_s = Number(0, 60)});
    beacons->push_back({.name = "sends",
                        .point_m = Point(),
                        .kind = "one_way",
                        .interval_s = Number(0.1, 100'000),
                        .offset_s = Number(0, 1e7)});
  }

  NavigationOptions DrawNavigation() {
    NavigationOptions options =
        NavigationOfGrade(Coin() ? NavigationGrade::kSurvey : NavigationGrade::kLowCost);
    options.is_fitted = true;
    options.start_sigma_m = Number(0, 10'000);
    options.start_heading_sigma_deg = Number(0, 90);
    options.current_sigma_mps = Number(0, 50);
    options.gate_probability = Number(0.5, 0.999);
    options.report_every_s = Positive(3600);
    options.compass = {.bias_deg = Number(-180, 180),
                       .bias_sigma_deg = Number(0, 90),
                       .noise_deg = Positive(90),
                       .rate_hz = Positive(100)};
    if (Coin()) options.compass.deviation_deg = {Number(-9, 9), Number(-9, 9), 1, 2, Number(-1, 1)};
    options.gyro = {Number(-36'000, 36'000), Number(0, 36'000), Number(0, 1000), Number(0, 36'000)};
    options.dvl = {Coin(),         Number(0, 10), Number(10, 20'000), Number(-0.5, 0.5),
                   Number(0, 0.5), Positive(50),  Number(0, 1),       Positive(100)};
    options.log = {Coin(), Positive(50), Positive(100)};
    options.depth = {Number(-1000, 1000), Number(0, 1000), Number(0, 1000)};
    options.gps = {Coin(),         Number(0, 100), Number(0, 1e7),   Number(0, 1e7),
                   Number(0, 1e7), Coin(),         Positive(10'000), Positive(100)};
    options.clock = {Number(-10'000, 10'000), Number(0, 10'000), Number(-1000, 1000),
                     Number(0, 1000)};
    options.ranging = {Coin(),       Positive(100'000), Positive(10'000),
                       Number(0, 1), Number(0, 1),      Number(0, 100'000),
                       Coin(),       Positive(180),     Positive(90)};
    return options;
  }

  void DrawSurveyArea() {
    const double east_m = Number(1, 1e6);
    const double north_m = Number(1, 1e6);
    survey_area_ = {
        .polygon_m = {{0, 0}, {east_m, 0}, {east_m, north_m}, {Number(-1e6, 0), north_m}},
        .lane_spacing_m = Number(0.4, 1) * std::min({north_m, east_m, 1e5}),
        .lane_ends = static_cast<LaneEnds>(Integer(0, 1))};
    if (Coin()) survey_area_.lane_angle_deg = Number(-360, 360);
    // A narrow strip may have more lanes than the loader takes.
    if (CountLanes(survey_area_) > 2000) survey_area_ = {.polygon_m = {{0, 0}, {100, 0}, {0, 100}}};
    survey_is_shared_ = CountLanes(survey_area_) >= 2 && Coin();
  }

  Eigen::Vector3d DeepPoint() { return {Number(-1e6, 1e6), Number(-1e6, 1e6), Number(0, 20'000)}; }

  Eigen::Vector3d NearPoint() { return {Number(-1000, 1000), Number(-1000, 1000), Number(0, 100)}; }

  /// One part of a path of each kind.
  std::vector<PathPart> DrawParts() {
    RandomPart random{.min_turn_deg = Number(-180, 0), .max_turn_deg = Number(0, 180)};
    random.bounds.num_waypoints = static_cast<int>(Integer(1, 20));
    random.bounds.min_leg_m = Number(0, 10);
    random.bounds.max_leg_m = Number(10, 1000);
    random.bounds.min_depth_m = Number(0, 10);
    random.bounds.max_depth_m = Number(10, 20'000);
    if (Coin()) random.start_m = NearPoint();
    if (Coin()) random.start_heading_deg = Number(-360, 360);
    const LawnmowerPart lanes{
        .area = {.polygon_m = {{0, 0}, {500, 0}, {500, 400}}, .lane_spacing_m = Number(20, 100)},
        .route = {.entry = static_cast<SurveyEntry>(Integer(0, 4)),
                  .turn_radius_m = Number(0, 30),
                  .overrun_m = Number(0, 50)},
        .depth_m = Number(0, 20'000)};
    const HelixPart helix{.center_m = NearPoint().head<2>(),
                          .radius_m = Number(1, 1000),
                          .turns = Number(0.1, 5),
                          .start_depth_m = Number(0, 20'000),
                          .end_depth_m = Number(0, 20'000),
                          .start_bearing_deg = Number(-360, 360),
                          .clockwise = Coin()};
    YoyoPart yoyo{.to_m = NearPoint().head<2>(),
                  .top_m = Number(0, 10),
                  .bottom_m = Number(20, 100),
                  .glide_deg = Number(1, 60)};
    if (Coin()) yoyo.start_m = NearPoint();
    return {{.what = PointsPart{{NearPoint(), NearPoint()}}},
            {.what = helix},
            {.what = yoyo, .insert_at = 1},
            {.what = lanes},
            {.what = PointsPart{{NearPoint()}}},
            {.what = random}};
  }

  /// Makes an underwater vehicle of it, with the tasks that these have.
  void Submerge(Vehicle* vehicle) {
    vehicle->start.depth_m = Number(0, 20'000);
    vehicle->model = Remus100Options{.parameters = Coin() ? "munet" : "fossen",
                                     .model_step_s = Number(1e-4, 0.2),
                                     .cruise_depth_m = Number(0, 20'000),
                                     .max_depth_m = Positive(20'000),
                                     .seabed_clearance_m = Number(0, 1000),
                                     .depth_filter_s = Number(0, 1000),
                                     .max_propeller_rate_rpmps = Number(0, 1e6),
                                     .buoyancy_by_weight = Number(0.9, 1.1),
                                     .autopilot = DrawGains()};
    vehicle->autopilot = {};
    const double acceptance_m = Number(0, 1000);
    const StartPose& start = vehicle->start;
    PathFollowTask path = {.points_m = {DeepPoint(), DeepPoint()},
                           .start = {.position_m = {start.x_m, start.y_m, start.depth_m},
                                     .heading_rad = DegToRad(start.heading_deg)},
                           .turn_radius_m = Number(0, 10'000),
                           .approach = Coin(),
                           .depth_rule = static_cast<DepthRule>(Integer(0, 1)),
                           .speed_mps = Positive(50),
                           .propeller_rpm = Number(0, 10'000),
                           .waypoint_switch = {.rule = static_cast<SwitchRule>(Integer(0, 3)),
                                               .acceptance_radius_m = acceptance_m,
                                               .passed_line_within_m = Number(0, 1e6)},
                           .end = static_cast<PathTaskEnd>(Integer(0, 5)),
                           .lookahead_m = Positive(10'000),
                           .crab_gain = Number(0, 1),
                           .guard_crab = Coin(),
                           .turn_crab = Coin(),
                           .hold_radius_m = acceptance_m + 1,
                           .loiter_radius_m = Positive(10'000)};
    if (Coin()) {
      path.cascade = {.layers = {SurvivalGroupLayer{
                          .r_safe_m = 3, .r_avoid_m = 30, .r_pass_m = Number(0, 1e5)}},
                      .alpha = Number(0, 1)};
      path.u_max_mps = 50;
      if (Coin()) path.group = {vehicle->name == "Vessel_2" ? "Vessel_1" : "Vessel_2"};
    }
    if (Coin()) {
      path.points_m.clear();
      path.parts = DrawParts();
    }
    vehicle->tasks.push_back({"path", path});
    if (vehicle->navigation.is_fitted && vehicle->navigation.gps.fitted) {
      vehicle->tasks.push_back({"fix", SurfaceForFixTask{.fixes = static_cast<int>(Integer(1, 99)),
                                                         .limit_s = Positive(1e7),
                                                         .speed_mps = Positive(50),
                                                         .radius_m = Positive(10'000)}});
    }
    TargetTrackTask track;
    track.target = "Vessel_2";
    if (vehicle->name == track.target) track.target = "Vessel_1";
    if (Coin()) {
      track.track.law =
          ConstantBearingLaw{.lookahead_m = Positive(10'000), .r_safe_m = Number(0, 1e5)};
    } else {
      track.track.law = VelocityCascade{
          {SurvivalGroupLayer{.r_safe_m = 3, .r_avoid_m = 30}, FormationLayer{3, 50, 70}}};
      if (Coin()) {
        vehicle->sonar = {.is_fitted = true,
                          .azimuth_beams = static_cast<int>(Integer(1, 256)),
                          .elevation_beams = static_cast<int>(Integer(1, 256)),
                          .max_range_m = Positive(10'000),
                          .range_steps = static_cast<int>(Integer(1, 1000)),
                          .tilt_deg = Number(-90, 90),
                          .width_deg = Number(0, 180),
                          .height_deg = Number(0, 180),
                          .rate_hz = Positive(1000),
                          .noise_m = Number(0, 1000)};
        std::get<Remus100Options>(vehicle->model).floor_from = "sonar";
        track.track.law = VelocityCascade{{SurvivalLayer{.group = {.r_safe_m = 3, .r_avoid_m = 30},
                                                         .sonar = {.r_avoid_m = 25,
                                                                   .r_pass_m = Number(0, 1e5),
                                                                   .memory_s = Number(0, 600)}},
                                           FeedForwardLayer{}}};
      }
    }
    track.on_silence = static_cast<SilenceRule>(Integer(0, 2));
    track.on_target_end = static_cast<TargetEndRule>(Integer(0, 3));
    track.hold_radius_m = Positive(10'000);
    track.compensate_current = Coin();
    track.speed_along_bow = Coin();
    track.track.u_max_mps = Positive(50);
    track.track.depth = {.z_max_m = Number(1, 20'000),
                         .z_min_m = Number(0, 0.9),
                         .z_safe_m = Positive(20'000),
                         .climb_mps = Number(0, 50)};
    vehicle->tasks.push_back({"track", track});
    vehicle->tasks.push_back({"up", SurfaceTask{Positive(50)}});
    for (Task& task : vehicle->tasks) {
      if (auto* keep = std::get_if<StationKeepTask>(&task.what)) keep->stops_first = true;
    }
    if (Coin()) vehicle->helm_options.end_of_tasks = Ending::kSurface;
  }

  Remus100Gains DrawGains() {
    return {.gains = Coin() ? "munet" : "fossen",
            .heading_kp = Number(0, 1000),
            .heading_ki = Number(0, 1000),
            .heading_kd = Number(0, 1000),
            .heading_observer_hz = Positive(100),
            .pitch_kp = Number(0, 1000),
            .pitch_ki = Number(0, 1000),
            .pitch_kd = Number(1, 1000),
            .heave_kd = Number(0, 1000),
            .depth_kp = Number(0, 1000),
            .depth_ki = Number(0, 1000),
            .max_pitch_deg = Positive(80),
            .max_fin_deg = Positive(80)};
  }

  /// Gives it a swarm, if its acoustic network can carry one.
  void DrawSwarm(Mission* mission) {
    SwarmOptions swarm = {
        .leader = mission->vehicles[0].name,
        .followers = {mission->vehicles[1].name},
        .max_distance_m = Positive(1e6),
        .frames = Coin(),
        .group_id = Coin() ? "7" : "x",
        .silent_after_s = Positive(1e7),
        .limits = {.max_position_m = Number(2e5, 1e6),
                   .max_speed_mps = Number(101, 1000),
                   .max_id_distance = Integer(1000, 100'000),
                   .max_followers = Integer(1, 1000),
                   .max_time_s = Positive(1e9),
                   .future_tolerance_us = Integer(0, 1'000'000)},
        .late_start_s = Coin() ? -1 : Number(0, 100),
        .neutral = {.position_m = {Number(-1e5, 1e5), 5, 7},
                    .velocity_mps = {Number(-100, 100), 1, 0}},
        .sentinel = {.position_m = Number(2e6, 1e9), .speed_mps = -Number(2e3, 1e9)}};
    // The network of the draw has vehicles[0] for a leader anyway; messages encode up to 100 km.
    mission->vehicles[1].acoustic_leader = false;
    for (Vehicle& vehicle : mission->vehicles) {
      vehicle.start.x_m = Number(-1e5, 1e5);
      vehicle.start.y_m = Number(-1e5, 1e5);
      for (Task& task : vehicle.tasks) {
        auto* survey = std::get_if<SurveyTask>(&task.what);
        if (survey != nullptr) survey->route.start_m = {vehicle.start.x_m, vehicle.start.y_m};
        auto* path = std::get_if<PathFollowTask>(&task.what);
        if (path == nullptr) continue;
        path->start.position_m.head<2>() = Eigen::Vector2d(vehicle.start.x_m, vehicle.start.y_m);
      }
    }
    const bool can_be =
        !mission->acoustics.options.modem && PlanSwarm(*mission, swarm).problems.empty();
    if (can_be) mission->swarms = {swarm};
  }

  /// Lets its second vehicle come from outside.
  void DrawNetsim(Mission* mission) {
    NetsimOptions netsim;
    netsim.port = static_cast<int>(Integer(1024, 40'000));
    netsim.address = Coin() ? "127.0.0.1" : "0.0.0.0";
    netsim.max_connections = static_cast<int>(Integer(1, 10'000));
    netsim.max_line_bytes = static_cast<int>(Integer(1024, 64 << 20));
    netsim.idle_timeout_s = Number(0, 1e9);
    netsim.allow_warp = Coin();
    netsim.environments = {{.name = Text(),
                            .lat_min_deg = std::max(-90.0, mission->origin_lat_deg - Number(0, 3)),
                            .lat_max_deg = std::min(90.0, mission->origin_lat_deg + Number(0, 3)),
                            .lon_min_deg = mission->origin_lon_deg - Number(0, 3),
                            .lon_max_deg = mission->origin_lon_deg + Number(0, 3),
                            .depth_min_m = Number(-12'000, 0),
                            .depth_max_m = Number(0, 12'000)}};
    Vehicle& outsider = mission->vehicles[1];
    outsider.sim = outsider.reporter = Provider::kNone;
    outsider.navigation = {};
    mission_navigates_ = false;
    outsider.is_outside = Coin();
    if (outsider.is_outside) outsider.helm = outsider.acomms = Provider::kNone;
    NetsimVehicle vehicle;
    vehicle.name = outsider.name;
    vehicle.modem_tcp_port = static_cast<int>(Integer(50'000, 60'000));
    vehicle.address = Coin() ? "any" : "10.1.2.3";
    vehicle.environment = netsim.environments[0].name;
    if (mission->acoustics.is_used) vehicle.modem = static_cast<NetsimModem>(Integer(0, 3));
    vehicle.gps = {.tcp_port = static_cast<int>(Integer(61'000, 62'000)), .path = Text()};
    netsim.vehicles = {vehicle};
    mission->netsim = netsim;
  }

  CaptureRule DrawCapture() { return {Positive(1000), Number(0, 1000), Coin()}; }

  Vehicle DrawVehicle(int64_t number) {
    Vehicle vehicle;
    vehicle.name = "Vessel_" + std::to_string(number);
    vehicle.type = Text();
    vehicle.group = Coin() ? "" : Text();
    vehicle.color = Text();
    vehicle.length_m = Positive(500);
    vehicle.start = {Number(-1e6, 1e6), Number(-1e6, 1e6), Number(-360, 360), Number(0, 50), 0};
    vehicle.model = SurfaceCraftParams{
        .thrust_map = {{-Positive(100), -Number(0, 50)}, {0, 0}, {50, Number(0, 3)}, {100, 4}},
        .reverse_ratio = Number(0, 1),
        .max_acceleration_mps2 = Positive(100),
        .max_deceleration_mps2 = Positive(100),
        .max_rudder_deg = Positive(180),
        .max_rudder_rate_degps = Positive(100'000),
        .turn_rate_degps = Positive(360),
        .full_turn_speed_mps = Positive(50),
        .full_turn_thrust_pct = Number(0, 100),
        .turn_speed_loss = Number(0, 0.99)};
    vehicle.sim = DrawProvider();
    vehicle.helm = DrawProvider();
    vehicle.reporter = DrawProvider();
    vehicle.acomms = DrawProvider();
    if (Coin()) {
      vehicle.sensors = {.is_fitted = true,
                         .position_noise_m = Number(0, 10'000),
                         .depth_noise_m = Number(0, 1000),
                         .attitude_noise_deg = Number(0, 90),
                         .rate_noise_degps = Number(0, 90),
                         .speed_noise_mps = Number(0, 50),
                         .altitude_noise_m = Number(0, 1000),
                         .altimeter_range_m = Positive(20'000)};
    }
    if (!vehicle.sensors.is_fitted && vehicle.sim != Provider::kNone) {
      vehicle.navigation = DrawNavigation();
    }
    if (Coin()) {
      vehicle.recovery.of(SwarmField::kTimeStamp) = {};
      vehicle.recovery.of(SwarmField::kReporterPos) = {RecoveryStrategy::kSentinel,
                                                       RecoveryStrategy::kSkipField};
    }
    vehicle.helm_options = {.nav_timeout_s = Positive(3600),
                            .deploy_at_start = Coin(),
                            .state_interval_s = Positive(3600),
                            .decide_every_s = Number(0.01, 60),
                            .goals_mandatory = Coin()};
    constexpr Ending kOfAllModels[] = {Ending::kHold, Ending::kGoOn, Ending::kLoiter,
                                       Ending::kEndMission};
    if (Coin()) vehicle.helm_options.end_of_tasks = kOfAllModels[Integer(0, 3)];
    vehicle.helm_options.hold_radius_m = Positive(10'000);
    vehicle.helm_options.loiter_radius_m = Positive(10'000);
    vehicle.autopilot = {Number(0, 1000), Number(0, 1000), Number(0, 1000), Number(0, 180),
                         Number(0, 1000), Number(0, 1000), Number(0, 100)};
    const double blackout_s = Number(0, 100'000);
    vehicle.reporter_options = {.rate_hz = Positive(1000),
                                .nav_grace_period_s = Number(0, 100'000),
                                .nohelm_threshold_s = Number(0, 100'000),
                                .blackout_interval_s = blackout_s,
                                .blackout_variance_s = Number(0, blackout_s),
                                .extrapolate = Coin(),
                                .extrap_position_thresh_m = Number(0, 10'000),
                                .extrap_heading_thresh_deg = Number(0, 360),
                                .extrap_max_gap_s = Number(0, 100'000),
                                .extra = {{"PLAIN", Text()}, {Text(), ""}, {"with.dot", Text()}}};
    vehicle.message_options = {Positive(100'000), Integer(0, 1000)};
    vehicle.link_factors = {Number(0, 1), Number(1, 10)};
    const double inner_m = Positive(9000);
    const Eigen::Vector2d station_m = Coin() ? Point() : Eigen::Vector2d(0, 0);
    vehicle.tasks = {
        {"survey", WaypointsTask{{Point(), Point()},
                                 Positive(50),
                                 DrawCapture(),
                                 Coin() ? 0 : static_cast<int>(Integer(1000, 1'000'000)),
                                 Positive(10'000),
                                 Number(0, 1)}},
        {Text() + "1",
         LoiterTask{Point(), Positive(100'000), static_cast<int>(Integer(3, 360)), Coin(),
                    Positive(50), DrawCapture(), Positive(10'000), Number(0, 1), Number(0, 1e7)}},
        {Text() + "2",
         StationKeepTask{station_m, station_m.isZero(), inner_m, inner_m * 1.1, Positive(50)}},
        {Text() + "3", ReturnTask{Point(), Positive(50), DrawCapture(), Positive(10'000)}},
        {Text() + "4", DrawSurvey(vehicle)}};
    for (Task& task : vehicle.tasks) task.pwt = Number(0, 1e6);
    DrawBehaviors(&vehicle);
    vehicle.return_task = {Point(), Positive(50), DrawCapture(), Positive(10'000)};
    return vehicle;
  }

  std::vector<Eigen::Vector2d> Square() {
    const Eigen::Vector2d corner = Point() / 2;
    const double side = Number(1, 1000);
    return {corner, corner + Eigen::Vector2d(side, 0), corner + Eigen::Vector2d(side, side),
            corner + Eigen::Vector2d(0, side)};
  }

  /// A few of all kinds, with what all kinds have in common.
  void DrawBehaviors(Vehicle* vehicle) {
    vehicle->domain.speed_mps = {.first = 0, .step = 0.5, .count = static_cast<int>(Integer(2, 9))};
    vehicle->domain.depth_m = {.first = 0, .step = 2, .count = static_cast<int>(Integer(2, 9))};
    vehicle->variables = {
        {"DEPLOY", Coin() ? "true" : "false"}, {"DEPTH.2", Number(-1e9, 1e9)}, {"PLACE", Text()}};
    vehicle->modes = {{"MODE = ACTIVE", {"DEPLOY = true", "(DEPTH.2 > 0) or (PLACE = x)"}, ""},
                      {"MODE = HOME", {"MODE = ACTIVE"}, "AWAY"}};
    if (Coin()) vehicle->modes.clear();
    contact_ = vehicle->name == "Vessel_1" ? "Vessel_2" : "Vessel_1";
    int number = 0;
    for (AnyBehavior& what : OneBehaviorOfEachKind()) {
      if (Coin()) continue;
      BehaviorOptions options;
      options.name = std::string(1, static_cast<char>('a' + number++)) + "_";
      options.what = what;
      std::visit([&](auto& kind) { Fill(&kind); }, options.what);
      options.pwt = Number(0, 1e6);
      if (Coin()) options.condition = {"DEPLOY = true", "!(PLACE = \"a b\")"};
      if (Coin()) {
        options.flags = {.runflag = {"A = 1"},
                         .runxflag = {"B = $[OSX]"},
                         .idleflag = {"C = 1 [to] all+"},
                         .activeflag = {"D = 1 [if] (A = 1)"},
                         .inactiveflag = {"E = \"1\"", "F = 1"},
                         .endflag = {"G = 1"},
                         .spawnflag = {"H = 1"},
                         .spawnxflag = {"I = 1"},
                         .configflag = {"J = 1"}};
      }
      if (Coin()) options.updates = "UPDATES";
      if (Coin()) options.duration = Number(0, 1e7);
      options.duration_idle_decay = Coin();
      if (Coin()) options.duration_reset = "AGAIN = true";
      if (Coin()) options.duration_status = "LEFT";
      if (Coin()) {
        options.nostarve = {"A", "B"};
        options.nostarve_s = Number(1, 1e7);
      }
      options.perpetual = Coin();
      options.max_spawnings = static_cast<int>(Integer(1, 1'000'000));
      vehicle->behaviors.push_back(std::move(options));
    }
    if (vehicle->behaviors.empty()) return;
    BehaviorOptions& last = vehicle->behaviors.back();
    last.templating = Coin() ? Templating::kSpawn : Templating::kClone;
    last.updates = "UPDATES";
  }

  /// What the kinds cannot be without.
  template <class Options>
  void Fill(Options* o) {
    if constexpr (requires { o->contact.contact; }) {
      o->contact.contact = contact_;
      o->contact.match_group = {Text()};
      o->contact.ignore_name = {Text(), Text()};
    }
    if constexpr (requires { o->pwt_grade; }) o->pwt_grade = Coin() ? "quadratic" : "linear";
    if constexpr (requires { o->core_poly; }) o->core_poly = Square();
    if constexpr (requires { o->polygon; }) o->polygon = Square();
    if constexpr (requires { o->points; }) o->points = {Point(), Point()};
    if constexpr (requires { o->station_pt; }) o->station_pt = Point();
    if constexpr (requires { o->p1; }) o->p1 = o->p2 = Point();
    if constexpr (requires { o->leg_spds; }) o->leg_spds = {1, Number(0, 50)};
    if constexpr (requires { o->depths; }) o->depths = {{Number(0, 1000), Number(0, 1e7)}};
    if constexpr (requires { o->memory_time; }) o->memory_time = Positive(180);
    if constexpr (requires { o->turn_range; }) o->turn_range = Positive(180);
    if constexpr (requires { o->min_altitude; }) o->min_altitude = Number(0, 100);
    if constexpr (requires { o->period_lazy; }) o->period_lazy = o->period_busy = Positive(1e7);
    if constexpr (requires { o->fix_turn; }) o->fix_turn = Positive(36'000);
    if constexpr (requires { o->wptflag; }) o->wptflag = {"K = $[CTR]"};
    if constexpr (requires { o->patience; }) o->patience = Number(1, 85);
    if constexpr (requires { o->clockwise; }) o->clockwise = Coin() ? "best" : "false";
    if constexpr (requires { o->speed; }) o->speed = Number(0, 50);
  }

  ModemPreset DrawModem() {
    ModemPreset modem;
    modem.name = Text();
    modem.low_khz = Number(1, 499);
    modem.high_khz = Number(500, 1000);
    modem.data_rate_bps = Number(0.1, 1e6);
    modem.max_packet_bytes = Integer(37, 1'000'000);
    modem.source_level_db = Number(100, 250);
    modem.typical_range_m = Positive(1e6);
    modem.modulation = static_cast<Modulation>(Integer(0, 3));
    modem.fading = static_cast<Fading>(Integer(0, 1));
    if (Coin()) modem.code = {127, 92, static_cast<int>(Integer(1, 5))};
    for (const char* key : {"band", "data_rate_bps", "max_packet_bytes", "source_level_db",
                            "typical_range_m", "modulation", "fading", "code"}) {
      modem.sources[key] = Text();
    }
    return modem;
  }

  Event DrawEvent(double at_s) {
    switch (Integer(0, 8)) {
      case 0:
        return {at_s, CommandEvent{"all", "task", "survey", {}}};
      case 1:
        return {at_s, CommandEvent{"Vessel_1", "goto", "", {Number(-1e9, 1e9), Number(-1, 1)}}};
      case 2:
        return {at_s, SimCommandEvent{"Vessel_1", "reset", {1, 2, Number(0, 360), 4}}};
      case 3:
        return {at_s, RuleEvent{"stealth", "Vessel_1", Number(0, 1)}};
      case 4:
        if (Coin()) return {at_s, RuleEvent{"ignore_group", "", std::string("Ghosts")}};
        return {at_s, RuleEvent{"groups", "", Coin() ? 1.0 : 0.0}};
      case 5:
        return {at_s, RuleEvent{"comms_range", "", Coin() ? -1 : Number(0, 1e7)}};
      case 6:
        return {at_s, RuleEvent{"full_report", "Vessel_1", 0}};
      case 7: {
        MessageEvent message;
        message.src_node = "Vessel_1";
        message.dest_node = "all";
        message.var_name = Text();
        message.dest_group = Coin() ? "" : Text();
        if (Coin()) message.double_val = Number(-1e300, 1e300);
        if (!message.double_val) message.string_val = Text();
        message.ack = Coin();
        return {at_s, message};
      }
      default:
        return {at_s, RuleEvent{"stale_time", "", Number(0, 1e7)}};
    }
  }

  /// The same area for both vehicles of a mission, that they can share it.
  SurveyTask DrawSurvey(const Vehicle& vehicle) {
    SurveyTask survey;
    survey.area = survey_area_;
    survey.route = {.entry = static_cast<SurveyEntry>(Integer(0, 4)),
                    .start_m = {vehicle.start.x_m, vehicle.start.y_m},
                    .turn_radius_m = Number(0, 10'000),
                    .overrun_m = Number(0, 10'000)};
    if (survey_is_shared_) {
      survey.divide_among = {"Vessel_2", "Vessel_1"};
      survey.share = {.place = vehicle.name == "Vessel_1" ? 0U : 1U, .members = 2};
    }
    survey.speed_mps = Positive(50);
    survey.capture = DrawCapture();
    survey.lookahead_m = Positive(10'000);
    survey.crab_gain = Number(0, 1);
    return survey;
  }

  Expectation DrawExpectation(double end_s) {
    switch (Integer(0, 10)) {
      case 0: {
        ArrivalExpectation arrival{"all", std::nullopt, Positive(100'000), Positive(end_s), Coin()};
        if (Coin()) arrival.point_m = Point();
        return {"", arrival};
      }
      case 1:
        return {"", SeparationExpectation{Positive(100'000)}};
      case 2: {
        CommsExpectation comms{.kind = static_cast<Kind>(Integer(0, kNumKinds - 1)),
                               .from = "Vessel_1",
                               .to = "all",
                               .cause = "out_of_range",
                               .at_least = std::nullopt,
                               .at_most = std::nullopt};
        const bool counts = Coin();
        if (counts) comms.at_most = Integer(10, 20);
        if (Coin()) comms.at_least = Integer(0, 10);
        if (Coin() || !counts) comms.at_least_pct = Number(0, 50);
        if (Coin()) comms.at_most_pct = Number(50, 100);
        return {"", comms};
      }
      case 3:
        return {"", HelmExpectation{"Vessel_1", Coin() ? "" : "ALL-STOP", "survey"}};
      case 4:
        return {"", TrackExpectation{"all", Positive(100'000), Number(0, end_s)}};
      case 5: {
        DistanceExpectation distance;
        distance.vehicle = "all";
        distance.to = "Vessel_1";
        if (Coin()) distance.min_m = Number(0, 10);
        if (Coin() || !distance.min_m) distance.max_m = Number(10, 1e7);
        distance.from_s = Number(0, end_s);
        return {"", distance};
      }
      case 6: {
        ClosestApproachExpectation approach;
        approach.vehicle = "Vessel_1";
        approach.at_least_m = Positive(100'000);
        approach.encounter.risk_m = Positive(1e6);
        return {"", approach};
      }
      case 7: {
        EncounterScoreExpectation score;
        score.to = Coin() ? "all" : "Vessel_2";
        score.at_least = Number(0, 100);
        if (Coin()) score.role = "stand-on";
        score.encounter.entry_range_m = Positive(1e6);
        score.encounter.near_miss_m = Number(1, 5);
        return {"", score};
      }
      case 8: {
        CoverageExpectation coverage{.sensor_width_m = Positive(100'000),
                                     .at_least_pct = Number(0, 100)};
        if (Coin()) coverage.polygon_m = {{0, 0}, {Number(1, 1e6), 0}, {0, Number(-1e6, -1)}};
        if (Coin()) coverage.vehicles = {"Vessel_2"};
        return {"", coverage};
      }
      case 9:
        if (mission_navigates_) {
          return {"", NavigationErrorExpectation{"all", Positive(1e6), Number(0, end_s)}};
        }
        if (has_floor_) return {"", AltitudeExpectation{"all", Number(0, 20'000)}};
        [[fallthrough]];
      default:
        return {"", LapsExpectation{"all", "survey", Integer(1, 1000), Number(0, end_s)}};
    }
  }

  std::mt19937_64 generator_;
  std::string contact_;  ///< A vehicle that is not the one being drawn.
  bool has_floor_ = false;
  bool mission_navigates_ = false;
  SurveyArea survey_area_;
  bool survey_is_shared_ = false;
};

}  // namespace shoal
