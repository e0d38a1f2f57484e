#include "apps/shoal/spy_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "apps/shoal/status_command.h"
#include "lib/run/command_line/tool_commands.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

constexpr char kJavaFolder[] = "/usr/share/java/";
constexpr char kInstall[] =
    "sudo apt-get install --no-install-recommends liblcm-java libjchart2d-java default-jre "
    "fonts-dejavu-core";

std::string TextOfVariable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Returns the path of a program on the PATH, or an empty text.
std::string OnPath(const std::string& program) {
  const std::string path = TextOfVariable("PATH");
  for (size_t begin = 0; begin <= path.size();) {
    const size_t end = std::min(path.find(':', begin), path.size());
    std::string candidate = path.substr(begin, end - begin) + "/" + program;
    if (access(candidate.c_str(), X_OK) == 0) return candidate;
    begin = end + 1;
  }
  return {};
}

/// Where shoal_types.jar is: installed, or in the folder of a build.
std::vector<std::string> TypesJars(const std::string& program_dir) {
  const fs::path dir(program_dir);
  return {(dir.parent_path().parent_path().parent_path() / "share/shoal/shoal_types.jar").string(),
          (dir.parent_path() / "shoal_types.jar").string()};
}

}  // namespace

Result<std::vector<std::string>> SpyCommand(const SpyPlace& place, const SpyOptions& options,
                                            const std::string& url) {
  if (place.java.empty()) {
    return Error{
        fmt::format("no Java found. This installs all that lcm-spy needs:\n  {}", kInstall)};
  }
  std::vector<std::string> jars = {std::string(kJavaFolder) + "lcm.jar",
                                   std::string(kJavaFolder) + "jchart2d.jar"};
  for (const std::string& jar : jars) {
    if (place.exists(jar)) continue;
    return Error{fmt::format("{} is missing. This installs it:\n  {}", jar, kInstall)};
  }
  const fs::path home = fs::path(place.java).parent_path().parent_path();
  const std::string windows = "lib/libawt_xawt.so";
  if (!place.exists((home / windows).string()) &&
      !place.exists((home / "jre" / windows).string())) {
    return Error{
        fmt::format("this Java ({}) cannot open windows. This installs one that can:\n  {}",
                    home.string(), kInstall)};
  }
  const std::vector<std::string> candidates = TypesJars(place.program_dir);
  const auto types = std::ranges::find_if(candidates, place.exists);
  if (types == candidates.end()) {
    return Error{fmt::format(
        "shoal's message types for Java are not here ({}). In the folder of the sources, with a "
        "JDK (default-jdk-headless), this builds them:\n"
        "  cmake --preset release && cmake --build build --target shoal_types_jar",
        fmt::join(candidates, ", "))};
  }
  jars.push_back(*types);
  for (const std::string& jar : options.types) {
    if (!place.exists(jar)) return Error{fmt::format("--types {}: no such file", jar)};
    jars.push_back(jar);
  }
  if (!place.class_path.empty()) jars.push_back(place.class_path);
  if (!place.has_screen) {
    return Error{
        "no screen found (DISPLAY is not set). Over ssh, use ssh -X. Without any:\n"
        "  Xvfb :97 -screen 0 1280x800x24 & DISPLAY=:97 shoal spy"};
  }
  // Debian's own lcm-spy passes -Xincgc, which no Java since 10 accepts.
  return std::vector<std::string>{place.java,
                                  "-Djava.net.preferIPv4Stack=true",
                                  "-Xmx256m",
                                  "-cp",
                                  fmt::format("{}", fmt::join(jars, ":")),
                                  "lcm.spy.Spy",
                                  "--lcm-url=" + url};
}

int RunSpy(const SpyOptions& options) {
  const auto fail = [](const std::string& why) {
    fmt::print(stderr, "shoal: {}\n", why);
    return static_cast<int>(kExitEnvironment);
  };
  std::error_code error;
  const std::string java = OnPath("java");
  const SpyPlace place = {
      .exists =
          [](const std::string& path) {
            std::error_code ignored;
            return fs::exists(path, ignored);
          },
      .java = java.empty() ? "" : fs::canonical(java, error).string(),
      .program_dir = fs::read_symlink("/proc/self/exe", error).parent_path().string(),
      .has_screen = !TextOfVariable("DISPLAY").empty(),
      .class_path = TextOfVariable("CLASSPATH")};
  // What is missing first: it is missing whatever runs.
  if (const auto command = SpyCommand(place, options, ""); !command.ok()) {
    return fail(command.error());
  }
  std::string url = options.url;
  if (url.empty()) {
    const Result<std::string> found = UrlOf(options.port_base, options.vehicle);
    if (!found.ok()) return fail(found.error());
    url = *found;
  }
  Result<std::vector<std::string>> command = SpyCommand(place, options, url);
  fmt::print("lcm-spy at {}\n", url);
  std::fflush(stdout);
  return BecomeProgram(command->front(), {command->begin() + 1, command->end()});
}

}  // namespace shoal
