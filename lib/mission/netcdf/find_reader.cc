#include <dlfcn.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "lib/mission/netcdf/netcdf_file.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

constexpr char kReader[] = "shoal-netcdf";

bool IsProgram(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

/// Returns the folders of the program that runs, and of the library that this code is in: in Python
/// that is libshoal_sim.so.
std::vector<fs::path> OwnFolders() {
  std::vector<fs::path> folders;
  std::error_code error;
  Dl_info object{};
  if (dladdr(reinterpret_cast<const void*>(&FindNetcdfReader), &object) != 0 &&
      object.dli_fname != nullptr) {
    folders.push_back(fs::canonical(object.dli_fname, error).parent_path());
  }
  folders.push_back(fs::read_symlink("/proc/self/exe", error).parent_path());
  return folders;
}

}  // namespace

std::string FindNetcdfReader() {
  for (const fs::path& folder : OwnFolders()) {
    if (folder.empty()) continue;
    // Beside a program; as built, from tests and lib; as installed, from lib and bin.
    for (const char* way : {".", "../bin", "shoal/bin", "../lib/shoal/bin"}) {
      const fs::path path = (folder / way / kReader).lexically_normal();
      if (IsProgram(path)) return path.string();
    }
  }
  return kReader;
}

}  // namespace shoal
