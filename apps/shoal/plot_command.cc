#include "apps/shoal/plot_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <utility>

#include "lib/analysis/plot_figures.h"
#include "lib/analysis/plot_gnuplot.h"
#include "lib/analysis/plot_recording.h"
#include "lib/check/result.h"
#include "lib/record/file_descriptor.h"
#include "lib/record/log_source.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

bool WriteFile(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  return out.good();
}

/// The folder of data and scripts while gnuplot runs; --keep keeps it.
class ScriptFolder {
 public:
  ScriptFolder() = default;
  ~ScriptFolder() {
    std::error_code ignored;
    if (!path_.empty() && !is_kept_) fs::remove_all(path_, ignored);
  }
  ScriptFolder(const ScriptFolder&) = delete;
  ScriptFolder& operator=(const ScriptFolder&) = delete;

  /// Returns whether it could be made; errno holds the reason where not.
  bool Make(const fs::path& out_dir, bool keep) {
    is_kept_ = keep;
    if (keep) {
      std::error_code error;
      fs::create_directory(out_dir / "gnuplot", error);
      if (error) errno = error.value();
      path_ = out_dir / "gnuplot";
      return !error;
    }
    std::string name = (out_dir / ".gnuplot-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) return false;
    path_ = name;
    return true;
  }

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  bool is_kept_ = false;
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
    if (options_.keep && fs::exists(out_dir_ / "gnuplot", ignored)) {
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
    return CheckVehicles();
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
    ScriptFolder folder;
    if (!folder.Make(out_dir_, options_.keep)) {
      return Fail(kExitEnvironment, fmt::format("cannot write into {}: {}; name another: --out DIR",
                                                out_dir_.string(), ErrnoText(errno)));
    }
    for (const Figure& figure : figures) {
      if (!figure.why_left_out.empty()) {
        out_ << fmt::format("{} is left out: {}\n", figure.name, figure.why_left_out);
        continue;
      }
      if (!WriteFile(folder.path() / (figure.name + ".dat"), figure.data) ||
          !WriteFile(folder.path() / (figure.name + ".gp"), figure.script)) {
        return Fail(kExitEnvironment,
                    fmt::format("cannot write into {}: is the disk full?", folder.path().string()));
      }
      const auto drawn = RunGnuplot(gnuplot_, folder.path().string(), figure.name + ".gp");
      if (!drawn.ok()) return Fail(kExitEnvironment, drawn.error());
      const fs::path file = out_dir_ / (figure.name + (options_.png ? ".png" : ".svg"));
      out_ << file.string() << '\n';
    }
    if (options_.keep) {
      out_ << fmt::format("data and scripts: {}\n", folder.path().string());
    }
    return kExitOk;
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
