#include "apps/viewer/outside_tiles.h"

#include <algorithm>

namespace shoal {

namespace {

constexpr size_t kLongestUrl = 1000;

bool IsOfHost(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '.' || letter == '-' || letter == ':';
}

size_t EndOfScheme(std::string_view url) {
  for (const std::string_view scheme : {"https://", "http://"}) {
    if (url.starts_with(scheme)) return scheme.size();
  }
  return 0;
}

}  // namespace

std::string OutsideTilesProblem(std::string_view url) {
  const size_t host = EndOfScheme(url);
  const size_t path = url.find('/', host);
  if (host == 0 || path == url.npos || path == host) {
    return "an address of tiles is like https://HOST/{z}/{x}/{y}.png";
  }
  const std::string_view name = url.substr(host, path - host);
  const std::string_view rest = url.substr(path);
  const bool is_odd = std::any_of(rest.begin(), rest.end(), [](char letter) {
    return letter <= ' ' || letter > '~' || letter == '"' || letter == '\'' || letter == ';' ||
           letter == '<' || letter == '>' || letter == '\\';
  });
  if (!std::all_of(name.begin(), name.end(), IsOfHost) || is_odd || url.size() > kLongestUrl) {
    return "an address of tiles has letters, digits and signs of addresses alone";
  }
  for (const std::string_view place : {"{z}", "{x}", "{y}"}) {
    if (rest.find(place) == rest.npos) {
      return "an address of tiles has {z}, {x} and {y} in its path, where a tile's zoom, column "
             "and "
             "row stand";
    }
  }
  return "";
}

std::string OriginOf(std::string_view url) {
  return std::string(url.substr(0, url.find('/', EndOfScheme(url))));
}

}  // namespace shoal
