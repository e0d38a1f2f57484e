#include "lib/sea/modem/micromodem.h"

#include <algorithm>
#include <utility>

namespace shoal {

MicroModem::MicroModem(const MicroModemOptions& options)
    : unit_(options),
      air_(unit_),
      cycle_(unit_, air_),
      receiver_(unit_, air_),
      host_(unit_, air_, cycle_, receiver_) {}

MicroModemOutput MicroModem::Take(std::string_view line, int64_t now_us) {
  CatchUp(now_us);
  host_.TakeLine(line);
  return TakeOutput();
}

MicroModemOutput MicroModem::TakeBytes(std::string_view bytes, int64_t now_us) {
  CatchUp(now_us);
  host_.TakeBytes(bytes);
  return TakeOutput();
}

MicroModemOutput MicroModem::Receive(const MicroModemArrival& arrival, int64_t now_us) {
  CatchUp(now_us);
  receiver_.Receive(arrival);
  return TakeOutput();
}

MicroModemOutput MicroModem::Advance(int64_t now_us) {
  CatchUp(now_us);
  return TakeOutput();
}

MicroModemOutput MicroModem::Transmit(int64_t now_us) {
  CatchUp(now_us);
  air_.StartNext();
  return TakeOutput();
}

std::optional<int64_t> MicroModem::NextEvent_us() const {
  std::optional<int64_t> next_us;
  for (const std::optional<int64_t>& time_us : {air_.NextEvent_us(), cycle_.NextEvent_us(),
                                                receiver_.NextEvent_us(), host_.NextEvent_us()}) {
    if (time_us) next_us = std::min(next_us.value_or(*time_us), *time_us);
  }
  return next_us;
}

void MicroModem::CatchUp(int64_t now_us) {
  for (auto next_us = NextEvent_us(); next_us && *next_us <= now_us; next_us = NextEvent_us()) {
    unit_.now_us = std::max(unit_.now_us, *next_us);
    if (air_.EndWhatIsOver()) cycle_.OnTransmissionEnded();
    host_.OnTime();
    receiver_.OnTime();
    cycle_.OnTime();
  }
  unit_.now_us = std::max(unit_.now_us, now_us);
}

MicroModemOutput MicroModem::TakeOutput() { return std::exchange(unit_.output, {}); }

}  // namespace shoal
