// The keyboard of `shoal play`: keys as orders to the clock.
#pragma once

#include <termios.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

/// The keys, as the user is shown them.
inline constexpr char kPlayKeys[] =
    "space: pause, go on   left, right: 10 s back, on   down, up: a minute   + -: twice, half as "
    "fast   0: max   home: from the begin   q: end";

struct PlayKey {
  enum class Kind { kPause, kSeekBy, kBegin, kFaster, kSlower, kFastest, kEnd };
  Kind kind;
  double seconds = 0;  ///< Of kSeekBy.

  bool operator==(const PlayKey&) const = default;
};

/// Returns the keys that the bytes of a terminal stand for, without those of no meaning here.
[[nodiscard]] std::vector<PlayKey> KeysOf(std::string_view bytes);

/// Reads keys as they are pressed, while it lives; none where standard input is not a terminal.
class Keyboard {
 public:
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  bool is_there() const { return before_.has_value(); }
  /// Returns the keys that were pressed since the last call; never waits.
  std::vector<PlayKey> Pressed();

 private:
  std::optional<termios> before_;
};

}  // namespace shoal
