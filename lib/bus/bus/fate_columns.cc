#include "lib/bus/bus/fate_columns.h"

#include <cstddef>

#include "lib/bus/bus/big_endian.h"

namespace shoal {

namespace {

/// Takes the elements of a column one after the other.
template <class T>
class Column {
 public:
  explicit Column(const std::vector<T>& values) : values_(values) {}

  /// Returns nullptr at the end.
  const T* Next() { return next_ < values_.size() ? &values_[next_++] : nullptr; }
  bool is_at_end() const { return next_ == values_.size(); }

 private:
  const std::vector<T>& values_;
  size_t next_ = 0;
};

/// Takes the next of the column where `is_there`; false: there is none.
template <class T>
bool Take(bool is_there, Column<T>* column, T* value) {
  if (!is_there) return true;
  const T* next = column->Next();
  if (next != nullptr) *value = *next;
  return next != nullptr;
}

template <class T>
const T* At(const std::vector<T>& values, int16_t index) {
  return index >= 0 && static_cast<size_t>(index) < values.size()
             ? &values[static_cast<size_t>(index)]
             : nullptr;
}

bool IsColumns(std::span<const uint8_t> data) {
  constexpr size_t kFingerprint_bytes = 8;
  if (data.size() < kFingerprint_bytes) return false;
  return static_cast<int64_t>(ReadBigEndian(data.first(kFingerprint_bytes))) ==
         comms_fate_columns_t::getHash();
}

}  // namespace

bool ListOf(const comms_fate_columns_t& columns, comms_fates_t* list) {
  list->utime = columns.utime;
  list->fates.resize(columns.destination.size());
  list->num_fates = static_cast<int32_t>(list->fates.size());
  const size_t max_text_bytes = kMaxFateTexts_bytes + kMaxTextOfFate_bytes * list->fates.size();
  size_t text_bytes = 0;
  Column ranges(columns.range_m);
  Column waits(columns.wait_s);
  Column counts(columns.count);
  Column paths(columns.path);
  Column senders(columns.senders);
  const fate_sender_t* sender = nullptr;
  int32_t num_left = 0;
  for (size_t i = 0; i < list->fates.size(); ++i) {
    for (; num_left <= 0; num_left = sender->num_fates) {
      sender = senders.Next();
      if (sender == nullptr) return false;
    }
    --num_left;
    const fate_case_t* of = At(columns.cases, columns.which_case[i]);
    const std::string* destination = At(columns.names, columns.destination[i]);
    if (of == nullptr || destination == nullptr) return false;
    text_bytes += sender->kind.size() + sender->source.size() + destination->size() +
                  of->cause.size() + of->override_rule.size();
    if (text_bytes > max_text_bytes) return false;
    fate_t& fate = list->fates[i];
    fate.kind = sender->kind;
    fate.source = sender->source;
    fate.number = sender->number;
    fate.destination = *destination;
    fate.cause = of->cause;
    fate.override_rule = of->override_rule;
    fate.limit_m = of->limit_m;
    fate.age_s = of->age_s;
    fate.age_limit_s = of->age_limit_s;
    fate.loss_pct = of->loss_pct;
    fate.length_bytes = of->length_bytes;
    fate.length_limit_bytes = of->length_limit_bytes;
    fate.range_m = -1;
    fate.wait_s = -1;
    fate.count = 1;
    fate.path.resize(of->has_path != 0 ? 1 : 0);
    fate.num_paths = static_cast<int32_t>(fate.path.size());
    if (!Take(of->has_range != 0, &ranges, &fate.range_m) ||
        !Take(of->has_wait != 0, &waits, &fate.wait_s) ||
        !Take(of->has_count != 0, &counts, &fate.count) ||
        !Take(of->has_path != 0, &paths, fate.path.data())) {
      return false;
    }
  }
  return num_left == 0 && senders.is_at_end() && ranges.is_at_end() && waits.is_at_end() &&
         counts.is_at_end() && paths.is_at_end();
}

template <>
bool Decode(std::span<const uint8_t> data, comms_fates_t* message) {
  if (IsColumns(data)) {
    thread_local comms_fate_columns_t columns;
    columns = {};
    return Decode(data, &columns) && ListOf(columns, message);
  }
  if (!WireLengthsAreSane(comms_fates_t::getHash(), data)) return false;
  try {
    return message->decode(data.data(), 0, static_cast<int>(data.size())) ==
           static_cast<int>(data.size());
  } catch (const std::exception&) {
    return false;
  }
}

std::span<const uint8_t> WithFatesAsList(std::span<const uint8_t> message, Bytes* storage) {
  if (!IsColumns(message)) return message;
  thread_local comms_fates_t list;
  if (!Decode(message, &list)) return message;
  EncodeInto(list, storage);
  return *storage;
}

}  // namespace shoal
