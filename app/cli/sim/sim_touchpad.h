// fyd sim touchpad …, a part of fyd sim.
#pragma once

#include "app/cli/parts/command.h"

namespace fyd::cli {

void addSimTouchpad(CLI::App& sim);

}  // namespace fyd::cli
