// The tables [[medium]] and [vehicle.gateway], and which media a kind of traffic or a vehicle has.
#include <limits>
#include <string>

#include "lib/mission/file/describe.h"

namespace shoal {
namespace {

constexpr size_t kMaxMedia = 16;

void Describe(Fields& fields, RadioOptions& radio) {
  fields.NumberOrWord("range_m", radio.range_m, kFarthest_m, "nolimit", -1);
  fields.Number("surface_depth_m", radio.surface_depth_m, Between(0, 100));
  fields.Number("antenna_height_m", radio.antenna_height_m, Between(0, 1000));
  fields.Flag("horizon", radio.horizon);
  fields.Choice("path_loss", radio.path_loss, kPathLossModels);
  fields.Number("frequency_mhz", radio.frequency_mhz, Between(0.01, 1e6));
  fields.Number("power_dbm", radio.power_dbm, Between(-100, 100));
  fields.Number("sensitivity_dbm", radio.sensitivity_dbm, Between(-250, 100));
  fields.Number("exponent", radio.exponent, Between(1, 10));
  fields.Number("rate_bps", radio.rate_bps, Between(0, 1e12));
  fields.Number("latency_s", radio.latency_s, Between(0, 86'400));
  fields.Number("jitter_s", radio.jitter_s, Between(0, 86'400));
  fields.Number("loss", radio.loss, Between(0, 1));
}

void Describe(Fields& fields, GatewayOptions& gateway) {
  fields.Require("from", "from = [\"acoustic\"]");
  fields.Texts("from", gateway.from, kMaxMedia);
  fields.Require("to", "to = [\"radio\"]");
  fields.Texts("to", gateway.to, kMaxMedia);
  fields.Flag("reports", gateway.reports);
  fields.Flag("messages", gateway.messages);
  fields.Integer("queue", gateway.queue, 1, 100'000);
  fields.Number("rate_hz", gateway.rate_hz, Above(0, 1000));
  fields.Integer("max_hops", gateway.max_hops, 1, 16);
}

}  // namespace

void Describe(Fields& fields, MediumOptions& medium, const std::optional<std::string>& folder) {
  fields.Text("name", medium.name, {.min_length = 1, .max_length = 32});
  fields.Require("name", "name = \"vhf\"");
  fields.Choice("kind", medium.kind, kMediumKinds);
  fields.Require("kind", "kind = \"radio\"");
  if (medium.kind == MediumKind::kRadio) return Describe(fields, medium.radio);
  medium.acoustics.is_used = true;
  Describe(fields, medium.acoustics, folder);
}

void DescribeMedia(Fields& fields, std::string_view key, MediaChoice& choice) {
  if (fields.reading() && !fields.Has(key, true)) {
    fields.Skip(key);
    return;
  }
  const bool is_text =
      fields.reading() ? fields.HoldsText(key) : choice.at_once || choice.names.size() == 1;
  if (is_text) {
    std::string text = TextOf(choice);
    fields.Text(key, text, {.min_length = 1, .max_length = 500});
    choice = Over(text);
    return;
  }
  fields.Texts(key, choice.names, kMaxMedia);
  choice.at_once = false;
  if (fields.reading() && choice.names.empty()) {
    fields.Refuse(key, std::string(key) + " names no medium; write \"direct\"");
    choice = {};
  }
}

void Describe(Fields& fields, VehicleMedia& media) {
  if (fields.Has("media", !media.names.empty())) {
    fields.Texts("media", media.names, kMaxMedia);
  }
  if (fields.Has("antenna_height_m", media.antenna_height_m >= 0)) {
    fields.Number("antenna_height_m", media.antenna_height_m, Between(0, 1000));
  }
  if (fields.Has("gateway", media.gateway.exists)) {
    media.gateway.exists = true;
    fields.Below("gateway", [&](Fields& table) { Describe(table, media.gateway); });
  }
}

}  // namespace shoal
