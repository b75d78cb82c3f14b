#include "core/protocol/link/secret.h"

#include <cstdlib>

#include <sodium/core.h>
#include <sodium/randombytes.h>

namespace fyd::protocol {

void systemRandom(std::span<std::uint8_t> out) { randombytes_buf(out.data(), out.size()); }

void prepareCryptography() {
  if (sodium_init() < 0) std::abort();
}

}  // namespace fyd::protocol
