// Bytes from a peer that need not be a MOOSDB's or a client's: the reader of packets, a session
// that takes them for answers, and a database that takes them for a client's.
//
// An input is one byte, the size of the pieces (0: as many as there are), then the bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/check.h"
#include "lib/comms/moos_wire/moos_database.h"
#include "lib/comms/moos_wire/moos_packet.h"
#include "lib/comms/moos_wire/moos_session.h"

namespace shoal {
namespace {

/// Packets are written again as they were read.
void CheckReader(std::string_view bytes, size_t piece_size) {
  MoosPacketReader reader;
  std::string again;
  std::string_view left = bytes;
  while (!left.empty()) {
    reader.Take(left.substr(0, piece_size), [&](std::span<const MoosMessage> messages) {
      if (messages.empty()) {
        again += std::string("\x09\0\0\0\0\0\0\0\0", kMinMoosPacketBytes);
      } else {
        AppendMoosPacket(messages, &again);
      }
    });
    left.remove_prefix(std::min(piece_size, left.size()));
  }
  SHOAL_CHECK(bytes.starts_with(again), "what is written again is what was read");
  SHOAL_CHECK(
      !reader.problem().empty() || again.size() + reader.num_pending_bytes() == bytes.size(),
      "each byte is read, kept or refused");
}

void CheckSession(std::string_view bytes, size_t piece_size) {
  MoosSession session({.name = "fuzz", .warp = 1, .host = "db"});
  session.Register("X", 0);
  (void)session.Connect(0, 1);
  int64_t wall_us = 0;
  while (!bytes.empty() && session.problem().empty()) {
    session.Take(bytes.substr(0, piece_size), wall_us, wall_us);
    bytes.remove_prefix(std::min(piece_size, bytes.size()));
    wall_us += 500'000;
    (void)session.Flush(wall_us, wall_us);
  }
  SHOAL_CHECK(session.TakeMail().size() <= MoosSession::kMaxWaiting, "mail is bounded");
}

void CheckDatabase(std::string_view bytes, size_t piece_size) {
  MoosDatabase database({.community = "fuzz", .host = "db", .own_name = "own"});
  MoosNow now;
  const auto settle = [&] {
    for (const MoosOutput& each : database.TakeOutput()) {
      if (each.closes) database.OnClose(each.client, now);
    }
  };
  database.OnConnect(1, now);
  database.OnConnect(2, now);
  if (piece_size % 2 == 0) database.OnBytes(1, MoosGreeting(), now);
  while (!bytes.empty()) {
    database.OnBytes(1 + bytes.size() % 2, bytes.substr(0, piece_size), now);
    bytes.remove_prefix(std::min(piece_size, bytes.size()));
    now.wall_us += 100'000;
    now.time_s += 0.1;
    database.Advance(now);
    settle();
  }
  SHOAL_CHECK(database.TakeEvents().size() <= MoosDatabase::kMaxEvents, "events are bounded");
}

}  // namespace
}  // namespace shoal

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size < 2) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const size_t piece_size = data[0] == 0 ? bytes.size() : data[0];
  shoal::CheckReader(bytes, piece_size);
  shoal::CheckSession(bytes, piece_size);
  shoal::CheckDatabase(bytes, piece_size);
  return 0;
}
