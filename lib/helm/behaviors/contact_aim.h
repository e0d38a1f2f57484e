// What all behaviors that are about a contact begin with: the contact, and how relevant it is.
#pragma once

#include <string_view>

#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/contact_options.h"

namespace shoal {

/// Returns the contact of the options; nullptr, and a warning or an error in `answer`, where the
/// helm does not know it.
[[nodiscard]] const ContactView* KnownContact(const ContactOptions& options,
                                              const BehaviorInputs& inputs, BehaviorAnswer& answer);

/// Returns r ^ g: r = (outer - range) / (outer - inner), limited to 0..1, and exactly 0 from outer
/// on; g = 1 ("linear"), 1.5 ("quasi") or 2 ("quadratic"). An inner distance beyond the outer one
/// counts as that.
[[nodiscard]] double RelevanceAt(double range_m, double inner_m, double outer_m,
                                 std::string_view grade);

/// How fast a contact may rise or dive after its last report: of a Remus 100 that pitches by 20
/// degrees.
inline constexpr double kDiving_mps = 0.5;

/// Returns true where the contact is too far above or below own ship to keep clear of, even if it
/// has come nearer by kDiving_mps since its report.
[[nodiscard]] bool IsAboveOrBelow(const ContactOptions& options, const BehaviorInputs& inputs,
                                  const ContactView& contact);

/// How many times the weight of what keeps clear counts in imminent danger: nothing outvotes it.
inline constexpr double kUrgencyInDanger = 8;

/// Fills in state and role, and the reports of post_per_contact_info: RANGE_<CONTACT>,
/// CLOSING_SPEED_<CONTACT>, RELEVANCE_<CONTACT>, ROLE_<CONTACT>.
void DescribeContact(const ContactOptions& options, const ContactView& contact,
                     const RelativeGeometry& geometry, std::string_view role, std::string_view rule,
                     BehaviorAnswer& answer);

}  // namespace shoal
