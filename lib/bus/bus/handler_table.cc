#include "lib/bus/bus/handler_table.h"

namespace shoal {

bool HandlerTable::Add(const std::string& channel, Bus::Handler handler) {
  const bool is_new = !Wants(channel);
  by_channel_[channel].push_back(std::move(handler));
  return is_new;
}

void HandlerTable::AddForAll(Bus::Handler handler) { for_all_.push_back(std::move(handler)); }

int64_t HandlerTable::Call(const Message& message) const {
  int64_t num_called = 0;
  const auto found = by_channel_.find(message.channel);
  if (found != by_channel_.end()) {
    for (const Bus::Handler& handler : found->second) {
      ++num_called;
      handler(message);
    }
  }
  for (const Bus::Handler& handler : for_all_) {
    ++num_called;
    handler(message);
  }
  return num_called;
}

}  // namespace shoal
