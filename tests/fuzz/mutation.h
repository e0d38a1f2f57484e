// Files that were damaged, the same ones in every run, and a child process with a bound of memory
// to read them in.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <random>
#include <span>
#include <string>
#include <string_view>

namespace shoal {

/// Returns a text with one to five places changed: bytes, bits, `words` put in, parts left out,
/// doubled, or cut off.
inline std::string Mutated(std::string text, std::span<const std::string_view> words,
                           std::mt19937_64& generator) {
  const auto draw = [&](size_t below) { return static_cast<size_t>(generator() % below); };
  for (size_t i = draw(5) + 1; i > 0 && !text.empty(); --i) {
    const size_t at = draw(text.size());
    const size_t length = std::min(draw(40) + 1, text.size() - at);
    switch (draw(6)) {
      case 0:
        text[at] = static_cast<char>(draw(256));
        break;
      case 1:
        text[at] = static_cast<char>(text[at] ^ (1 << draw(8)));
        break;
      case 2:
        text.insert(at, words[draw(words.size())]);
        break;
      case 3:
        text.erase(at, length);
        break;
      case 4:
        text.insert(at, text.substr(at, length));
        break;
      default:
        if (draw(4) == 0) text.resize(at);
    }
  }
  return text;
}

/// Runs `work` in a child of this process whose data are limited to `most_bytes`; false: the child
/// crashed, or `work` returned false. Nothing that it does is seen here. A sanitizer's own data are
/// more than any limit: there is none with one.
inline bool LastsWithin(size_t most_bytes, const std::function<bool()>& work) {
  const pid_t child = fork();
  if (child == 0) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    const rlimit limit = {most_bytes, most_bytes};
    setrlimit(RLIMIT_DATA, &limit);
#else
    (void)most_bytes;
#endif
    _exit(work() ? 0 : 1);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace shoal
