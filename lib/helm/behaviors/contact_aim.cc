#include "lib/helm/behaviors/contact_aim.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/text/letters.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

namespace {

double ExponentOf(std::string_view grade) {
  return grade == "quadratic" ? 2 : grade == "quasi" ? 1.5 : 1;
}

}  // namespace

const ContactView* KnownContact(const ContactOptions& options, const BehaviorInputs& inputs,
                                BehaviorAnswer& answer) {
  if (inputs.contacts != nullptr) {
    const auto contact = inputs.contacts->find(options.contact);
    if (contact != inputs.contacts->end()) return &contact->second;
  }
  const std::string text = "no report of the contact '" + options.contact + "' is known";
  (options.on_no_contact_ok ? answer.warning : answer.error) = text;
  return nullptr;
}

bool IsAboveOrBelow(const ContactOptions& options, const BehaviorInputs& inputs,
                    const ContactView& contact) {
  const double apart_m = std::abs(inputs.own.depth_m - contact.depth_m);
  const double may_have_come_m = kDiving_mps * std::max(0.0, contact.age_s);
  return options.vertical_separation > 0 &&
         apart_m - may_have_come_m >= options.vertical_separation;
}

double RelevanceAt(double range_m, double inner_m, double outer_m, std::string_view grade) {
  if (range_m >= outer_m) return 0;
  if (range_m <= inner_m) return 1;
  return Pow((outer_m - range_m) / (outer_m - inner_m), ExponentOf(grade));
}

void DescribeContact(const ContactOptions& options, const ContactView& contact,
                     const RelativeGeometry& geometry, std::string_view role, std::string_view rule,
                     BehaviorAnswer& answer) {
  answer.state = contact.name + ", " + std::string(role) + ", " + Whole(geometry.range_m) + " m";
  answer.role = ContactRole{.contact = contact.name,
                            .role = std::string(role),
                            .rule = std::string(rule),
                            .range_m = geometry.range_m,
                            .cpa_m = geometry.cpa_m,
                            .age_s = contact.age_s};
  if (!options.post_per_contact_info) return;
  const std::string suffix = UpperCase(contact.name);
  Post(answer, "RANGE", std::round(geometry.range_m * 10) / 10, suffix);
  Post(answer, "CLOSING_SPEED", -std::round(geometry.range_rate_mps * 100) / 100, suffix);
  Post(answer, "RELEVANCE", std::round(answer.relevance * 1000) / 1000, suffix);
  Post(answer, "ROLE", role, suffix);
}

}  // namespace shoal
