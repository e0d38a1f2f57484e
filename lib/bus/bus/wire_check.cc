#include "lib/bus/bus/wire_check.h"

#include <string>

#include "lcmtypes/lcm_sources.h"
#include "lib/base/check/check.h"
#include "lib/base/schema/walk.h"

namespace shoal {

namespace {

const Schema& CompiledSchema() {
  static const Schema schema = [] {
    std::vector<LcmSource> sources;
    for (const std::string_view text : LcmSources())
      sources.push_back({"lcmtypes", std::string(text)});
    Result<Schema> built = Schema::Build(sources);
    SHOAL_CHECK(built.ok(), "lib/base/schema reads all of shoal's types");
    return std::move(*built);
  }();
  return schema;
}

}  // namespace

bool WireLengthsAreSane(int64_t fingerprint, std::span<const uint8_t> data) {
  const Schema& schema = CompiledSchema();
  const StructType* type = schema.FindByFingerprint(fingerprint);
  return type != nullptr && !FindWireFault(schema, *type, data);
}

}  // namespace shoal
