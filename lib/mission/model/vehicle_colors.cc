#include "lib/mission/model/vehicle_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/text/letters.h"

namespace shoal {

namespace {

struct NamedColor {
  std::string_view name;
  uint32_t rgb;
};

// CSS Color Module Level 4, section 6.1.
constexpr NamedColor kNamed[] = {
    {"aliceblue", 0xf0f8ff},
    {"antiquewhite", 0xfaebd7},
    {"aqua", 0x00ffff},
    {"aquamarine", 0x7fffd4},
    {"azure", 0xf0ffff},
    {"beige", 0xf5f5dc},
    {"bisque", 0xffe4c4},
    {"black", 0x000000},
    {"blanchedalmond", 0xffebcd},
    {"blue", 0x0000ff},
    {"blueviolet", 0x8a2be2},
    {"brown", 0xa52a2a},
    {"burlywood", 0xdeb887},
    {"cadetblue", 0x5f9ea0},
    {"chartreuse", 0x7fff00},
    {"chocolate", 0xd2691e},
    {"coral", 0xff7f50},
    {"cornflowerblue", 0x6495ed},
    {"cornsilk", 0xfff8dc},
    {"crimson", 0xdc143c},
    {"cyan", 0x00ffff},
    {"darkblue", 0x00008b},
    {"darkcyan", 0x008b8b},
    {"darkgoldenrod", 0xb8860b},
    {"darkgray", 0xa9a9a9},
    {"darkgreen", 0x006400},
    {"darkkhaki", 0xbdb76b},
    {"darkmagenta", 0x8b008b},
    {"darkolivegreen", 0x556b2f},
    {"darkorange", 0xff8c00},
    {"darkorchid", 0x9932cc},
    {"darkred", 0x8b0000},
    {"darksalmon", 0xe9967a},
    {"darkseagreen", 0x8fbc8f},
    {"darkslateblue", 0x483d8b},
    {"darkslategray", 0x2f4f4f},
    {"darkturquoise", 0x00ced1},
    {"darkviolet", 0x9400d3},
    {"deeppink", 0xff1493},
    {"deepskyblue", 0x00bfff},
    {"dimgray", 0x696969},
    {"dodgerblue", 0x1e90ff},
    {"firebrick", 0xb22222},
    {"floralwhite", 0xfffaf0},
    {"forestgreen", 0x228b22},
    {"fuchsia", 0xff00ff},
    {"gainsboro", 0xdcdcdc},
    {"ghostwhite", 0xf8f8ff},
    {"gold", 0xffd700},
    {"goldenrod", 0xdaa520},
    {"gray", 0x808080},
    {"green", 0x008000},
    {"greenyellow", 0xadff2f},
    {"honeydew", 0xf0fff0},
    {"hotpink", 0xff69b4},
    {"indianred", 0xcd5c5c},
    {"indigo", 0x4b0082},
    {"ivory", 0xfffff0},
    {"khaki", 0xf0e68c},
    {"lavender", 0xe6e6fa},
    {"lavenderblush", 0xfff0f5},
    {"lawngreen", 0x7cfc00},
    {"lemonchiffon", 0xfffacd},
    {"lightblue", 0xadd8e6},
    {"lightcoral", 0xf08080},
    {"lightcyan", 0xe0ffff},
    {"lightgoldenrodyellow", 0xfafad2},
    {"lightgray", 0xd3d3d3},
    {"lightgreen", 0x90ee90},
    {"lightpink", 0xffb6c1},
    {"lightsalmon", 0xffa07a},
    {"lightseagreen", 0x20b2aa},
    {"lightskyblue", 0x87cefa},
    {"lightslategray", 0x778899},
    {"lightsteelblue", 0xb0c4de},
    {"lightyellow", 0xffffe0},
    {"lime", 0x00ff00},
    {"limegreen", 0x32cd32},
    {"linen", 0xfaf0e6},
    {"magenta", 0xff00ff},
    {"maroon", 0x800000},
    {"mediumaquamarine", 0x66cdaa},
    {"mediumblue", 0x0000cd},
    {"mediumorchid", 0xba55d3},
    {"mediumpurple", 0x9370db},
    {"mediumseagreen", 0x3cb371},
    {"mediumslateblue", 0x7b68ee},
    {"mediumspringgreen", 0x00fa9a},
    {"mediumturquoise", 0x48d1cc},
    {"mediumvioletred", 0xc71585},
    {"midnightblue", 0x191970},
    {"mintcream", 0xf5fffa},
    {"mistyrose", 0xffe4e1},
    {"moccasin", 0xffe4b5},
    {"navajowhite", 0xffdead},
    {"navy", 0x000080},
    {"oldlace", 0xfdf5e6},
    {"olive", 0x808000},
    {"olivedrab", 0x6b8e23},
    {"orange", 0xffa500},
    {"orangered", 0xff4500},
    {"orchid", 0xda70d6},
    {"palegoldenrod", 0xeee8aa},
    {"palegreen", 0x98fb98},
    {"paleturquoise", 0xafeeee},
    {"palevioletred", 0xdb7093},
    {"papayawhip", 0xffefd5},
    {"peachpuff", 0xffdab9},
    {"peru", 0xcd853f},
    {"pink", 0xffc0cb},
    {"plum", 0xdda0dd},
    {"powderblue", 0xb0e0e6},
    {"purple", 0x800080},
    {"rebeccapurple", 0x663399},
    {"red", 0xff0000},
    {"rosybrown", 0xbc8f8f},
    {"royalblue", 0x4169e1},
    {"saddlebrown", 0x8b4513},
    {"salmon", 0xfa8072},
    {"sandybrown", 0xf4a460},
    {"seagreen", 0x2e8b57},
    {"seashell", 0xfff5ee},
    {"sienna", 0xa0522d},
    {"silver", 0xc0c0c0},
    {"skyblue", 0x87ceeb},
    {"slateblue", 0x6a5acd},
    {"slategray", 0x708090},
    {"snow", 0xfffafa},
    {"springgreen", 0x00ff7f},
    {"steelblue", 0x4682b4},
    {"tan", 0xd2b48c},
    {"teal", 0x008080},
    {"thistle", 0xd8bfd8},
    {"tomato", 0xff6347},
    {"turquoise", 0x40e0d0},
    {"violet", 0xee82ee},
    {"wheat", 0xf5deb3},
    {"white", 0xffffff},
    {"whitesmoke", 0xf5f5f5},
    {"yellow", 0xffff00},
    {"yellowgreen", 0x9acd32},
};

// For those without a colour of their own: ten hues that differ in lightness too.
constexpr std::array<uint32_t, 10> kPalette = {0x1f77b4, 0xd95f02, 0x2ca02c, 0xc51b3a, 0x7b4fa3,
                                               0x8c564b, 0xd667ad, 0x5f6b75, 0x9a9a00, 0x12a5b8};

using Rgb = std::array<double, 3>;  // Each in [0, 1].

Rgb RgbOf(uint32_t color) {
  return {((color >> 16) & 0xff) / 255.0, ((color >> 8) & 0xff) / 255.0, (color & 0xff) / 255.0};
}

uint32_t ValueOf(const Rgb& rgb) {
  const auto byte = [](double value) {
    return static_cast<uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
  };
  return byte(rgb[0]) << 16 | byte(rgb[1]) << 8 | byte(rgb[2]);
}

/// How light it looks, from 0 to 1 (Rec. 709 weights, without undoing gamma).
double Lightness(const Rgb& rgb) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

Rgb DarkEnough(Rgb rgb) {
  constexpr double kLightest = 0.68;
  const double lightness = Lightness(rgb);
  if (lightness <= kLightest) return rgb;
  for (double& part : rgb) part *= kLightest / lightness;
  return rgb;
}

/// Returns the relative luminance, 0 to 1 (WCAG 2).
double Luminance(const Rgb& rgb) {
  const auto linear = [](double part) {
    return part <= 0.04045 ? part / 12.92 : Pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2]);
}

/// Mixes with white as the viewer does, to be seen on its dark ground (web, readable()).
Rgb LightEnough(const Rgb& rgb) {
  constexpr double kDarkest = 0.2;
  Rgb mixed = rgb;
  for (double amount = 0; amount <= 1 && Luminance(mixed) < kDarkest; amount += 0.04) {
    for (size_t i = 0; i < 3; ++i) mixed[i] = rgb[i] + (1 - rgb[i]) * amount;
  }
  return mixed;
}

double Distance(const Rgb& a, const Rgb& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A colour as it is on white paper and on the viewer's dark ground.
struct SeenColor {
  Rgb on_paper;
  Rgb on_dark;
};

SeenColor SeenOf(const Rgb& rgb) { return {DarkEnough(rgb), LightEnough(rgb)}; }

/// The colours of `kPalette` first, then ones around the wheel by the golden ratio.
Rgb PaletteColor(size_t index) {
  if (index < kPalette.size()) return RgbOf(kPalette[index]);
  constexpr double kGoldenRatio = 0.61803398874989485;
  const double turns = kGoldenRatio * static_cast<double>(index);
  const double hue = 6 * (turns - std::floor(turns));
  const double value = std::array{0.85, 0.6, 0.4}[index % 3];
  const auto part = [&](double offset) {
    const double k = std::fmod(offset + hue, 6.0);
    return value - value * 0.85 * std::max(0.0, std::min({k, 4 - k, 1.0}));
  };
  return {part(5), part(3), part(1)};
}

/// Below this difference a reader would mix up two colours, if there is a choice.
constexpr double kAlike = 0.36;

/// Returns the first colour of the palette that differs by `least_difference` from all taken, which
/// is lowered where there is none.
Rgb NextColor(const std::vector<SeenColor>& taken, double* least_difference) {
  constexpr size_t kNumCandidates = 100;
  constexpr double kSmallest = 0.02;  // Below, two colours look the same.
  // How near the nearest of all taken is, on that ground where it is nearer. On the dark one, where
  // colours are lighter, they may be somewhat nearer.
  constexpr double kOnDark = 1.3;
  std::array<double, kNumCandidates> nearest;
  for (size_t i = 0; i < kNumCandidates; ++i) {
    const SeenColor seen = SeenOf(PaletteColor(i));
    nearest.at(i) = 2;
    for (const SeenColor& other : taken) {
      nearest.at(i) = std::min({nearest.at(i), Distance(seen.on_paper, other.on_paper),
                                kOnDark * Distance(seen.on_dark, other.on_dark)});
    }
  }
  for (; *least_difference > kSmallest; *least_difference *= 0.85) {
    for (size_t i = 0; i < kNumCandidates; ++i) {
      if (nearest.at(i) >= *least_difference) return PaletteColor(i);
    }
  }
  return PaletteColor(taken.size());
}

std::string Plain(std::string_view name) {
  std::string plain;
  for (const char letter : name) {
    if (letter == '_' || letter == ' ') continue;
    plain += LowerCase(letter);
  }
  if (const size_t grey = plain.find("grey"); grey != std::string::npos) plain[grey + 2] = 'a';
  return plain;
}

std::optional<uint32_t> HexColor(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  uint32_t rgb = 0;
  for (const char letter : text.substr(1)) {
    const size_t digit = std::string_view("0123456789abcdef").find(letter);
    if (digit == std::string_view::npos) return std::nullopt;
    rgb = rgb * 16 + static_cast<uint32_t>(digit);
  }
  return rgb;
}

}  // namespace

std::optional<uint32_t> ColorOf(std::string_view name) {
  constexpr size_t kLongest = 64;
  if (name.size() > kLongest) return std::nullopt;
  const std::string plain = Plain(name);
  for (const NamedColor& named : kNamed) {
    if (named.name == plain) return named.rgb;
  }
  return HexColor(plain);
}

std::vector<uint32_t> ChooseColors(const std::vector<std::string>& requested) {
  std::vector<std::optional<uint32_t>> given(requested.size());
  std::vector<SeenColor> taken;
  std::set<uint32_t> requested_before;
  for (size_t i = 0; i < requested.size(); ++i) {
    const auto color = ColorOf(requested[i]);
    if (!color || !requested_before.insert(*color).second) continue;
    given[i] = color;
    taken.push_back(SeenOf(RgbOf(*color)));
  }
  double least_difference = kAlike;
  std::vector<uint32_t> chosen;
  chosen.reserve(given.size());
  for (const std::optional<uint32_t>& color : given) {
    if (color) {
      chosen.push_back(*color);
      continue;
    }
    const Rgb next = NextColor(taken, &least_difference);
    taken.push_back(SeenOf(next));
    chosen.push_back(ValueOf(next));
  }
  return chosen;
}

std::vector<std::string> AssignColors(const std::vector<std::string>& requested) {
  std::vector<std::string> texts;
  texts.reserve(requested.size());
  for (const uint32_t color : ChooseColors(requested)) {
    texts.push_back(ColorText(ValueOf(DarkEnough(RgbOf(color)))));
  }
  return texts;
}

std::string ColorText(uint32_t color) { return fmt::format("#{:06x}", color & 0xffffff); }

}  // namespace shoal
