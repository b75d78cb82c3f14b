// Problems that say: the device is there, and another program has it. No cable is to blame then.
#pragma once

#include "core/base/message.h"

namespace fyd::device {

inline constexpr std::string_view kDrivenElsewhere =
    sentence("exception 6: it is busy, another program drives its motors; close that one");
/// The port's name twice.
[[nodiscard]] Message portInUse(const std::string& path);

/// Whether `problem`, or one that it is made of, says so.
[[nodiscard]] bool isInUse(const Message& problem);

}  // namespace fyd::device
