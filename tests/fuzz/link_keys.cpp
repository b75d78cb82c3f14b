// Key files and pairing codes from any text: an error, or a key that writes itself as what was read.
#include "core/protocol/link/link_keys.h"

#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::protocol;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto check = [](const Result<LinkKey>& key) {
    if (key) fuzz::require(LinkKey::parseWords(key->words())->fingerprint() == key->fingerprint());
  };
  check(LinkKey::parseWords(text));
  check(LinkKey::parseFile(text, "input"));
  return 0;
}
