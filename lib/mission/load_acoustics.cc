#include "lib/mission/load_acoustics.h"

#include <optional>

#include "lib/mission/describe.h"
#include "lib/mission/parse.h"
#include "lib/mission/problems.h"
#include "lib/mission/table_reader.h"
#include "lib/mission/table_writer.h"
#include "lib/mission/validate.h"

namespace shoal {
namespace {

void DescribeAlone(Fields& file, Acoustics& acoustics) {
  if (file.Has("is_used", !acoustics.is_used)) file.Flag("is_used", acoustics.is_used);
  file.Require("acoustics", "[acoustics], followed by crc = true");
  file.Below("acoustics", [&](Fields& fields) { Describe(fields, acoustics, std::nullopt); });
}

}  // namespace

std::string ExplainAcoustics(const Acoustics& acoustics) {
  TableWriter writer;
  Acoustics copy = acoustics;
  DescribeAlone(writer, copy);
  std::string text = writer.TakeText();
  text.erase(0, text.find_first_not_of('\n'));
  return text;
}

LoadedAcoustics LoadAcousticsText(std::string_view text, const std::string& name) {
  LoadedAcoustics loaded;
  loaded.acoustics.is_used = true;
  Problems problems(name, {});
  if (const std::optional<Value> root = ParseToml(text, problems)) {
    TableReader file(*root, "the text", problems);
    DescribeAlone(file, loaded.acoustics);
    const TablePlace place = TablePlace(*root, problems).Below("acoustics");
    if (place.IsSound()) ValidateNetwork(place, loaded.acoustics.options, AnyNode());
  }
  loaded.errors = problems.InOrder();
  return loaded;
}

std::vector<AcousticNode> AnyNode() { return {{.name = "any", .address = 1, .is_leader = true}}; }

}  // namespace shoal
