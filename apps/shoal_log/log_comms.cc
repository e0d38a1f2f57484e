#include "apps/shoal_log/log_comms.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <ostream>
#include <string_view>

#include "lib/base/check/result.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/bus/os/text_file.h"
#include "lib/bus/record/csv_rows.h"
#include "lib/bus/record/log_source.h"
#include "lib/comms/routing/fate.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/run/verdict/acoustic_tally.h"
#include "lib/tools/analysis/comms_links.h"
#include "lib/tools/analysis/information_age.h"
#include "lib/tools/analysis/media_tally.h"
#include "lib/tools/analysis/swarm_tally.h"

namespace shoal {

namespace {

/// Of more links, pairs or contacts than this, only those that matter most are shown.
constexpr size_t kMaxShown = 50;

/// The state of the command while it runs.
class CommsSummary {
 public:
  CommsSummary(const LogCommsOptions& options, std::ostream& out, std::ostream& err)
      : options_(options), out_(out), err_(err) {}

  int Run() {
    for (const auto& step : {&CommsSummary::OpenFolder, &CommsSummary::ReadLog,
                             &CommsSummary::Print, &CommsSummary::WriteTables}) {
      if (const int code = (this->*step)(); code != kExitOk) return code;
    }
    return is_whole_ ? kExitOk : kExitEnvironment;
  }

 private:
  int Fail(int code, const std::string& why) {
    err_ << "shoal: " << why << '\n';
    return code;
  }
  void Warn(int64_t count, std::string_view what) {
    if (count > 0) err_ << fmt::format("shoal: warning: {}: {} {}\n", options_.path, count, what);
  }

  std::string PathOf(const char* name) const {
    return (std::filesystem::path(options_.csv_dir) / name).string();
  }

  int CannotWrite(const std::string& path) {
    return Fail(kExitEnvironment, fmt::format("cannot write {}: is it a folder of yours, and is "
                                              "there room? name another: --csv DIR",
                                              path));
  }

  int OpenFolder() {
    if (options_.csv_dir.empty()) return kExitOk;
    std::error_code ignored;
    std::filesystem::create_directories(options_.csv_dir, ignored);
    if (!std::filesystem::is_directory(options_.csv_dir, ignored)) {
      return CannotWrite(options_.csv_dir);
    }
    return kExitOk;
  }

  void WriteAge(const AgePoint& point) {
    if (options_.csv_dir.empty()) return;
    if (!ages_csv_) {
      ages_csv_.emplace(PathOf("age_over_time.csv"), "time_s,vehicle,contact,is_target,age_s\n");
    }
    // The last Flush() returns the error.
    (void)ages_csv_->Append([&point](std::string* rows) {
      *rows += fmt::format("{:.6f},", Seconds(point.utime));
      AppendCsvCell(point.vehicle, rows);
      *rows += ',';
      AppendCsvCell(point.contact, rows);
      *rows += fmt::format(",{},{:.6f}\n", point.is_target ? 1 : 0, point.age_s);
    });
  }

  template <class T, class Use>
  void Take(const LogEvent& event, Use use) {
    T message{};
    if (!Decode(Unseal(event.data).message, &message)) {
      ++num_undecodable_;
      return;
    }
    ++num_messages_;
    use(message);
  }

  void TakeFate(const fate_t& fate) {
    links_.Add(fate);
    if (fate.kind == KindText(Kind::kPacket)) {
      acoustic_.AddFate(VehicleKey(fate.source), fate.number);
    }
    for (const acoustic_path_t& path : fate.path) {
      acoustic_.Add({.cause = fate.cause,
                     .bits_flipped = path.bits_flipped,
                     .num_colliders = path.num_colliders});
    }
  }

