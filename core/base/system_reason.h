// Why a call of the system failed, in words that can be translated.
#pragma once

#include <system_error>

#include "core/base/message.h"

namespace fyd {

/// @param error as in `errno`. @return the system's text for it, in English
[[nodiscard]] Message systemReason(int error);
[[nodiscard]] Message systemReason(const std::error_code& error);

}  // namespace fyd
