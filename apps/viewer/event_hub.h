// The newest frame, for all clients of the stream. Nothing is queued: a client that is slow skips
// frames, and delays no other.
//
//   writer:  if (hub.num_readers() > 0) hub.Publish(frame_json);
//   reader:  EventHub::Reader reader(hub);
//            while (auto event = reader.Next(1s)) { if (*event) send(**event); else heartbeat; }
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace shoal {

class EventHub {
 public:
  using Event = std::shared_ptr<const std::string>;

  /// One client. The hub must outlive it.
  class Reader {
   public:
    explicit Reader(EventHub& hub);
    ~Reader();
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// Waits at most `patience` for an event that is newer than the last. Returns it, null where
    /// there is none yet, or nothing where the stream has ended.
    std::optional<Event> Next(std::chrono::milliseconds patience);

   private:
    EventHub& hub_;
    uint64_t stream_;
    uint64_t seen_ = 0;
  };

  /// Makes `json` the newest frame, as an event of text/event-stream.
  void Publish(std::string_view json);

  /// Ends the streams of all readers there are now; one that comes again gets a new stream.
  void EndStreams();
  /// The same, also for later readers.
  void Stop();

  int num_readers() const;

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Event newest_;
  uint64_t sequence_ = 0;  ///< Of newest_.
  uint64_t stream_ = 0;    ///< Counts EndStreams().
  bool stopped_ = false;
  int num_readers_ = 0;
};

}  // namespace shoal
