// Node reports as MOOS apps write them, both ways.
//
//   const LocalFrame frame({.lat_deg = 43.8253, .lon_deg = -70.3304});
//   Result<node_report_t> report = ParseNodeReport("NAME=alpha,X=5,Y=-20,SPD=1,...", &frame);
//   std::string text = FormatNodeReport(*report, MoosForm::kJson);
//
//   NAME X Y SPD HDG COG DEP LAT LON TYPE COLOR GROUP MODE ALLSTOP ALTITUDE SPD_OG INDEX TIME
//   LENGTH
//
// are the keys of the fields of node_report_t, without regard to case. HDG_OG stands for COG, DEPTH
// for DEP, LONG for LON where the latter are absent. Every other key is one of the report's extra
// fields, in its place among them. An extra field whose key is one of those above is written with
// "extra." before its key; that prefix is taken off when reading.
//
// TIME is seconds and becomes utime, exactly. Where it is Unix time it stays Unix time: a mission
// that shall agree with it has start_utime = its start in microseconds since 1970.
#pragma once

#include <string>
#include <string_view>

#include "lib/check/result.h"
#include "lib/geodesy/local_frame.h"
#include "shoal/node_report_t.hpp"

namespace shoal {

enum class MoosForm {
  kFields,  ///< NAME=alpha,X=5,... (lib/moos/fields.h states how odd values are written.)
  kJson,    ///< {"NAME":"alpha","X":5,...}
};

/// Reads either form. The error names the key and states what to write.
///
/// Required: NAME (not empty), TIME, SPD, HDG, and X and Y or LAT and LON; DEP too where TYPE is
/// auv, uuv or glider, whose position it is part of. Numbers must be finite. X and Y are
/// computed from LAT and LON, or the other way round, where `frame` is given; without it LAT and
/// LON stay 0 where absent. Where absent, DEP is 0, ALTITUDE -1 (not known), SPD_OG is SPD, COG is
/// HDG, INDEX and LENGTH are 0, texts are empty.
[[nodiscard]] Result<shoal::node_report_t> ParseNodeReport(std::string_view text,
                                                           const LocalFrame* frame = nullptr);

/// Writes one line with every field; empty texts and an ALTITUDE of -1 are left out.
/// ParseNodeReport gives back an equal report where the name is not empty and the numbers are
/// finite (JSON: and the texts UTF-8). A number that is not finite is written as nan or inf, in
/// JSON as null, and refused by the reader.
[[nodiscard]] std::string FormatNodeReport(const shoal::node_report_t& report, MoosForm form);

}  // namespace shoal
