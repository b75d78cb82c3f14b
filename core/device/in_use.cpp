#include "core/device/in_use.h"

#include <algorithm>

namespace fyd::device {
namespace {

constexpr std::string_view kPortInUse = sentence("{}: in use by another program (\"fuser {}\" names it)");

}  // namespace

Message portInUse(const std::string& path) {
  Message out(MessageKind::device, kPortInUse);
  out.add(path);
  out.add(path);
  return out;
}

bool isInUse(const Message& problem) {
  if (problem.format == kDrivenElsewhere || problem.format == kPortInUse) return true;
  return std::ranges::any_of(problem.values, [](const Value& value) {
    const auto* part = std::get_if<Message>(&value.is);
    return part != nullptr && isInUse(*part);
  });
}

}  // namespace fyd::device
