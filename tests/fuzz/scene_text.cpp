// A scene file of any content: refused with a reason that names the file, or a description within its ranges.
#include <string>

#include "core/scene/scene_description.h"
#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::scene;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto scene = parseScene({reinterpret_cast<const char*>(data), size}, "s.toml");
  if (!scene) {
    fuzz::require(scene.error().text().starts_with("s.toml"));
    return 0;
  }
  for (BodyDescription& body : scene->bodies) {
    fuzz::require(!body.mesh.empty());
    for (const Parameter& each : bindParameters(body)) fuzz::require(insideRange(each));
  }
  return 0;
}
