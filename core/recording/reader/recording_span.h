// Smallest and largest values over stretches of a recording, from the coarsest stored level that is fine enough.
#pragma once

#include "core/recording/reader/recording_info.h"
#include "core/recording/reader/recording_tables.h"

namespace fyd::recording {

/// The first row whose `now` is at or after the instant; the number of rows when there is none.
[[nodiscard]] std::uint64_t firstRowAt(const RecordingTables& tables, std::int64_t instant_ns);

/// At most `buckets` over rows [first, end). @throws RecordingFailure
[[nodiscard]] Overview overviewOf(const RecordingTables& tables, Instant started, std::size_t field,
                                  std::uint64_t first, std::uint64_t end, std::size_t buckets);

}  // namespace fyd::recording
