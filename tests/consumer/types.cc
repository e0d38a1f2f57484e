// Message types alone.
#include <shoal/nav_t.hpp>
#include <vector>

int main() {
  shoal::nav_t nav{};
  nav.x_m = 3;
  std::vector<char> bytes(static_cast<size_t>(nav.getEncodedSize()));
  nav.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  shoal::nav_t same{};
  return same.decode(bytes.data(), 0, static_cast<int>(bytes.size())) > 0 && same.x_m == 3 ? 0 : 1;
}
