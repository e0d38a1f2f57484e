#include "apps/shoal_plot/plot_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <ostream>
#include <utility>

#include "lib/base/check/result.h"
#include "lib/base/text/letters.h"
#include "lib/bus/record/log_source.h"
#include "lib/tools/plot/drawing_folder.h"
#include "lib/tools/plot/plot_figures.h"
#include "lib/tools/plot/plot_recording.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// The state of the command while it runs.
class PlotCommand {
 public:
  PlotCommand(const PlotOptions& options, std::ostream& out, std::ostream& err)
      : options_(options), out_(out), err_(err) {}

  int Run() {
    for (const auto& step :
         {&PlotCommand::FindProgram, &PlotCommand::ChooseFolder, &PlotCommand::ReadMission,
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

  int FindProgram() {
    gnuplot_ = FindGnuplot(options_.search_path, err_);
    return gnuplot_.empty() ? kExitEnvironment : kExitOk;
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
    warn(data_.has_too_many ? static_cast<int64_t>(kMaxPlotted) : 0,
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
    return DrawInto({.out_dir = out_dir_, .png = options_.png, .keep = options_.keep}, gnuplot_,
                    DrawFigures(data_, setting_, options_.png), out_, err_);
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
