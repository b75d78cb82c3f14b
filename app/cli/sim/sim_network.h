// fyd sim network …, a part of fyd sim.
#pragma once

#include "app/cli/parts/command.h"

namespace fyd::cli {

void addSimNetwork(CLI::App& sim);

}  // namespace fyd::cli
