// How each medium did over each hop, from COMMS_MEDIA.
//
//   MediaTally media;
//   for (const fate_medium_t& fate : fates) media.Add(fate);
//   print(media.Text());
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "shoal/fate_medium_t.hpp"

namespace shoal {

/// What became of the transmissions of one medium, hop and link. sent = delivered + the sum of
/// `lost`.
struct MediumOutcome {
  int64_t sent = 0;
  int64_t delivered = 0;
  std::map<std::string, int64_t, std::less<>> lost;  ///< By cause.
  std::vector<double> delays_s;                      ///< Of what was delivered; in no order.
  double deepest_m = -1;        ///< Of the antennas' depths that decided; -1: none did.
  double largest_loss_db = -1;  ///< Of the path losses that were asked for.
};

class MediaTally {
 public:
  /// Kind, medium (empty: none), hop, source, destination.
  using Key = std::tuple<std::string, std::string, int32_t, std::string, std::string>;

  void Add(const fate_medium_t& fate);

  const std::map<Key, MediumOutcome>& outcomes() const { return outcomes_; }

  /// Returns a table with a line for each kind, medium and hop; empty where there is nothing.
  /// Behind the count of each cause stand the numbers that decided the last such fate.
  [[nodiscard]] std::string Text() const;
  /// Returns a line for each link of each of these.
  [[nodiscard]] std::string Csv() const;

 private:
  /// Kind, medium, hop.
  using Line = std::tuple<std::string, std::string, int32_t>;

  std::map<Key, MediumOutcome> outcomes_;
  /// The numbers that decided the last fate of each cause, as lib/tools/view/fate_text.h writes
  /// them.
  std::map<Line, std::map<std::string, std::string, std::less<>>> last_numbers_;
};

}  // namespace shoal
