#include "lib/tools/moos/import_buttons.h"

#include <algorithm>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/run/moos_text/fields.h"

namespace shoal {

bool IsButton(std::string_view key) {
  const std::string word = LowerCase(key.substr(0, 16));
  return word.starts_with("button_") || word == "action" || word == "action+";
}

void ReadPosts(std::string_view text, MoosButton* button) {
  while (!text.empty()) {
    const size_t end = std::min(text.find('#'), text.size());
    const std::string_view part = Trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const size_t equals = part.find('=');
    if (equals == part.npos) {
      if (!part.empty()) button->label = part;
      continue;
    }
    const std::string variable(Trimmed(part.substr(0, equals)));
    std::string_view value = Trimmed(part.substr(equals + 1));
    if (value.size() >= 2 && value.starts_with('"') && value.ends_with('"')) {
      value = value.substr(1, value.size() - 2);
    }
    const std::string word = LowerCase(variable);
    if (word == "menu_key") button->label = value;
    if (word != "color" && word != "menu_key") button->posts.emplace_back(variable, value);
  }
}

std::vector<MoosButton> ReadButtons(const MoosBlock& block) {
  std::vector<MoosButton> buttons;
  for (const MoosLine& line : block.lines) {
    if (!IsButton(line.key)) continue;
    std::string key = LowerCase(line.key);
    // "action+" adds to the entry before it.
    const bool adds = key == "action+" && !buttons.empty() && buttons.back().key == "action";
    if (adds) {
      buttons.back().origins += ", " + line.origin;
      ReadPosts(line.value, &buttons.back());
      continue;
    }
    if (key == "action+") key = "action";
    const bool is_action = key == "action";
    auto button = std::find_if(buttons.begin(), buttons.end(), [&](const MoosButton& each) {
      return each.key == key && !is_action;
    });
    if (button == buttons.end()) {
      button = buttons.insert(button, {.key = key, .label = "", .origins = "", .posts = {}});
    }
    button->origins += (button->origins.empty() ? "" : ", ") + line.origin;
    ReadPosts(line.value, &*button);
    if (!is_action || !button->label.empty()) continue;
    const MoosButton whole = *button;
    buttons.pop_back();
    for (const auto& post : whole.posts) {
      buttons.push_back({.key = key, .label = "", .origins = line.origin, .posts = {post}});
    }
  }
  return buttons;
}

const MoosButton* FindDeployButton(const std::vector<MoosButton>& buttons,
                                   std::string_view vehicle) {
  constexpr std::pair<std::string_view, std::string_view> kPosts[] = {
      {"DEPLOY", "true"}, {"MOOS_MANUAL_OVERRIDE", "false"}, {"MOOS_MANUAL_OVERIDE", "false"}};
  for (const auto& [name, wanted] : kPosts) {
    for (const MoosButton& button : buttons) {
      if (button.key == "action") continue;
      for (const auto& [variable, value] : button.posts) {
        if (!variable.starts_with(name) || LowerCase(value) != wanted) continue;
        const std::string suffix = LowerCase(variable.substr(name.size()));
        if (suffix.empty() || suffix == "_all" || suffix == "_" + LowerCase(vehicle)) {
          return &button;
        }
      }
    }
  }
  return nullptr;
}

}  // namespace shoal
