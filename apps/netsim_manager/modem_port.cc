#include "apps/netsim_manager/modem_port.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "lib/base/time/seconds.h"

namespace shoal {

namespace {

class RawPort : public ModemPort {
 public:
  explicit RawPort(const ModemPortOptions& options)
      : reader_({.max_bytes = options.max_bytes}),
        water_bps_(options.water_bps),
        more_bytes_(options.more_bytes) {}

  void Receive(const ModemPacket& packet, int64_t) override {
    ++num_heard_;
    const std::vector<uint8_t> piece = EncodeRawPiece(packet.bytes);
    SendToClient({reinterpret_cast<const char*>(piece.data()), piece.size()});
  }

  std::string Text() const override {
    const RawModemCounts& counts = reader_.counts();
    return fmt::format(
        "    raw, {}; {} payloads taken, {} empty, {} too long, {} cut off, {} waiting, {} "
        "dropped; {} received\n",
        ClientText(), counts.delivered, counts.empty, counts.too_long, counts.cut_off,
        waiting_.size(), num_dropped_, num_heard_);
  }

 private:
  // What it had sent is its own: the next client must find a modem that is free.
  void OnClose() override {
    reader_.ForgetPiece();
    num_dropped_ += static_cast<int64_t>(waiting_.size());
    waiting_.clear();
  }
  void OnBytes(std::string_view bytes, int64_t) override {
    const auto* data = reinterpret_cast<const uint8_t*>(bytes.data());
    for (std::vector<uint8_t>& payload : reader_.Take({data, bytes.size()})) {
      if (waiting_.size() < kMaxWaiting) {
        waiting_.push_back(std::move(payload));
      } else {
        ++num_dropped_;
      }
    }
  }

  // One at a time: what left before the one before it was out would collide with it.
  void BeforeStep(int64_t mission_us) override {
    while (!waiting_.empty() && mission_us >= free_us_) {
      const double num_bytes = static_cast<double>(waiting_.front().size() + more_bytes_);
      const double air_s = water_bps_ > 0 ? 8 * num_bytes / water_bps_ : 0;
      free_us_ = mission_us + Microseconds(air_s) + kPacketGap_us;
      Transmit({.bytes = std::move(waiting_.front())});
      waiting_.pop_front();
    }
  }

  RawModemReader reader_;
  double water_bps_;
  size_t more_bytes_;
  std::deque<std::vector<uint8_t>> waiting_;
  int64_t free_us_ = 0;  ///< When the last one has left.
  int64_t num_dropped_ = 0;
  int64_t num_heard_ = 0;
};

class MicroModemPort : public ModemPort {
 public:
  explicit MicroModemPort(const ModemPortOptions& options)
      : version_(options.kind == NetsimModem::kMicromodem2 ? 2 : 1),
        modem_({.address = options.modem_address,
                .version = version_,
                .more_bytes = options.more_bytes}) {}

  void Receive(const ModemPacket& packet, int64_t mission_us) override {
    Pass(modem_.Receive({.bytes = packet.bytes,
                         .start_us = packet.start_us,
                         .travel_us = packet.travel_us,
                         .snr_db = packet.snr_db},
                        mission_us));
  }
  void SetClock(int64_t utc_us, int64_t mission_us) override {
    modem_.SetClock(utc_us, mission_us);
  }

  std::string Text() const override {
    const MicroModemCounts& counts = modem_.counts();
    return fmt::format(
        "    micromodem{} {}, {}{}\n"
        "        host: {} answered, {} refused, {} dropped; water: {} sent, {} understood ({} "
        "frames damaged), {} for others, {} damaged, {} foreign\n",
        version_ == 2 ? "2" : "", modem_.address(), ClientText(),
        modem_.is_on_the_air()   ? ", on the air"
        : modem_.is_in_a_cycle() ? ", in a cycle"
                                 : "",
        counts.sentences_answered, counts.sentences_refused, counts.lines_dropped, counts.sent,
        counts.understood, counts.damaged_frames, counts.overheard, counts.damaged_headers,
        counts.foreign);
  }

 private:
  void OnConnect() override { modem_.ForgetLine(); }
  void OnBytes(std::string_view bytes, int64_t mission_us) override {
    // What a byte is answered with may be two hundred times as long.
    constexpr size_t kMaxAtOnce = 2048;
    for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), kMaxAtOnce))) {
      Pass(modem_.TakeBytes(bytes.substr(0, kMaxAtOnce), mission_us));
    }
  }
  void Advance(int64_t mission_us) override { Pass(modem_.Advance(mission_us)); }
  // Not in Advance, which comes between steps too: the packet leaves in the step, and its end
  // counts from there.
  void BeforeStep(int64_t mission_us) override { Pass(modem_.Transmit(mission_us)); }

  void Pass(const MicroModemOutput& output) {
    SendToClient(output.to_host);
    for (const MicroModemSent& sent : output.to_water) {
      Transmit({.bytes = sent.bytes, .data_rate_bps = static_cast<double>(sent.bps)});
    }
  }

  int version_;
  MicroModem modem_;
};

}  // namespace

Result<std::unique_ptr<ModemPort>> ModemPort::Open(const ModemPortOptions& options) {
  std::unique_ptr<ModemPort> port;
  if (options.kind != NetsimModem::kRaw) {
    port = std::make_unique<MicroModemPort>(options);
  } else {
    port = std::make_unique<RawPort>(options);
  }
  const Result<bool> listens = port->Listen(options);
  if (!listens.ok()) return Error{listens.error()};
  return port;
}

Result<bool> ModemPort::Listen(const ModemPortOptions& options) {
  auto server = TcpServer::Listen(
      {.address = options.address, .port = options.port, .max_connections = 1},
      {.on_connect =
           [this](ClientId client, const std::string& address) {
             client_ = client;
             client_address_ = address;
             OnConnect();
           },
       .on_bytes = [this](ClientId, std::string_view bytes) { OnBytes(bytes, mission_us_); },
       .on_close =
           [this](ClientId) {
             client_.reset();
             OnClose();
           },
       .on_refuse = options.on_refuse});
  if (!server.ok()) return Error{server.error()};
  server_ = std::move(*server);
  return true;
}

void ModemPort::Serve(int64_t wall_us, int64_t mission_us) {
  mission_us_ = mission_us;
  server_->Serve(wall_us);
  Advance(mission_us);
}

void ModemPort::SendToClient(std::string_view bytes) {
  if (client_ && !bytes.empty()) server_->Send(*client_, bytes);
}

void ModemPort::Transmit(ModemTransmission transmission) {
  if (transmissions_.size() >= kMaxWaiting) {
    ++num_dropped_;
    return;
  }
  ++num_transmissions_;
  transmissions_.push_back(std::move(transmission));
}

std::vector<ModemTransmission> ModemPort::TakeTransmissions(int64_t mission_us) {
  BeforeStep(mission_us);
  return std::exchange(transmissions_, {});
}

std::string ModemPort::ClientText() const {
  const TcpServerCounts& counts = server_->counts();
  return fmt::format("port {}, {}, {} refused, {} stalled; {} packets given to the water{}", port(),
                     client_ ? "client at " + client_address_ : std::string("no client"),
                     counts.refused, counts.stalled, num_transmissions_,
                     num_dropped_ > 0 ? fmt::format(", {} too many", num_dropped_) : "");
}

}  // namespace shoal
