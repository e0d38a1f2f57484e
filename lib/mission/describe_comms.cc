// The table [comms].
#include <algorithm>
#include <string>

#include "lib/mission/describe.h"
#include "lib/mission/suggest.h"
#include "lib/routing/control.h"

namespace shoal {

void DescribeControlValue(Fields& fields, std::string_view key, const ControlRow& row,
                          double& value) {
  std::string word = ControlWord(row, value);
  fields.Scalar(key, word);
  if (!fields.reading() || !fields.Has(key, true)) return;
  if (const std::optional<double> parsed = ParseControlValue(row, word)) {
    value = *parsed;
  } else {
    fields.Refuse(key, std::string(key) + " = " + Quoted(word) + " is impossible; " +
                           std::string(row.rule) + " takes " + std::string(row.values));
  }
}

void Describe(Fields& fields, RoutingRules& rules) {
  const NumberLimits seconds = Between(-1, kLongest_s);
  fields.NumberOrWord("comms_range", rules.comms_range_m, 1e7, "nolimit", -1);
  fields.Number("critical_range", rules.critical_range_m, Between(0, 1e7));
  fields.NumberOrWord("stale_time", rules.stale_time_s, kLongest_s, "nolimit", -1);
  if (fields.reading()) {
    const double default_s = rules.stale_time_s < 0 ? -1 : 20 * rules.stale_time_s;
    rules.stale_forget_s = std::min(default_s, kLongest_s);
  }
  fields.Number("stale_forget_s", rules.stale_forget_s, seconds);
  fields.Flag("groups", rules.groups);
  fields.Flag("msg_groups", rules.msg_groups);
  fields.Text("ignore_group", rules.ignore_group, {});
  fields.Number("min_rpt_interval", rules.min_rpt_interval_s, seconds);
  fields.Number("min_msg_interval", rules.min_msg_interval_s, seconds);
  fields.Integer("max_msg_length", rules.max_msg_length_bytes, 0, 1'000'000'000);
  fields.Number("drop_percentage", rules.drop_percentage, Between(0, 100));
  fields.Choice("reports_over", rules.reports_over, kMedia);
  fields.Choice("messages_over", rules.messages_over, kMedia);
  DescribeControlValue(fields, "shared_node_reports", *FindControl("shared_node_reports"),
                       rules.shared_node_reports_s);
  fields.Number("pulse_duration", rules.pulse_duration_s, Between(0, kLongest_s));
  fields.Flag("view_node_rpt_pulses", rules.view_node_rpt_pulses);
  fields.Text("msg_color", rules.msg_color, {.min_length = 1});
  fields.Text("msg_repeat_color", rules.msg_repeat_color, {.min_length = 1});
  fields.Integer("each_fate_up_to", rules.each_fate_up_to, 0, 1'000'000);
}

}  // namespace shoal
