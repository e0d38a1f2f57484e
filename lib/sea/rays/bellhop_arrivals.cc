#include "lib/sea/rays/bellhop_arrivals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/text/numbers.h"
#include "lib/sea/rays/bellhop_case.h"
#include "lib/sea/rays/list_text.h"

namespace shoal {

namespace {

constexpr double kSamePathDelay_s = 20e-6;
constexpr double kSamePathAngle_rad = 0.5 * std::numbers::pi / 180;
constexpr double kSpeedForLength_mps = 1500;

size_t NearestIndex(std::span<const double> values, double value) {
  const auto nearest =
      std::ranges::min_element(values, {}, [value](double each) { return std::abs(each - value); });
  return static_cast<size_t>(nearest - values.begin());
}

bool IsSamePath(const RayArrival& a, const RayArrival& b) {
  return a.num_surface == b.num_surface && a.num_bottom == b.num_bottom &&
         std::abs(a.delay_s - b.delay_s) <= kSamePathDelay_s &&
         std::abs(a.launch_rad - b.launch_rad) <= kSamePathAngle_rad;
}

void Join(const RayArrival& other, RayArrival* arrival) {
  const double sum = arrival->amplitude + other.amplitude;
  const double share = sum > 0 ? other.amplitude / sum : 0;
  for (const auto member : {&RayArrival::delay_s, &RayArrival::launch_rad, &RayArrival::arrive_rad,
                            &RayArrival::length_m}) {
    arrival->*member += share * (other.*member - arrival->*member);
  }
  arrival->amplitude = sum;
}

std::vector<RayArrival> Joined(std::vector<RayArrival> rows) {
  std::ranges::sort(rows, {}, &RayArrival::delay_s);
  std::vector<RayArrival> arrivals;
  for (const RayArrival& row : rows) {
    const auto same = std::ranges::find_if(
        arrivals, [&](const RayArrival& each) { return IsSamePath(each, row); });
    if (same == arrivals.end()) {
      arrivals.push_back(row);
    } else {
      Join(row, &*same);
    }
  }
  std::ranges::sort(arrivals, {}, &RayArrival::delay_s);
  return arrivals;
}

}  // namespace

std::span<const RayArrival> ArrivalTable::Nearest(double source_depth_m, double range_m,
                                                  double receiver_depth_m) const {
  const size_t source = NearestIndex(source_depths_m_, source_depth_m);
  const size_t receiver = NearestIndex(receiver_depths_m_, receiver_depth_m);
  const size_t range = NearestIndex(ranges_m_, range_m);
  return links_[(source * receiver_depths_m_.size() + receiver) * ranges_m_.size() + range];
}

class ArrivalReader {
 public:
  ArrivalReader(std::string_view name, std::string_view text) : text_(name, text) {}

  Result<ArrivalTable> Run(bool has_type) {
    if (!(has_type ? ReadHead() : ReadOlderHead()) || !ReadLinks()) return Error{error_};
    if (!text_.IsAtEnd()) {
      return text_.Refuse(
          "the file goes on behind its last receiver: the counts at its beginning "
          "do not fit");
    }
    return std::move(table_);
  }

 private:
  bool Fail(const Error& error) {
    error_ = error.message;
    return false;
  }

  bool ReadValues(size_t count, std::string_view what, std::vector<double>* values) {
    Result<std::vector<double>> items = text_.Items(count, what);
    if (!items.ok()) return Fail(Error{items.error()});
    *values = std::move(*items);
    return true;
  }

  bool ReadCount(std::string_view what, double least, double most, size_t* count) {
    std::vector<double> value;
    if (!ReadValues(1, what, &value)) return false;
    if (!(value[0] >= least && value[0] <= most && value[0] == std::floor(value[0]))) {
      return Fail(text_.Refuse(std::string(what) + " must be a whole number from " +
                               ShortestText(least) + " to " + ShortestText(most) + ", not " +
                               ShortestText(value[0])));
    }
    *count = static_cast<size_t>(value[0]);
    return true;
  }

  bool ReadFrequency() {
    std::vector<double> value;
    if (!ReadValues(1, "the frequency in Hz", &value)) return false;
    table_.hz_ = value[0];
    return table_.hz_ > 0 && table_.hz_ <= 1e7
               ? true
               : Fail(text_.Refuse("the frequency must be more than 0 and at most 1e7 Hz"));
  }

