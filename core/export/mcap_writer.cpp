#include "core/export/mcap_writer.h"

#include <algorithm>

#include "core/base/checksum.h"

namespace fyd::exports {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::size_t kChunk_bytes = 1 << 20;

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

/// Little-endian, as everything in the file.
template <class Integer>
void append(std::string& to, Integer value) {
  for (std::size_t byte = 0; byte < sizeof(Integer); ++byte) {
    to += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * byte) & 0xFF);
  }
}

void appendString(std::string& to, std::string_view text) {
  append(to, static_cast<std::uint32_t>(text.size()));
  to += text;
}

void appendTexts(std::string& to, const McapTexts& texts) {
  std::string pairs;
  for (const auto& [key, value] : texts) {
    appendString(pairs, key);
    appendString(pairs, value);
  }
  appendString(to, pairs);
}

void appendRecord(std::string& to, Opcode opcode, std::string_view content) {
  append(to, static_cast<std::uint8_t>(opcode));
  append(to, static_cast<std::uint64_t>(content.size()));
  to += content;
}

std::string record(Opcode opcode, std::string_view content) {
  std::string bytes;
  appendRecord(bytes, opcode, content);
  return bytes;
}

std::uint32_t crcOf(std::string_view bytes) { return crc32(std::as_bytes(std::span(bytes))); }

}  // namespace

void McapWriter::Times::take(std::uint64_t time_ns) {
  first_ns = any ? std::min(first_ns, time_ns) : time_ns;
  last_ns = any ? std::max(last_ns, time_ns) : time_ns;
  any = true;
}

Result<void> McapWriter::put(std::string_view bytes) {
  if (auto written = sink_(bytes); !written) return written;
  position_ += bytes.size();
  return {};
}

Result<void> McapWriter::start(std::string_view library) {
  std::string header;
  appendString(header, "");  // no profile
  appendString(header, library);
  return put(std::string(kMagic) + record(Opcode::header, header));
}

Result<void> McapWriter::metadata(std::string_view name, const McapTexts& texts) {
  std::string content;
  appendString(content, name);
  appendTexts(content, texts);
  const std::string bytes = record(Opcode::metadata, content);
  std::string index;
  append(index, position_);
  append(index, static_cast<std::uint64_t>(bytes.size()));
  appendString(index, name);
  appendRecord(metadata_indexes_, Opcode::metadata_index, index);
  ++metadatas_;
  return put(bytes);
}

Result<void> McapWriter::attachment(std::string_view name, std::string_view content_type, std::string_view data,
                                    std::uint64_t time_ns) {
  std::string content;
  append(content, time_ns);
  append(content, time_ns);
  appendString(content, name);
  appendString(content, content_type);
  append(content, static_cast<std::uint64_t>(data.size()));
  content += data;
  append(content, crcOf(content));
  const std::string bytes = record(Opcode::attachment, content);
  std::string index;
  append(index, position_);
  append(index, static_cast<std::uint64_t>(bytes.size()));
  append(index, time_ns);
  append(index, time_ns);
  append(index, static_cast<std::uint64_t>(data.size()));
  appendString(index, name);
  appendString(index, content_type);
  appendRecord(attachment_indexes_, Opcode::attachment_index, index);
  ++attachments_;
  return put(bytes);
}

std::uint16_t McapWriter::addSchema(std::string_view name, std::string_view encoding, std::string_view data) {
  std::string content;
  append(content, ++schemas_);
  appendString(content, name);
  appendString(content, encoding);
  appendString(content, data);
  const std::string bytes = record(Opcode::schema, content);
  schema_records_ += bytes;
  chunk_ += bytes;
  return schemas_;
}

std::uint16_t McapWriter::addChannel(std::uint16_t schema, std::string_view topic, std::string_view encoding,
                                     const McapTexts& texts) {
  const auto id = static_cast<std::uint16_t>(channel_messages_.size() + 1);
  channel_messages_[id] = 0;
  std::string content;
  append(content, id);
  append(content, schema);
  appendString(content, topic);
  appendString(content, encoding);
  appendTexts(content, texts);
  const std::string bytes = record(Opcode::channel, content);
  channel_records_ += bytes;
  chunk_ += bytes;
  return id;
}

