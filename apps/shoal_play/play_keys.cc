#include "apps/shoal_play/play_keys.h"

#include <poll.h>
#include <unistd.h>

#include <array>

namespace shoal {

namespace {

struct KeyRow {
  std::string_view bytes;
  PlayKey key;
};

constexpr double kShort_s = 10;
constexpr double kLong_s = 60;

using Kind = PlayKey::Kind;
/// Where one begins with another, the longer one comes first.
constexpr KeyRow kKeys[] = {
    {"\033[C", {Kind::kSeekBy, kShort_s}},
    {"\033[D", {Kind::kSeekBy, -kShort_s}},
    {"\033[A", {Kind::kSeekBy, kLong_s}},
    {"\033[B", {Kind::kSeekBy, -kLong_s}},
    {"\033[H", {Kind::kBegin}},
    {"\033[1~", {Kind::kBegin}},
    {"\033OH", {Kind::kBegin}},
    {" ", {Kind::kPause}},
    {"+", {Kind::kFaster}},
    {"=", {Kind::kFaster}},
    {"-", {Kind::kSlower}},
    {"0", {Kind::kFastest}},
    {"q", {Kind::kEnd}},
};

}  // namespace

std::vector<PlayKey> KeysOf(std::string_view bytes) {
  std::vector<PlayKey> keys;
  while (!bytes.empty()) {
    size_t length = 1;
    for (const KeyRow& row : kKeys) {
      if (!bytes.starts_with(row.bytes)) continue;
      keys.push_back(row.key);
      length = row.bytes.size();
      break;
    }
    bytes.remove_prefix(length);
  }
  return keys;
}

Keyboard::Keyboard() {
  termios now{};
  // In the background a change of the terminal would stop this process.
  if (tcgetattr(STDIN_FILENO, &now) != 0 || tcgetpgrp(STDIN_FILENO) != getpgrp()) return;
  before_ = now;
  now.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  now.c_cc[VMIN] = 0;
  now.c_cc[VTIME] = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &now);
}

Keyboard::~Keyboard() {
  if (before_) tcsetattr(STDIN_FILENO, TCSANOW, &*before_);
}

std::vector<PlayKey> Keyboard::Pressed() {
  pollfd input = {.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  if (!before_ || poll(&input, 1, 0) <= 0 || (input.revents & POLLIN) == 0) return {};
  std::array<char, 64> bytes;
  const ssize_t size = read(STDIN_FILENO, bytes.data(), bytes.size());
  return size <= 0 ? std::vector<PlayKey>() : KeysOf({bytes.data(), static_cast<size_t>(size)});
}

}  // namespace shoal
