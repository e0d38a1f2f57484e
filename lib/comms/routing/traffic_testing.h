// For tests: random missions, step by step, with every kind of input.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/random/stream.h"
#include "lib/comms/routing/rules.h"

namespace shoal {

/// Draws that are the same for the same seed.
class Dice {
 public:
  explicit Dice(uint64_t seed) : stream_(seed, "dice") {}

  int64_t Below(int64_t count) {
    return static_cast<int64_t>(stream_.UniformInt(static_cast<uint64_t>(count)));
  }
  bool OneIn(int64_t count) { return Below(count) == 0; }
  template <class T>
  T Pick(std::initializer_list<T> choices) {
    return *(choices.begin() + Below(static_cast<int64_t>(choices.size())));
  }
  template <class T>
  const T& Pick(const std::vector<T>& choices) {
    return choices[static_cast<size_t>(Below(static_cast<int64_t>(choices.size())))];
  }
  template <class T>
  void Shuffle(std::vector<T>* items) {
    for (size_t i = items->size(); i > 1; --i) {
      std::swap((*items)[i - 1], (*items)[static_cast<size_t>(Below(static_cast<int64_t>(i)))]);
    }
  }

 private:
  Stream stream_;
};

struct RandomReport {
  std::string name;
  std::string group;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
};

struct RandomMessage {
  std::string source;
  std::string dest_node;
  std::string dest_group;
  int64_t length_bytes = 0;
  bool is_sound = true;
};

/// Generates random traffic. Positions and limits are multiples of ten, so that boundaries are hit.
class RandomTraffic {
 public:
  explicit RandomTraffic(uint64_t seed, std::vector<std::string> names)
      : dice(seed), names_(std::move(names)) {}

  std::string Name() {
    if (dice.OneIn(50)) return dice.Pick<std::string>({"", "all", "a b", "x:y", "LOCAL"});
    return InSomeCase(dice.Pick(names_));
  }

  std::string Group() {
    return InSomeCase(dice.Pick<std::string>({"", "", "red", "red", "blue", "ghosts"}));
  }

  Eigen::Vector3d Position() {
    if (dice.OneIn(40)) return {Huge(), Huge(), Huge()};
    if (dice.OneIn(40)) return {Coordinate(200), Bad(), 0};
    return {Coordinate(dice.Pick({20, 200})), Coordinate(dice.Pick({5, 20})), Coordinate(5)};
  }

  RandomReport Report() { return {.name = Name(), .group = Group(), .position_m = Position()}; }

  RandomMessage Message() {
    RandomMessage message;
    message.source = Name();
    if (!dice.OneIn(4)) {
      for (int64_t i = dice.Below(4); i >= 0; --i) {
        message.dest_node += dice.OneIn(12) ? InSomeCase("all") : Name();
        message.dest_node += dice.Pick<std::string>({":", " : ", "::", ""});
      }
    }
    if (dice.OneIn(2)) message.dest_group = dice.OneIn(4) ? InSomeCase("all") : Group();
    message.length_bytes = dice.Pick<int64_t>({0, 9, 10, 11, 100});
    message.is_sound = !dice.OneIn(30);
    return message;
  }

  RoutingRules Rules() {
    RoutingRules rules;
    rules.comms_range_m = dice.Pick<double>({-1, 0, 10, 50, 100, 250, 1e18, 1.7e308});
    rules.critical_range_m = dice.Pick<double>({0, 0, 10, 30, 1e9});
    rules.stale_time_s = dice.Pick<double>({-1, 0, 1, 5, 5, 20});
    rules.stale_forget_s = dice.Pick<double>({-1, 0, 10, 50, 100});
    rules.groups = dice.OneIn(2);
    rules.msg_groups = dice.OneIn(2);
    rules.ignore_group = dice.Pick<std::string>({"", "GHOSTS", "red"});
    rules.min_rpt_interval_s = dice.Pick<double>({-1, 0, 1, 3});
    rules.min_msg_interval_s = dice.Pick<double>({-1, 0, 1, 10});
    rules.max_msg_length_bytes = dice.Pick<int64_t>({0, 10, 1000});
    rules.drop_percentage = dice.Pick<double>({0, 0, 50, 100, 12.5});
    return rules;
  }

  LinkFactors Factors() {
    return {.stealth = dice.Pick({0.0, 0.1, 0.5, 1.0}), .earange = dice.Pick({1.0, 2.0, 10.0})};
  }

  /// Time between two steps: mostly short, sometimes long enough to be stale or forgotten.
  int64_t Pause_us() {
    if (dice.OneIn(100)) return 1'000'000 * dice.Below(120);
    return 250'000 * dice.Below(5);
  }

  Dice dice;

 private:
  std::string InSomeCase(std::string text) {
    for (char& c : text) {
      if (c >= 'a' && c <= 'z' && dice.OneIn(3)) c = static_cast<char>(c - 'a' + 'A');
    }
    return text;
  }

  double Coordinate(int64_t tens) {
    return 10.0 * static_cast<double>(dice.Below(2 * tens) - tens);
  }
  double Huge() { return dice.Pick({0.0, 1e15, -1e15, 1e17 + 16, 1e160, -1.7e308, 1.7e308}); }
  double Bad() {
    return dice.Pick({std::numeric_limits<double>::quiet_NaN(),
                      std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity()});
  }

  std::vector<std::string> names_;
};

}  // namespace shoal
