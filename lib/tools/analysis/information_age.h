// The age of what each member of a swarm knows of the others: the time since the last report of a
// contact was made, by SWARM_<V> ("age of information": Kaul, Yates, Gruteser 2012, "Real-time
// status: How often should one update?").
//
//   InformationAge ages([](const AgePoint& point) { ... });
//   for (const swarm_t& swarm : messages) ages.Add(swarm);
//   print(ages.Text(50));
//
// An age grows as time does, and falls when a newer report is taken in: a saw tooth. Means and
// percentiles are over time, from a contact's first report to the last SWARM_<V>.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/tools/analysis/age_teeth.h"
#include "shoal/swarm_t.hpp"

namespace shoal {

/// A corner of a saw tooth; a fall has two at the same time.
struct AgePoint {
  int64_t utime = 0;
  const std::string& vehicle;  ///< The receiver. Valid during the call.
  const std::string& contact;  ///< The vehicle that it received.
  bool is_target = false;      ///< The vehicle follows it.
  double age_s = 0;
};

/// Of what one vehicle knows of one contact.
struct AgeSummary {
  bool is_target = false;
  int64_t num_reports = 0;    ///< With different time stamps.
  double first_report_s = 0;  ///< Mission time.
  double mean_s = 0;
  double age_95_s = 0;  ///< It was no older for 95 % of the time.
  double max_s = 0;
};

class InformationAge {
 public:
  /// Receiver and contact.
  using Pair = std::pair<std::string, std::string>;
  using OnPoint = std::function<void(const AgePoint&)>;

  /// `on_point` is called for each corner, in order of time; may be empty.
  explicit InformationAge(OnPoint on_point = {}) : on_point_(std::move(on_point)) {}

  void Add(const swarm_t& swarm);

  [[nodiscard]] std::map<Pair, AgeSummary> Summaries() const;
  /// Returns what the summaries are made of, in order of time.
  [[nodiscard]] std::map<Pair, std::vector<AgeTooth>> Teeth() const;
  /// Reports from the future: with a damaged time stamp. Their age begins with 0.
  int64_t num_future() const { return num_future_; }
  /// Left out: messages earlier than the one before, and reports with times that no mission has.
  int64_t num_impossible() const { return num_impossible_; }

  /// Returns a table, one line for each pair. Where there are more than `max_pairs`, only those
  /// that follow their contact are shown, and the rest is counted. Empty where no contact was
  /// received.
  [[nodiscard]] std::string Text(size_t max_pairs) const;
  /// Returns the same for other programs, all of it.
  [[nodiscard]] std::string Csv() const;

 private:
  struct Knowledge {
    bool is_target = false;
    std::optional<int64_t> report_utime;  ///< As published; absent: not received, or not any more.
    int64_t taken_utime = 0;              ///< When it was published first.
    int64_t begin_us = 0;                 ///< Its age then.
    int64_t first_utime = 0;
    int64_t num_reports = 0;
    std::vector<AgeTooth> teeth;  ///< All but the last.
  };
  struct Observer {
    int64_t last_utime = 0;
    std::map<std::string, Knowledge> contacts;
  };

  void AddContact(const swarm_t& swarm, const swarm_contact_t& contact, Observer* observer);
  void ReportAge(const swarm_t& swarm, const std::string& name, const Knowledge& knowledge) const;
  static void EndTooth(int64_t utime, Knowledge* knowledge);
  static std::vector<AgeTooth> TeethOf(const Knowledge& knowledge, int64_t last_utime);
  static AgeSummary Summarize(const Knowledge& knowledge, int64_t last_utime);

  OnPoint on_point_;
  std::map<std::string, Observer> observers_;
  int64_t num_future_ = 0;
  int64_t num_impossible_ = 0;
};

}  // namespace shoal
