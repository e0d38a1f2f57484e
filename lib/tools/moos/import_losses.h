// What an import must name: warnings, and what is lost.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace shoal {

class ImportLosses {
 public:
  /// Warns once of what a file has for several vehicles.
  void Warn(std::string warning);
  /// Adds to what is lost, once.
  void Lose(std::string loss);
  /// An app that shoal has nothing for is lost once, wherever it stands.
  void LoseApp(const std::string& app, const std::string& origin);

  std::vector<std::string>& warnings() { return warnings_; }
  std::vector<std::string>& lost() { return lost_; }

 private:
  std::vector<std::string> warnings_;
  std::vector<std::string> lost_;
  std::set<std::string> warned_;
  std::set<std::string> lost_apps_;  ///< Their classes.
};

}  // namespace shoal
