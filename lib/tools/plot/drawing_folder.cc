#include "lib/tools/plot/drawing_folder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <ostream>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/os/text_file.h"
#include "lib/run/command_line/find_program.h"
#include "lib/tools/plot/plot_gnuplot.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// Where figures are drawn before they go to their place: a new folder there that is only the
/// user's, with the data and scripts in `gnuplot` below it. gnuplot would write through a link.
class DrawingFolder {
 public:
  DrawingFolder() = default;
  ~DrawingFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  DrawingFolder(const DrawingFolder&) = delete;
  DrawingFolder& operator=(const DrawingFolder&) = delete;

  /// Returns whether it could be made; errno holds the reason where not.
  bool Make(const fs::path& out_dir) {
    std::string name = (out_dir / ".gnuplot-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) return false;
    path_ = name;
    std::error_code error;
    fs::create_directory(scripts(), error);
    if (error) errno = error.value();
    return !error;
  }

  const fs::path& path() const { return path_; }
  fs::path scripts() const { return path_ / "gnuplot"; }

 private:
  fs::path path_;
};

/// Draws figures one after another.
class Drawing {
 public:
  Drawing(const DrawingOptions& options, const std::string& gnuplot, std::ostream& out,
          std::ostream& err)
      : options_(options), gnuplot_(gnuplot), out_dir_(options.out_dir), out_(out), err_(err) {}

  int Draw(const std::vector<Figure>& figures) {
    std::error_code error;
    fs::create_directories(out_dir_, error);
    if (error) {
      return Fail(kExitEnvironment, fmt::format("cannot make the folder {}: {}; name another: "
                                                "--out DIR",
                                                out_dir_.string(), error.message()));
    }
    DrawingFolder folder;
    if (!folder.Make(out_dir_)) {
      return Fail(kExitEnvironment, fmt::format("cannot write into {}: {}; name another: --out DIR",
                                                out_dir_.string(), ErrnoText(errno)));
    }
    int code = kExitOk;
    for (const Figure& figure : figures) {
      if (code == kExitOk) code = DrawFigure(figure, folder);
    }
    if (!options_.keep) return code;
    const fs::path scripts = out_dir_ / "gnuplot";
    fs::rename(folder.scripts(), scripts, error);
    if (error) return CannotWrite(scripts, error);
    out_ << fmt::format("data and scripts: {}\n", scripts.string());
    return code;
  }

 private:
  int Fail(int code, const std::string& why) {
    err_ << "shoal: " << why << '\n';
    return code;
  }

  int DrawFigure(const Figure& figure, const DrawingFolder& folder) {
    if (!figure.why_left_out.empty()) {
      out_ << fmt::format("{} is left out: {}\n", figure.name, figure.why_left_out);
      return kExitOk;
    }
    const fs::path scripts = folder.scripts();
    if (!TextFile((scripts / (figure.name + ".dat")).string(), figure.data).Flush() ||
        !TextFile((scripts / (figure.name + ".gp")).string(), figure.script).Flush()) {
      return Fail(kExitEnvironment,
                  fmt::format("cannot write into {}: is the disk full?", out_dir_.string()));
    }
    const auto drawn = RunGnuplot(gnuplot_, scripts.string(), figure.name + ".gp");
    if (!drawn.ok()) return Fail(kExitEnvironment, drawn.error());
    const std::string name = figure.name + (options_.png ? ".png" : ".svg");
    std::error_code error;
    fs::rename(folder.path() / name, out_dir_ / name, error);
    if (error) return CannotWrite(out_dir_ / name, error);
    out_ << (out_dir_ / name).string() << '\n';
    return kExitOk;
  }

  int CannotWrite(const fs::path& path, const std::error_code& error) {
    return Fail(kExitEnvironment, fmt::format("cannot write {}: {}; name another folder: --out DIR",
                                              path.string(), error.message()));
  }

  const DrawingOptions& options_;
  const std::string& gnuplot_;
  const fs::path& out_dir_;
  std::ostream& out_;
  std::ostream& err_;
};

}  // namespace

std::string FindGnuplot(const std::string& search_path, std::ostream& err) {
  std::string gnuplot = FindExecutable("gnuplot", search_path);
  if (gnuplot.empty()) {
    err << "shoal: gnuplot is missing, which draws the figures. This installs it:\n"
           "  sudo apt-get install --no-install-recommends gnuplot-nox\n";
  }
  return gnuplot;
}

int DrawInto(const DrawingOptions& options, const std::string& gnuplot,
             const std::vector<Figure>& figures, std::ostream& out, std::ostream& err) {
  return Drawing(options, gnuplot, out, err).Draw(figures);
}

}  // namespace shoal
