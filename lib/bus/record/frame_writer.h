// Writes the frames of a compressed log (frame_table.h) on a thread of its own.
//
//   FrameWriter writer(std::move(file));
//   writer.Add(&bytes, num_events);   // one frame
//   if (!writer.Close()) return Fail(writer.error_number());
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "lib/bus/os/file_descriptor.h"

namespace shoal {

class FrameWriter {
 public:
  /// Takes an empty file that is open for writing.
  explicit FrameWriter(FileDescriptor file);
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;
  /// Writes the frames that were added; without Close(), the list of frames is missing.
  ~FrameWriter();

  /// Takes a frame and leaves `bytes` empty, with the memory of an earlier frame. Waits while
  /// kMaxWaiting frames are not compressed yet. Returns false, and drops the frame, if an earlier
  /// one could not be written.
  bool Add(std::vector<uint8_t>* bytes, int64_t num_events);

  /// Waits until all frames are written, writes the list of frames and closes the file; the last
  /// call. Returns false if anything failed.
  bool Close();

  /// The errno of the first write that failed; 0: none. The file has the frames before it.
  int error_number() const;

  struct Dropped {
    int64_t events = 0;
    int64_t bytes = 0;
  };
  /// Returns what the frames held that were dropped after an error.
  Dropped dropped() const;

 private:
  struct Waiting {
    std::vector<uint8_t> bytes;
    int64_t num_events = 0;
  };

  static constexpr size_t kMaxWaiting = 4;

  void Work();
  bool Write(std::span<const uint8_t> compressed, size_t size);
  void Drop(int64_t num_events, size_t num_bytes);
  void End();

  FileDescriptor file_;
  std::vector<uint8_t> compressed_;                     ///< Of the thread: room for a frame.
  std::vector<std::pair<uint32_t, uint32_t>> written_;  ///< Of the thread: sizes in file and log.
  uint64_t file_size_ = 0;                              ///< Of the thread.

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Waiting> waiting_;
  std::vector<std::vector<uint8_t>> spare_;  ///< Empty: the memory of frames that were written.
  bool is_over_ = false;
  int error_number_ = 0;
  Dropped dropped_;
  std::thread thread_;  ///< The last member: it begins when the others are there.
};

}  // namespace shoal
