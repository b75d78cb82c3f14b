// Writes an MCAP file (the public specification at mcap.dev/spec, major version 0): schemas, channels and messages in
// uncompressed chunks with a CRC-32 each and an index after each; a summary with statistics, all indexes and offsets.
// The data section's own CRC is left out, as the specification allows: each chunk has one.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace fyd::exports {

using McapTexts = std::map<std::string, std::string>;

class McapWriter {
 public:
  using Sink = std::function<Result<void>(std::string_view)>;
  explicit McapWriter(Sink sink) : sink_(std::move(sink)) {}

  // In this order: start; metadata, attachments, schemas, channels, messages; finish. All return the sink's error.
  [[nodiscard]] Result<void> start(std::string_view library);
  [[nodiscard]] Result<void> metadata(std::string_view name, const McapTexts& texts);
  /// @param time_ns since 1970, as all times here
  [[nodiscard]] Result<void> attachment(std::string_view name, std::string_view content_type, std::string_view data,
                                        std::uint64_t time_ns);
  /// @return its id, from 1
  std::uint16_t addSchema(std::string_view name, std::string_view encoding, std::string_view data);
  /// @return its id, from 1
  std::uint16_t addChannel(std::uint16_t schema, std::string_view topic, std::string_view encoding,
                           const McapTexts& texts);
  [[nodiscard]] Result<void> message(std::uint16_t channel, std::uint64_t time_ns, std::string_view data);
  [[nodiscard]] Result<void> finish();

  [[nodiscard]] std::uint64_t messages() const { return messages_; }

 private:
  struct Times {
    std::uint64_t first_ns = 0;
    std::uint64_t last_ns = 0;
    bool any = false;
    void take(std::uint64_t time_ns);
  };
  Result<void> put(std::string_view bytes);
  Result<void> closeChunk();

  Sink sink_;
  std::uint64_t position_ = 0;  ///< bytes given to the sink

  std::string chunk_;  ///< records of the open chunk
  Times chunk_times_;
  std::map<std::uint16_t, std::string> chunk_index_;  ///< per channel, in the format of a Message Index

  Times times_;
  std::uint64_t messages_ = 0;
  std::map<std::uint16_t, std::uint64_t> channel_messages_;  ///< also the next sequence number
  std::uint16_t schemas_ = 0;
  std::uint32_t chunks_ = 0;
  std::uint32_t attachments_ = 0;
  std::uint32_t metadatas_ = 0;
  // Records of the summary, by group.
  std::string schema_records_, channel_records_, chunk_indexes_, attachment_indexes_, metadata_indexes_;
};

}  // namespace fyd::exports
