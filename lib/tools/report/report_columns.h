// The columns of a campaign's report: heading and value of each, once for the text and the page.
#pragma once

#include <span>
#include <string>

#include "lib/tools/report/report_tables.h"

namespace shoal {

/// A column of a table whose rows are of type Of.
template <class Of>
struct ReportColumn {
  /// How the text report shows it, as fmt writes it after the columns before: " {:>8}". Empty: the
  /// text report has it elsewhere.
  std::string format;
  std::string heading;
  std::string (*cell)(const Of& of, size_t which);
  size_t which = 0;  ///< Given to `cell`: of several columns of one function.

  [[nodiscard]] std::string CellOf(const Of& of) const { return cell(of, which); }
};

/// Returns the columns of a case's outcomes.
[[nodiscard]] std::span<const ReportColumn<CaseTable>> OutcomeColumns();
/// Returns the columns of a metric in a case.
[[nodiscard]] std::span<const ReportColumn<MetricSummary>> MetricColumns();

}  // namespace shoal
