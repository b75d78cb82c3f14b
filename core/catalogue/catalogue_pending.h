// Entries that could not be put into their catalogue: they wait in a SQLite file of this user, one row per catalogue
// and recording, until the catalogue opens again. A row is removed only after its entry is delivered; delivering it
// twice has no effect.
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"
#include "core/catalogue/catalogue_types.h"

namespace fyd::catalogue {

/// Result of the delivery of entries that waited for this catalogue.
struct PendingReport {
  std::size_t delivered = 0;
  std::size_t waiting = 0;
  Message problem;  ///< why some still wait
};

/// @param key CatalogueAddress::key
[[nodiscard]] Result<void> queueEntry(const std::string& key, const CatalogueEntry& entry, const std::string& reason);

/// Hands the waiting entries to `deliver`, oldest first; stops at the first that fails.
[[nodiscard]] PendingReport deliverPending(const std::string& key,
                                           const std::function<Result<void>(const CatalogueEntry&)>& deliver);

}  // namespace fyd::catalogue
