#include "lib/swarm/report_message.h"

#include "lib/codec/little_endian.h"

namespace shoal {

namespace {

void AppendVector(const Eigen::Vector3f& vector, std::vector<uint8_t>* bytes) {
  for (const float number : vector) AppendLittleEndian(number, bytes);
}

Eigen::Vector3f TakeVector(LittleEndianReader* reader) {
  Eigen::Vector3f vector;
  for (float& number : vector) number = reader->Take<float>();
  return vector;
}

}  // namespace

std::vector<uint8_t> EncodeReport(const ReportMessage& report) {
  std::vector<uint8_t> bytes;
  bytes.reserve(kReportBytes);
  for (const char letter : report.flag) AppendLittleEndian(letter, &bytes);
  AppendLittleEndian(report.group_id, &bytes);
  AppendLittleEndian(report.reporter_id, &bytes);
  AppendVector(report.position_m, &bytes);
  AppendVector(report.velocity_mps, &bytes);
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
  report.position_m = TakeVector(&reader);
  report.velocity_mps = TakeVector(&reader);
  report.time_stamp_s = reader.Take<float>();
  return report;
}

}  // namespace shoal
