#include "lib/moos/node_report_text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "lib/mission/suggest.h"
#include "lib/moos/fields.h"
#include "lib/moos/json_fields.h"
#include "lib/moos/numbers.h"

namespace shoal {
namespace {

using Member =
    std::variant<std::string node_report_t::*, double node_report_t::*, int64_t node_report_t::*>;

struct StandardKey {
  std::string_view key;
  Member member;
};

/// In the order in which they are written.
const std::array<StandardKey, 19> kStandardKeys = {{
    {"NAME", &node_report_t::name},
    {"X", &node_report_t::x_m},
    {"Y", &node_report_t::y_m},
    {"SPD", &node_report_t::speed_mps},
    {"HDG", &node_report_t::heading_deg},
    {"COG", &node_report_t::course_over_ground_deg},
    {"DEP", &node_report_t::depth_m},
    {"LAT", &node_report_t::lat_deg},
    {"LON", &node_report_t::lon_deg},
    {"TYPE", &node_report_t::type},
    {"COLOR", &node_report_t::color},
    {"GROUP", &node_report_t::group},
    {"MODE", &node_report_t::mode},
    {"ALLSTOP", &node_report_t::all_stop},
    {"ALTITUDE", &node_report_t::altitude_m},
    {"SPD_OG", &node_report_t::speed_over_ground_mps},
    {"INDEX", &node_report_t::index},
    {"TIME", &node_report_t::utime},
    {"LENGTH", &node_report_t::length_m},
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kOtherNames = {
    {{"HDG_OG", "COG"}, {"DEPTH", "DEP"}, {"LONG", "LON"}}};

constexpr std::string_view kExtraPrefix = "extra.";
constexpr double kAltitudeUnknown = -1;

std::string UpperKey(std::string_view key) {
  std::string upper(key);
  for (char& c : upper) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return upper;
}

/// Returns the standard key that `key` is; nullptr: it is none.
const StandardKey* FindStandard(std::string_view key) {
  constexpr size_t kLongest = 8;
  if (key.size() > kLongest) return nullptr;
  const std::string upper = UpperKey(key);
  for (const StandardKey& standard : kStandardKeys) {
    if (standard.key == upper) return &standard;
  }
  return nullptr;
}

std::string_view OtherNameOf(std::string_view key) {
  for (const auto& [other, name] : kOtherNames) {
    if (UpperKey(key.substr(0, 8)) == other) return name;
  }
  return {};
}

/// Fills a report from fields.
class ReportReader {
 public:
  explicit ReportReader(const LocalFrame* frame) : frame_(frame) {}

  Result<node_report_t> Read(std::vector<MoosField> fields) {
    report_.altitude_m = kAltitudeUnknown;
    for (const MoosField& field : fields) {
      const StandardKey* standard = FindStandard(field.key);
      if (standard != nullptr && !given_.emplace(standard->key, field.value).second) {
        return Error{fmt::format("{} is given twice; leave one of the two", standard->key)};
      }
    }
    for (MoosField& field : fields) TakeField(std::move(field));
    for (const StandardKey& standard : kStandardKeys) {
      const auto at = given_.find(standard.key);
      if (at == given_.end()) continue;
      if (auto problem = TakeStandard(standard, at->second)) return Error{std::move(*problem)};
    }
    if (auto problem = Complete()) return Error{std::move(*problem)};
    report_.num_extra = static_cast<int32_t>(report_.extra.size());
    return std::move(report_);
  }

 private:
  using Problem = std::optional<std::string>;

  bool Has(std::string_view key) const { return given_.contains(key); }

  /// Sorts out the extra fields, and the other names of standard keys.
  void TakeField(MoosField field) {
    if (FindStandard(field.key) != nullptr) return;
    const std::string_view name = OtherNameOf(field.key);
    if (!name.empty() && given_.emplace(name, field.value).second) return;
    if (field.key.starts_with(kExtraPrefix)) field.key.erase(0, kExtraPrefix.size());
    report_.extra.push_back({.key = std::move(field.key), .value = std::move(field.value)});
  }

  Problem TakeStandard(const StandardKey& standard, const std::string& value) {
    if (const auto* text = std::get_if<std::string node_report_t::*>(&standard.member)) {
      report_.*(*text) = value;
    } else if (const auto* real = std::get_if<double node_report_t::*>(&standard.member)) {
      const auto number = ParseNumber(value);
      if (!number) return NotANumber(standard.key, value, "a finite number");
      report_.*(*real) = *number;
    } else if (standard.key == "TIME") {
      const auto utime = ParseSeconds(value);
      if (!utime) return NotANumber(standard.key, value, "seconds, within 9.2e12 of 0");
      report_.utime = *utime;
    } else {
      const std::string_view digits = Trimmed(value);
      const char* end = digits.data() + digits.size();
      const auto [stop, error] = std::from_chars(digits.data(), end, report_.index);
      if (error != std::errc() || stop != end) {
        return NotANumber(standard.key, value, "a whole number");
      }
    }
    return std::nullopt;
  }

  static std::string NotANumber(std::string_view key, const std::string& value,
                                std::string_view wanted) {
    return fmt::format("{} = {} is not {}", key, Quoted(value), wanted);
  }

  Problem Complete() {
    if (!Has("NAME")) return "NAME is missing; write NAME=<vehicle>";
    if (report_.name.empty()) return "NAME is empty; write NAME=<vehicle>";
    for (const std::string_view key : {"TIME", "SPD", "HDG"}) {
      if (!Has(key)) return fmt::format("{} is missing in the report of {}", key, QuotedName());
    }
    if (Has("X") != Has("Y")) return OneOfTwo("X", "Y");
    if (Has("LAT") != Has("LON")) return OneOfTwo("LAT", "LON");
    const std::string type = UpperKey(report_.type.substr(0, 8));
    if (!Has("DEP") && (type == "AUV" || type == "UUV" || type == "GLIDER")) {
      return fmt::format(
          "DEP is missing in the report of {}, whose TYPE is {}; write DEP=0 for one "
          "at the surface",
          QuotedName(), report_.type);
    }
    if (!Has("SPD_OG")) report_.speed_over_ground_mps = report_.speed_mps;
    if (!Has("COG")) report_.course_over_ground_deg = report_.heading_deg;
    return CompletePosition();
  }

  Problem CompletePosition() {
    if (Has("X") && (Has("LAT") || frame_ == nullptr)) return std::nullopt;
    if (Has("X")) {
      const GeoPoint point = frame_->ToGeo({report_.x_m, report_.y_m});
      if (!std::isfinite(point.lat_deg) || !std::isfinite(point.lon_deg)) {
        return fmt::format(
            "X, Y of {} are more than {} km from the origin, and LAT, LON are "
            "missing",
            QuotedName(), LocalFrame::kReach_m / 1000);
      }
      report_.lat_deg = point.lat_deg;
      report_.lon_deg = point.lon_deg;
      return std::nullopt;
    }
    if (!Has("LAT")) return fmt::format("X and Y are missing in the report of {}", QuotedName());
    if (frame_ == nullptr) {
      return fmt::format(
          "X and Y are missing in the report of {}; to take LAT and LON instead, "
          "give the mission's origin",
          QuotedName());
    }
    const auto position_m = frame_->ToLocal({report_.lat_deg, report_.lon_deg});
    if (!position_m) {
      return fmt::format(
          "LAT = {}, LON = {} of {} is no place on the Earth within {} km of the "
          "origin",
          report_.lat_deg, report_.lon_deg, QuotedName(), LocalFrame::kReach_m / 1000);
    }
    report_.x_m = position_m->x();
    report_.y_m = position_m->y();
    return std::nullopt;
  }

  std::string OneOfTwo(std::string_view a, std::string_view b) const {
    return fmt::format("{} is missing in the report of {}, which has {}; write both or neither",
                       Has(a) ? b : a, QuotedName(), Has(a) ? a : b);
  }

  std::string QuotedName() const { return Quoted(report_.name); }

  const LocalFrame* frame_;
  node_report_t report_{};
  std::map<std::string_view, std::string> given_;  ///< By standard key.
};

/// Writes one report in one form.
class ReportText {
 public:
  explicit ReportText(MoosForm form) : form_(form) {}

  void Text(std::string_view key, std::string_view value) {
    if (form_ == MoosForm::kFields) {
      AppendField(key, value, &text_);
    } else {
      JsonKey(key);
      AppendJsonString(value, &text_);
    }
  }

  void Number(std::string_view key, std::string_view digits) {
    if (form_ == MoosForm::kFields) {
      AppendField(key, digits, &text_);
    } else {
      JsonKey(key);
      text_ += digits;
    }
  }

  void Real(std::string_view key, double value) {
    const bool is_null = form_ == MoosForm::kJson && !std::isfinite(value);
    Number(key, is_null ? "null" : NumberText(value));
  }

  std::string Take() && {
    return form_ == MoosForm::kJson ? "{" + std::move(text_) + "}" : std::move(text_);
  }

 private:
  void JsonKey(std::string_view key) {
    if (!text_.empty()) text_ += ',';
    AppendJsonString(key, &text_);
    text_ += ':';
  }

  MoosForm form_;
  std::string text_;
};

}  // namespace

Result<node_report_t> ParseNodeReport(std::string_view text, const LocalFrame* frame) {
  const bool is_json = Trimmed(text).starts_with('{');
  Result<std::vector<MoosField>> fields = is_json ? ParseJsonFields(text) : ParseFields(text);
  if (!fields.ok()) return Error{fields.error()};
  return ReportReader(frame).Read(std::move(*fields));
}

std::string FormatNodeReport(const node_report_t& report, MoosForm form) {
  ReportText text(form);
  for (const StandardKey& standard : kStandardKeys) {
    if (const auto* member = std::get_if<std::string node_report_t::*>(&standard.member)) {
      const std::string& value = report.*(*member);
      if (!value.empty() || standard.key == "NAME") text.Text(standard.key, value);
    } else if (const auto* real = std::get_if<double node_report_t::*>(&standard.member)) {
      const double value = report.*(*real);
      if (standard.key != "ALTITUDE" || value != kAltitudeUnknown) text.Real(standard.key, value);
    } else if (standard.key == "TIME") {
      text.Number(standard.key, SecondsText(report.utime));
    } else {
      text.Number(standard.key, std::to_string(report.index));
    }
  }
  for (const key_value_t& field : report.extra) {
    const bool is_taken = FindStandard(field.key) != nullptr || field.key.starts_with(kExtraPrefix);
    text.Text(is_taken ? std::string(kExtraPrefix) + field.key : field.key, field.value);
  }
  return std::move(text).Take();
}

}  // namespace shoal
