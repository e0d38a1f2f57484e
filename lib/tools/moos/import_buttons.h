// The buttons of pMarineViewer: what they post.
//
//   button_one = DEPLOY # DEPLOY_ALL=true # PATROL_ALL=true
//   button_one = MOOS_MANUAL_OVERRIDE_ALL=false
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/tools/moos/moos_file.h"

namespace shoal {

struct MoosButton {
  std::string key;                                         ///< "button_one", in lower case.
  std::string label;                                       ///< "DEPLOY"; the last that is given.
  std::string origins;                                     ///< "a.moos:12, a.moos:13".
  std::vector<std::pair<std::string, std::string>> posts;  ///< Variables and values.
};

/// Returns the buttons of a block of pMarineViewer, in the order of the file. Lines of one key are
/// one button; a part without '=' is its label; color is not posted.
/// Menu entries are buttons too, with the key "action": `action = menu_key=X # A=1 # B=2` is one,
/// to which `action+ = C=3` adds, `action = A=1 # B=2` one for each setting.
[[nodiscard]] std::vector<MoosButton> ReadButtons(const MoosBlock& block);

/// Adds what is between '#' of a button's line, or is a word of uPokeDB's, to the button.
void ReadPosts(std::string_view text, MoosButton* button);

/// Returns true for "button_one", "button_1" and "action", in any case.
[[nodiscard]] bool IsButton(std::string_view key);

/// Returns the button that starts a vehicle: it posts DEPLOY (or DEPLOY_ALL, DEPLOY_ABE of abe) =
/// true, or else MOOS_MANUAL_OVERRIDE = false; nullptr: there is none.
[[nodiscard]] const MoosButton* FindDeployButton(const std::vector<MoosButton>& buttons,
                                                 std::string_view vehicle);

}  // namespace shoal
