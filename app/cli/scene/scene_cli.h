// The parts of `fyd scene`.
#pragma once

#include <CLI/CLI.hpp>

namespace fyd::cli {

void addSceneRun(CLI::App& scene);
void addSceneFence(CLI::App& scene);
void addSceneKeys(CLI::App& scene);
void addSceneExplain(CLI::App& scene);

}  // namespace fyd::cli
