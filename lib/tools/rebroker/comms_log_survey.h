// What a log shows once its messages are in order: when brokers started, and what is missing.
#pragma once

#include <span>

#include "lib/tools/rebroker/comms_log.h"

namespace shoal {

/// Sets the log's starts, rules and rule changes. @pre its time, inputs and first_utime are known
void FindStarts(std::span<const CommsLogItem> items, CommsLog* log);

/// Sets the log's gaps. A vehicle counts its reports; one whose count begins again has been started
/// again. @pre the log's time is known
void FindGaps(std::span<const CommsLogItem> items, CommsLog* log);

}  // namespace shoal
