#include "lib/comms/swarm/report_message.h"

#include "lib/base/codec/little_endian.h"
#include "lib/comms/swarm/wire_vector.h"

namespace shoal {

std::vector<uint8_t> EncodeReport(const ReportMessage& report) {
  std::vector<uint8_t> bytes;
  bytes.reserve(kReportBytes);
  for (const char letter : report.flag) AppendLittleEndian(letter, &bytes);
  AppendLittleEndian(report.group_id, &bytes);
  AppendLittleEndian(report.reporter_id, &bytes);
  AppendWireVector(report.position_m, &bytes);
  AppendWireVector(report.velocity_mps, &bytes);
  AppendLittleEndian(report.time_stamp_s, &bytes);
  return bytes;
}

std::optional<ReportMessage> DecodeReport(std::span<const uint8_t> bytes) {
  if (bytes.size() < kReportBytes) return std::nullopt;
  LittleEndianReader reader(bytes);
  ReportMessage report;
  for (char& letter : report.flag) letter = reader.Take<char>();
  report.group_id = reader.Take<uint8_t>();
  report.reporter_id = reader.Take<uint32_t>();
  report.position_m = TakeWireVector(&reader);
  report.velocity_mps = TakeWireVector(&reader);
  report.time_stamp_s = reader.Take<float>();
  return report;
}

}  // namespace shoal