  int ReadLog() {
    const OnDamage on_damage = options_.skip_damage ? OnDamage::kSkip : OnDamage::kStop;
    std::optional<LogReader> reader = OpenLog(options_.path, on_damage, err_);
    if (!reader) return kExitEnvironment;
    const std::string fates_channel = channels::CommsFates().name;
    const std::string media_channel = channels::CommsMedia().name;
    const std::string tx_channel = channels::AcousticTx().name;
    const std::string tx_on_channel = channels::AcousticTxOn().name;
    const std::string modem_channel = channels::ModemTx().name;
    while (const auto event = reader->Next()) {
      if (event->channel == fates_channel) {
        Take<comms_fates_t>(*event, [&](const comms_fates_t& fates) {
          for (const fate_t& fate : fates.fates) TakeFate(fate);
        });
      } else if (event->channel == tx_channel) {
        Take<acoustic_tx_t>(*event, [&](const acoustic_tx_t& packet) {
          acoustic_.AddSent(VehicleKey(packet.source));
        });
      } else if (event->channel == tx_on_channel) {
        Take<acoustic_tx_on_t>(*event, [&](const acoustic_tx_on_t& packet) {
          acoustic_.AddSent(VehicleKey(packet.source));
        });
      } else if (event->channel == modem_channel) {
        Take<modem_tx_t>(*event, [&](const modem_tx_t& packet) {
          acoustic_.AddSent(VehicleKey(packet.source));
        });
      } else if (event->channel == media_channel) {
        Take<comms_media_t>(*event, [&](const comms_media_t& media) {
          for (const fate_medium_t& fate : media.media) media_.Add(fate);
        });
      } else if (!VehicleOfChannel(event->channel, topics::kSwarm).empty()) {
        Take<swarm_t>(*event, [&](const swarm_t& swarm) {
          tally_.Add(swarm);
          ages_.Add(swarm);
        });
      }
    }
    is_whole_ = ReportDamage(*reader, err_);
    Warn(num_undecodable_, "messages do not decode; left out");
    Warn(links_.num_impossible(), "delays that no packet has; left out");
    Warn(tally_.num_impossible(), "messages of SWARM_* whose counts cannot be; left out");
    Warn(ages_.num_impossible(), "reports or messages of SWARM_* out of time; left out");
    Warn(ages_.num_future(), "reports with a time stamp in the future: their age begins with 0");
    if (num_messages_ > 0 || !is_whole_) return kExitOk;
    return Fail(kExitUsage,
                fmt::format("{}: holds neither {} nor SWARM_*: the log of a mission is needed, or "
                            "of the shore's port",
                            options_.path, fates_channel));
  }

  int Print() {
    const size_t most = options_.all ? SIZE_MAX : kMaxShown;
    out_ << links_.Text(most) << media_.Text();
    if (!acoustic_.IsEmpty()) out_ << acoustic_.Text() << '\n';
    out_ << tally_.Text(most) << ages_.Text(most);
    return kExitOk;
  }

  int Finish(TextFile& file) {
    if (!file.Flush()) return CannotWrite(file.path());
    out_ << file.path() << '\n';
    return kExitOk;
  }

  int WriteTables() {
    if (options_.csv_dir.empty()) return kExitOk;
    struct Table {
      const char* name;
      std::string text;
    };
    std::vector<Table> tables;
    if (!links_.links().empty()) {
      tables.push_back({"links.csv", links_.LinksCsv()});
      tables.push_back({"losses.csv", links_.LossesCsv()});
    }
    if (!media_.outcomes().empty()) tables.push_back({"media.csv", media_.Csv()});
    if (!acoustic_.IsEmpty()) tables.push_back({"acoustic.csv", acoustic_.Csv()});
    if (!tally_.Sources().empty()) {
      tables.push_back({"swarm_sources.csv", tally_.SourcesCsv()});
      tables.push_back({"swarm_events.csv", tally_.EventsCsv()});
    }
    if (ages_csv_) tables.push_back({"age.csv", ages_.Csv()});
    for (const Table& table : tables) {
      TextFile file(PathOf(table.name), table.text);
      if (const int code = Finish(file); code != kExitOk) return code;
    }
    return ages_csv_ ? Finish(*ages_csv_) : kExitOk;
  }

  const LogCommsOptions& options_;
  std::ostream& out_;
  std::ostream& err_;
  LinkStatistics links_;
  MediaTally media_;
  AcousticTally acoustic_;
  SwarmTally tally_;
  InformationAge ages_{[this](const AgePoint& point) { WriteAge(point); }};
  std::optional<TextFile> ages_csv_;
  int64_t num_messages_ = 0;
  int64_t num_undecodable_ = 0;
  bool is_whole_ = true;
};

}  // namespace

int LogComms(const LogCommsOptions& options, std::ostream& out, std::ostream& err) {
  return CommsSummary(options, out, err).Run();
}

}  // namespace shoal
