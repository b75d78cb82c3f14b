// Precompiled for the command line: the two heavy headers every subcommand reads.
#pragma once
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
