// Precompiled for the command line: the two heavy headers every subcommand reads.
#pragma once
#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
