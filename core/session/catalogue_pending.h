// Entries that could not be put into their catalogue: they wait in a SQLite file of this user, one row per catalogue
// and recording, until the catalogue opens again. A row goes only after its entry is in; delivering it twice does no
// harm.
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"
#include "core/session/catalogue.h"

namespace fyd::session {

/// @param key CatalogueWord::key
[[nodiscard]] Result<void> queueEntry(const std::string& key, const CatalogueEntry& entry, const std::string& reason);

/// Hands the waiting entries to `deliver`, oldest first; stops at the first that the catalogue refuses to take.
[[nodiscard]] PendingReport deliverPending(const std::string& key,
                                           const std::function<Result<void>(const CatalogueEntry&)>& deliver);

}  // namespace fyd::session
