// fyd sim krc …, a part of fyd sim.
#pragma once

#include "app/cli/parts/command.h"

namespace fyd::cli {

void addSimKrc(CLI::App& sim);

}  // namespace fyd::cli
