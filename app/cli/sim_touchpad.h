// fyd sim touchpad …, a part of fyd sim.
#pragma once

#include "app/cli/command.h"

namespace fyd::cli {

void addSimTouchpad(CLI::App& sim);

}  // namespace fyd::cli
