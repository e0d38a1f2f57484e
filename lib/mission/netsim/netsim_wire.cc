#include "lib/mission/netsim/netsim_wire.h"

#include <fmt/format.h>
#include <netsim.pb.h>

#include "lib/base/codec/base64.h"

namespace shoal {

namespace {

constexpr std::string_view kPreamble = "NETSIM|";
constexpr std::string_view kRequestName = "netsim.protobuf.NetSimManagerRequest";
constexpr std::string_view kResponseName = "netsim.protobuf.NetSimManagerResponse";

NetsimNav NavOf(const netsim::protobuf::NavUpdate& update) {
  NetsimNav nav;
  if (update.has_modem_tcp_port()) nav.modem_tcp_port = update.modem_tcp_port();
  if (update.has_time()) nav.time_s = update.time();
  if (update.has_lat()) nav.lat_deg = update.lat();
  if (update.has_lon()) nav.lon_deg = update.lon();
  if (update.has_depth()) nav.depth_m = update.depth();
  if (update.has_speed()) nav.speed_mps = update.speed();
  if (update.has_heading()) nav.heading_deg = update.heading();
  return nav;
}

NetsimReceiveStats StatsOf(const netsim::protobuf::ReceiveStats& given) {
  NetsimReceiveStats stats;
  stats.modem_tcp_port = given.modem_tcp_port();
  stats.tx_modem_tcp_port = given.tx_modem_tcp_port();
  stats.packet_success = given.packet_success();
  if (!given.has_mm_stats()) return stats;
  const netsim::protobuf::ModemStatistics& modem = given.mm_stats();
  stats.modem = NetsimModemStats{.mode = modem.mode(),
                                 .rate = modem.rate(),
                                 .source = modem.source(),
                                 .destination = modem.dest(),
                                 .num_frames = modem.number_frames(),
                                 .num_bad_frames = modem.number_bad_frames(),
                                 .snr_in_db = modem.snr_in(),
                                 .snr_out_db = modem.snr_out(),
                                 .mse_equalizer_db = modem.mse_equalizer()};
  return stats;
}

NetsimRequest RequestOf(const netsim::protobuf::NetSimManagerRequest& message) {
  NetsimRequest request;
  request.id = message.id();
  request.navs.reserve(static_cast<size_t>(message.nav_size()));
  for (const auto& update : message.nav()) request.navs.push_back(NavOf(update));
  for (const auto& stats : message.stats()) request.stats.push_back(StatsOf(stats));
  request.is_whole = message.IsInitialized();
  return request;
}

}  // namespace

std::variant<NetsimRequest, NotARequest> ParseRequestLine(std::string_view line) {
  if (line.empty()) return NotARequest::kBlank;
  if (!line.starts_with(kPreamble)) return NotARequest::kNoMessage;
  line.remove_prefix(kPreamble.size());
  const size_t pipe = line.find('|');
  if (pipe == line.npos) return NotARequest::kNoMessage;
  if (line.substr(0, pipe) != kRequestName) return NotARequest::kUnknownMessage;

  const auto bytes = DecodeBase64(line.substr(pipe + 1));
  if (!bytes) return NotARequest::kBadBase64;
  netsim::protobuf::NetSimManagerRequest message;
  if (!message.ParsePartialFromArray(bytes->data(), static_cast<int>(bytes->size()))) {
    return NotARequest::kBadProtobuf;
  }
  if (!message.has_id()) return NotARequest::kNoId;
  return RequestOf(message);
}

std::string ResponseLine(int32_t id, NetsimStatus status) {
  using Response = netsim::protobuf::NetSimManagerResponse;
  Response response;
  response.set_request_id(id);
  response.set_status(static_cast<Response::Status>(status));
  const std::string bytes = response.SerializeAsString();
  return fmt::format("{}{}|{}\n", kPreamble, kResponseName,
                     Base64(std::vector<uint8_t>(bytes.begin(), bytes.end())));
}

}  // namespace shoal
