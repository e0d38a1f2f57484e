#include "lib/base/random/philox.h"

#include <Random123/philox.h>

namespace shoal {

PhiloxCounter Philox4x32(const PhiloxCounter& counter, const PhiloxKey& key) {
  const r123::Philox4x32 permute;  // Ten rounds.
  const r123::Philox4x32::ctr_type bits =
      permute({{counter[0], counter[1], counter[2], counter[3]}}, {{key[0], key[1]}});
  return {bits[0], bits[1], bits[2], bits[3]};
}

}  // namespace shoal