  bool ReadHead() {
    const Result<std::string> type = text_.Text("'2D'");
    if (!type.ok()) return Fail(Error{type.error()});
    if (*type != "2D") {
      return Fail(text_.Refuse("type '" + *type + "': files with '2D' are read"));
    }
    size_t count = 0;
    const auto read_axis = [&](std::string_view what, std::vector<double>* values) {
      return ReadCount("the number of " + std::string(what), 1, kMaxBellhopItems, &count) &&
             ReadValues(count, what, values);
    };
    return ReadFrequency() && read_axis("source depths", &table_.source_depths_m_) &&
           read_axis("receiver depths", &table_.receiver_depths_m_) &&
           read_axis("receiver ranges in m", &table_.ranges_m_);
  }

  bool ReadOlderHead() {
    size_t num_sources = 0, num_depths = 0, num_ranges = 0;
    return ReadFrequency() &&
           ReadCount("the number of source depths", 1, kMaxBellhopItems, &num_sources) &&
           ReadCount("the number of receiver depths", 1, kMaxBellhopItems, &num_depths) &&
           ReadCount("the number of receiver ranges", 1, kMaxBellhopItems, &num_ranges) &&
           ReadValues(num_sources, "source depths", &table_.source_depths_m_) &&
           ReadValues(num_depths, "receiver depths", &table_.receiver_depths_m_) &&
           ReadValues(num_ranges, "receiver ranges in m", &table_.ranges_m_);
  }

  bool ReadLinks() {
    const size_t num_receivers = table_.receiver_depths_m_.size() * table_.ranges_m_.size();
    if (num_receivers * table_.source_depths_m_.size() > kMaxTableLinks) {
      return Fail(text_.Refuse("a table has at most " + std::to_string(kMaxTableLinks) +
                               " links of source and receiver"));
    }
    size_t num_arrivals = 0;
    for (size_t source = 0; source < table_.source_depths_m_.size(); ++source) {
      size_t most = 0;
      if (!ReadCount("the largest number of arrivals", 0, 1e6, &most)) return false;
      for (size_t i = 0; i < num_receivers; ++i) {
        size_t count = 0;
        if (!ReadCount("the number of arrivals of a receiver", 0, static_cast<double>(most),
                       &count)) {
          return false;
        }
        num_arrivals += count;
        if (num_arrivals > kMaxTableArrivals) {
          return Fail(text_.Refuse("a table has at most " + std::to_string(kMaxTableArrivals) +
                                   " arrivals"));
        }
        if (!ReadRows(count)) return false;
      }
    }
    return true;
  }

  bool ReadRows(size_t count) {
    std::vector<RayArrival> rows;
    for (size_t i = 0; i < count; ++i) {
      std::vector<double> row;
      if (!ReadValues(8, "one of the eight numbers of an arrival", &row)) return false;
      const double degree = std::numbers::pi / 180;
      const bool is_sound = row[0] >= 0 && row[2] >= 0 && row[2] < 1e5 && row[3] <= 0 &&
                            row[6] >= 0 && row[6] < 1e6 && row[7] >= 0 && row[7] < 1e6;
      if (!is_sound) {
        return Fail(
            text_.Refuse("an arrival needs an amplitude and a delay that are not negative, "
                         "an imaginary delay that is not positive, and numbers of bounces"));
      }
      RayArrival arrival;
      table_.has_absorption_ |= row[3] < 0;
      arrival.amplitude = row[0] * Exp(2 * std::numbers::pi * table_.hz_ * row[3]);
      arrival.phase_rad = WrappedPhase(row[1] * degree);
      arrival.delay_s = row[2];
      arrival.length_m = row[2] * kSpeedForLength_mps;
      arrival.launch_rad = row[4] * degree;
      arrival.arrive_rad = row[5] * degree;
      arrival.num_surface = static_cast<int>(row[6]);
      arrival.num_bottom = static_cast<int>(row[7]);
      rows.push_back(arrival);
    }
    table_.links_.push_back(Joined(std::move(rows)));
    return true;
  }

  ListText text_;
  std::string error_;
  ArrivalTable table_;
};

Result<ArrivalTable> ReadBellhopArrivals(std::string_view name, std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r\n");
  const bool has_type =
      first != std::string_view::npos && (text[first] == '\'' || text[first] == '"');
  return ArrivalReader(name, text).Run(has_type);
}

}  // namespace shoal