Result<void> McapWriter::message(std::uint16_t channel, std::uint64_t time_ns, std::string_view data) {
  if (!chunk_.empty() && chunk_.size() + data.size() > kChunk_bytes) {
    if (auto closed = closeChunk(); !closed) return closed;
  }
  std::string& index = chunk_index_[channel];
  append(index, time_ns);
  append(index, static_cast<std::uint64_t>(chunk_.size()));

  append(chunk_, static_cast<std::uint8_t>(Opcode::message));
  append(chunk_, static_cast<std::uint64_t>(2 + 4 + 8 + 8 + data.size()));
  append(chunk_, channel);
  append(chunk_, static_cast<std::uint32_t>(channel_messages_[channel]++));
  append(chunk_, time_ns);  // logged
  append(chunk_, time_ns);  // published
  chunk_ += data;
  chunk_times_.take(time_ns);
  times_.take(time_ns);
  ++messages_;
  return {};
}

Result<void> McapWriter::closeChunk() {
  if (chunk_.empty()) return {};
  std::string content;
  append(content, chunk_times_.first_ns);
  append(content, chunk_times_.last_ns);
  append(content, static_cast<std::uint64_t>(chunk_.size()));
  append(content, crcOf(chunk_));
  appendString(content, "");  // no compression
  append(content, static_cast<std::uint64_t>(chunk_.size()));
  content += chunk_;
  std::string bytes = record(Opcode::chunk, content);
  const std::size_t chunk_length = bytes.size();

  std::string offsets;
  for (const auto& [channel, entries] : chunk_index_) {
    append(offsets, channel);
    append(offsets, position_ + bytes.size());
    std::string index;
    append(index, channel);
    appendString(index, entries);
    appendRecord(bytes, Opcode::message_index, index);
  }
  std::string index;
  append(index, chunk_times_.first_ns);
  append(index, chunk_times_.last_ns);
  append(index, position_);
  append(index, static_cast<std::uint64_t>(chunk_length));
  appendString(index, offsets);
  append(index, static_cast<std::uint64_t>(bytes.size() - chunk_length));
  appendString(index, "");
  append(index, static_cast<std::uint64_t>(chunk_.size()));
  append(index, static_cast<std::uint64_t>(chunk_.size()));
  appendRecord(chunk_indexes_, Opcode::chunk_index, index);

  ++chunks_;
  chunk_.clear();
  chunk_index_.clear();
  chunk_times_ = {};
  return put(bytes);
}

Result<void> McapWriter::finish() {
  if (auto closed = closeChunk(); !closed) return closed;
  std::string end;
  append(end, std::uint32_t{0});  // no CRC of the whole data section
  if (auto written = put(record(Opcode::data_end, end)); !written) return written;

  std::string statistics;
  append(statistics, messages_);
  append(statistics, schemas_);
  append(statistics, static_cast<std::uint32_t>(channel_messages_.size()));
  append(statistics, attachments_);
  append(statistics, metadatas_);
  append(statistics, chunks_);
  append(statistics, times_.first_ns);
  append(statistics, times_.last_ns);
  std::string counts;
  for (const auto& [channel, count] : channel_messages_) {
    append(counts, channel);
    append(counts, count);
  }
  appendString(statistics, counts);

  std::string summary;
  std::string offsets;
  const auto addGroup = [&](Opcode opcode, const std::string& records) {
    if (records.empty()) return;
    std::string offset;
    append(offset, static_cast<std::uint8_t>(opcode));
    append(offset, position_ + summary.size());
    append(offset, static_cast<std::uint64_t>(records.size()));
    appendRecord(offsets, Opcode::summary_offset, offset);
    summary += records;
  };
  addGroup(Opcode::schema, schema_records_);
  addGroup(Opcode::channel, channel_records_);
  addGroup(Opcode::statistics, record(Opcode::statistics, statistics));
  addGroup(Opcode::chunk_index, chunk_indexes_);
  addGroup(Opcode::attachment_index, attachment_indexes_);
  addGroup(Opcode::metadata_index, metadata_indexes_);

  // The summary's CRC reaches from its start to just before itself, in the footer.
  std::string footer;
  append(footer, position_);
  append(footer, position_ + summary.size());
  std::string bytes = summary + offsets;
  append(bytes, static_cast<std::uint8_t>(Opcode::footer));
  append(bytes, static_cast<std::uint64_t>(footer.size() + sizeof(std::uint32_t)));
  bytes += footer;
  append(bytes, crcOf(bytes));
  bytes += kMagic;
  return put(bytes);
}

}  // namespace fyd::exports
