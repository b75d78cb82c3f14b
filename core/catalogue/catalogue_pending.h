// Entries that could not be put into their catalogue: they wait in a SQLite file of this user, one row per catalogue
// and recording, until the catalogue opens again. A row is removed only after its entry is delivered; delivering it
// twice has no effect.
#pragma once

#include <cstdint>
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

enum class Delivered : std::uint8_t {
  yes,
  refused,     ///< this entry cannot go in, the next may
  unreachable  ///< nor can the next
};
struct Delivery {
  Delivered delivered = Delivered::yes;
  Message problem;
};
/// Hands the waiting entries to `deliver`, oldest first; stops when the catalogue cannot be reached, as each further
/// one would run into the same time-out.
[[nodiscard]] PendingReport deliverPending(const std::string& key,
                                           const std::function<Delivery(const CatalogueEntry&)>& deliver);

}  // namespace fyd::catalogue
