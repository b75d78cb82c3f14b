// Delivers a closed recording's entry to its catalogue, or queues it while the catalogue is unavailable.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/catalogue/catalogue_types.h"

namespace fyd::catalogue {

/// Adds a closed recording to the catalogue. If the catalogue fails, the entry waits in pendingPath() and is delivered
/// when the catalogue is next opened: the error says so. The recording is safe either way.
[[nodiscard]] Result<void> catalogueRecording(const std::string& catalogue_word, const std::string& recording_path);
/// The same with an entry at hand.
[[nodiscard]] Result<void> deliverEntry(const std::string& catalogue_word, const CatalogueEntry& entry);

}  // namespace fyd::catalogue
