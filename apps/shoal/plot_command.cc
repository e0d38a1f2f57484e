#include "apps/shoal/plot_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <ostream>
#include <utility>

#include "lib/analysis/plot_figures.h"
#include "lib/analysis/plot_gnuplot.h"
#include "lib/analysis/plot_recording.h"
#include "lib/check/result.h"
#include "lib/record/file_descriptor.h"
#include "lib/record/log_source.h"
#include "lib/record/text_file.h"

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

/// The state of the command while it runs.
class PlotCommand {
 public:
  PlotCommand(const PlotOptions& options, std::ostream& out, std::ostream& err)
      : options_(options), out_(out), err_(err) {}

  int Run() {
    for (const auto& step :
         {&PlotCommand::FindGnuplot, &PlotCommand::ChooseFolder, &PlotCommand::ReadMission,
          &PlotCommand::ReadLog, &PlotCommand::Draw}) {
      if (const int code = (this->*step)(); code != kExitOk) return code;
    }
    return is_whole_ ? kExitOk : kExitEnvironment;
  }

 private:
  int Fail(int code, const std::string& why) {
    err_ << "shoal: " << why << '\n';
    return code;
  }

  int FindGnuplot() {
    gnuplot_ = FindExecutable("gnuplot", options_.search_path);
    if (!gnuplot_.empty()) return kExitOk;
    return Fail(kExitEnvironment,
                "gnuplot is missing, which draws the figures. This installs it:\n"
                "  sudo apt-get install --no-install-recommends gnuplot-nox");
  }

  int ChooseFolder() {
    out_dir_ = options_.out_dir.empty() ? fs::path(options_.log).parent_path() / "plots"
                                        : fs::path(options_.out_dir);
    std::error_code ignored;
    if (options_.out_dir.empty() && fs::is_symlink(out_dir_, ignored)) {
      return Fail(kExitUsage, fmt::format("{} is a symbolic link, which could lead anywhere; name "
                                          "the folder of the figures: --out DIR",
                                          out_dir_.string()));
    }
    if (options_.keep && fs::exists(fs::symlink_status(out_dir_ / "gnuplot", ignored))) {
      return Fail(kExitUsage,
                  fmt::format("{} is there already and may hold scripts that you have changed; "
                              "rename it, remove it, or name another folder: --out DIR",
                              (out_dir_ / "gnuplot").string()));
    }
    return kExitOk;
  }

  int ReadMission() {
    PlotMission mission = options_.mission_file.empty()
                              ? MissionBesideLog(options_.log)
                              : MissionFromFile(options_.mission_file, options_.overrides);
    for (const std::string& error : mission.errors) err_ << error << '\n';
    if (!mission.errors.empty() && !options_.mission_file.empty()) return kExitUsage;
    if (!mission.errors.empty()) {
      err_ << "shoal: warning: the figures are drawn without their mission; name a mission file "
              "that loads: --mission FILE\n";
    }
    if (mission.setting) setting_ = std::move(*mission.setting);
    if (!mission.setting) setting_.title = fs::path(options_.log).stem().string();
    return kExitOk;
  }

  int ReadLog() {
    std::optional<LogReader> reader = OpenLog(options_.log, OnDamage::kSkip, err_);
    if (!reader) return kExitEnvironment;
    PlotDataBuilder builder({options_.vehicles, options_.from_s, options_.to_s}, setting_);
    while (const auto event = reader->Next()) builder.Add(*event);
    is_whole_ = ReportDamage(*reader, err_) && reader->num_damages() == 0;
    data_ = builder.Build();
    const auto warn = [&](int64_t count, const char* what) {
      if (count > 0) err_ << fmt::format("shoal: warning: {}: {} {}\n", options_.log, count, what);
    };
    warn(data_.num_undecodable, "messages do not decode; left out");
    warn(data_.num_impossible, "values or times that no figure can show; left out");
    warn(data_.has_too_many ? static_cast<int64_t>(kMostPlotted) : 0,
         "vehicles are drawn, the rest is left out; choose some: --vehicle NAME");
    const int code = CheckVehicles();
    return code == kExitOk ? CheckTimes() : code;
  }

  /// Refuses a part of the log in which there is nothing: every figure would be left out, each with
  /// a reason that is not the true one.
  int CheckTimes() {
    if (data_.has_selected_times || !data_.log_span_s) return kExitOk;
    const auto [first_s, last_s] = *data_.log_span_s;
    const auto bound = [](const char* option, const std::optional<double>& limit_s) {
      return limit_s ? fmt::format(" {} {:g}", option, *limit_s) : std::string();
    };
    return Fail(kExitUsage,
                fmt::format("{} has nothing in the part{}{}: it has messages of vehicles from "
                            "{:.1f} s to {:.1f} s",
                            options_.log, bound("--from", options_.from_s),
                            bound("--to", options_.to_s), first_s, last_s));
  }

  int CheckVehicles() {
    std::vector<std::string> seen;
    for (const std::string& name : data_.seen) {
      if (seen.size() == 20) break;
      seen.push_back(ShownText(name));
    }
    const std::string there =
        fmt::format("{}{}", fmt::join(seen, ", "), data_.seen.size() > seen.size() ? ", ..." : "");
    for (const std::string& name : options_.vehicles) {
      if (data_.seen.contains(UpperCase(name))) continue;
      return Fail(kExitUsage, fmt::format("{} has no vehicle '{}'; there are: {}", options_.log,
                                          name, seen.empty() ? "none" : there));
    }
    return kExitOk;
  }

  int Draw() {
    const std::vector<Figure> figures = DrawFigures(data_, setting_, options_.png);
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

  const PlotOptions& options_;
  std::ostream& out_;
  std::ostream& err_;
  std::string gnuplot_;
  fs::path out_dir_;
  PlotSetting setting_;
  PlotData data_;
  bool is_whole_ = true;
};

}  // namespace

int RunPlot(const PlotOptions& options, std::ostream& out, std::ostream& err) {
  return PlotCommand(options, out, err).Run();
}

}  // namespace shoal
