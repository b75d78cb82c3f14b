// Counts every allocation of this test program.
#pragma once

#include <cstddef>

namespace fyd::protocol {

[[nodiscard]] std::size_t allocationCount();

}  // namespace fyd::protocol
