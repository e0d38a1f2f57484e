#include "lib/tools/view/recorded_cursor.h"

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"

namespace shoal {

namespace {
/// Standing messages are far apart in the log, and mostly smaller than this.
constexpr size_t kStandingBuffer_bytes = 1024;
}  // namespace

SceneCursor::SceneCursor(LogReader reader, LogStamps stamps, const Keyframe& keyframe,
                         const Scene& blank)
    : walk_(std::move(reader), stamps, keyframe),
      scene_(blank),
      line_us_(keyframe.timeline.now_us()) {
  LogReader standing = walk_.reader().Another(kStandingBuffer_bytes);
  for (const StandingMessage& message : keyframe.standing) {
    standing.Seek(message.offset);
    const auto event = standing.Next();
    if (!event) continue;  // the file became shorter
    scene_.SetNow(message.scene_utime);
    scene_.Handle(event->channel, Unseal(event->data).message);
  }
  scene_.SetNow(keyframe.scene_utime);
  scene_.SetLinks(keyframe.links, keyframe.media_links);
}

void SceneCursor::GoTo(int64_t line_us) {
  walk_.ReadUpTo(line_us, [this](const LogEvent& event) {
    scene_.Handle(event.channel, Unseal(event.data).message);
  });
  line_us_ = line_us;
  scene_.SetNow(walk_.timeline().UtimeOf(line_us));
}

FateCursor::FateCursor(LogReader reader, LogStamps stamps, const Keyframe& keyframe)
    : walk_(std::move(reader), stamps, keyframe),
      fates_(keyframe.num_fates + 1),
      line_us_(keyframe.timeline.now_us()) {
  fates_.MarkSeen(keyframe.kinds_seen, keyframe.causes_seen);
}

void FateCursor::GoTo(int64_t line_us) {
  walk_.ReadUpTo(line_us, [this](const LogEvent& event) {
    if (event.channel == topics::kCommsMedia) return TakeMedia(event);
    if (event.channel != topics::kCommsFates) return;
    if (!ReadFates(Unseal(event.data).message, &message_)) return;
    for (const FateView& fate : message_.all()) fates_.Add(fate);
  });
  line_us_ = line_us;
}

void FateCursor::TakeMedia(const LogEvent& event) {
  if (!Decode(Unseal(event.data).message, &media_)) return;
  FateView medium;
  for (const fate_medium_t& fate : media_.media) {
    if (ViewOf(fate, media_.utime, &medium)) fates_.AddMedium(medium);
  }
}

}  // namespace shoal
