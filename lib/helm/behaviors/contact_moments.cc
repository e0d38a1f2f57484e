#include "lib/helm/behaviors/contact_moments.h"

#include <algorithm>
#include <array>

#include "lib/base/geometry/angles.h"
#include "lib/base/text/blanks.h"
#include "lib/base/text/numbers.h"
#include "lib/helm/modes/value_text.h"

namespace shoal {
namespace {

constexpr std::array<std::string_view, 13> kMoments = {"cpa",
                                                       "os_passes_cn",
                                                       "os_passes_cn_port",
                                                       "os_passes_cn_star",
                                                       "cn_passes_os",
                                                       "cn_passes_os_port",
                                                       "cn_passes_os_star",
                                                       "os_crosses_cn",
                                                       "os_crosses_cn_bow",
                                                       "os_crosses_cn_stern",
                                                       "cn_crosses_os",
                                                       "cn_crosses_os_bow",
                                                       "cn_crosses_os_stern"};

bool ChangesSide(double before, double after) { return (before < 0) != (after < 0); }

Result<MomentFlag> ParseMomentFlag(const std::string& text) {
  const std::string_view rest = Trimmed(text);
  const size_t end = rest.find(' ');
  if (!rest.starts_with('@') || end == std::string_view::npos) {
    return Error{"flag '" + text +
                 "': write it as @MOMENT VARIABLE = value, like @cpa PASSED = "
                 "true"};
  }
  MomentFlag result;
  const std::string_view moment = rest.substr(1, end - 1);
  if (moment.starts_with('<') || moment.starts_with('>')) {
    const auto range_m = NumberIn(moment.substr(1));
    if (!range_m || *range_m < 0) {
      return Error{"flag '" + text + "': the range of @< or @> is a number, like @<50"};
    }
    result.falls_below = moment.front() == '<';
    result.range_m = *range_m;
  } else if (std::find(kMoments.begin(), kMoments.end(), moment) != kMoments.end()) {
    result.moment = moment;
  } else {
    std::string known;
    for (const std::string_view each : kMoments) known += " " + std::string(each);
    return Error{"flag '" + text + "': unknown moment '" + std::string(moment) +
                 "'; there are <RANGE >RANGE" + known};
  }
  auto flag = Flag::Parse(rest.substr(end + 1));
  if (!flag.ok()) return Error{flag.error()};
  result.flag = std::move(*flag);
  return result;
}

}  // namespace

Result<std::vector<MomentFlag>> ParseMomentFlags(const std::vector<std::string>& texts) {
  std::vector<MomentFlag> flags;
  for (const std::string& text : texts) {
    auto flag = ParseMomentFlag(text);
    if (!flag.ok()) return Error{flag.error()};
    flags.push_back(std::move(*flag));
  }
  return flags;
}

ContactMoments::Encounter ContactMoments::EncounterOf(const VesselMotion& own,
                                                      const VesselMotion& contact) {
  const auto ahead = [](const VesselMotion& vessel) {
    return UnitVector(DegToRad(vessel.heading_deg));
  };
  const auto right = [](const VesselMotion& vessel) {
    return UnitVector(DegToRad(vessel.heading_deg + 90));
  };
  const RelativeGeometry geometry = GeometryOf(own, contact);
  const Eigen::Vector2d own_from_contact = own.position_m - contact.position_m;
  return {.range_m = geometry.range_m,
          .range_rate_mps = geometry.range_rate_mps,
          .own_ahead_m = own_from_contact.dot(ahead(contact)),
          .own_right_m = own_from_contact.dot(right(contact)),
          .contact_ahead_m = -own_from_contact.dot(ahead(own)),
          .contact_right_m = -own_from_contact.dot(right(own))};
}

std::vector<const Flag*> ContactMoments::Update(const VesselMotion& own,
                                                const VesselMotion& contact,
                                                const std::vector<MomentFlag>& flags) {
  const Encounter now = EncounterOf(own, contact);
  std::vector<const Flag*> fires;
  if (!before_) {
    before_ = now;
    return fires;
  }
  const Encounter before = *before_;
  before_ = now;
  std::vector<std::string_view> moments;
  const auto comes = [&](bool happens, std::string_view moment, bool first_kind,
                         std::string_view first, std::string_view second) {
    if (!happens) return;
    moments.push_back(moment);
    moments.push_back(first_kind ? first : second);
  };
  if (before.range_rate_mps < 0 && now.range_rate_mps >= 0) moments.push_back("cpa");
  comes(before.own_ahead_m < 0 && now.own_ahead_m >= 0, "os_passes_cn", now.own_right_m < 0,
        "os_passes_cn_port", "os_passes_cn_star");
  comes(before.contact_ahead_m < 0 && now.contact_ahead_m >= 0, "cn_passes_os",
        now.contact_right_m < 0, "cn_passes_os_port", "cn_passes_os_star");
  comes(ChangesSide(before.own_right_m, now.own_right_m), "os_crosses_cn", now.own_ahead_m >= 0,
        "os_crosses_cn_bow", "os_crosses_cn_stern");
  comes(ChangesSide(before.contact_right_m, now.contact_right_m), "cn_crosses_os",
        now.contact_ahead_m >= 0, "cn_crosses_os_bow", "cn_crosses_os_stern");
  for (const MomentFlag& flag : flags) {
    const bool by_range = flag.falls_below
                              ? before.range_m >= flag.range_m && now.range_m < flag.range_m
                              : before.range_m <= flag.range_m && now.range_m > flag.range_m;
    const bool by_name = std::find(moments.begin(), moments.end(), flag.moment) != moments.end();
    if (flag.moment.empty() ? by_range : by_name) fires.push_back(&flag.flag);
  }
  return fires;
}

}  // namespace shoal
