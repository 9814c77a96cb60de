#include "openr/data/mcap_writer.h"

#include <zlib.h>

#include <algorithm>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

uint32_t Crc(uint32_t crc, std::string_view bytes) {
  return static_cast<uint32_t>(
      crc32_z(crc, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

// Builds the fields of a record of an MCAP file in the form that the section "Serialization" of the
// MCAP specification describes.
class McapFields {
 public:
  McapFields& U8(uint8_t value) { return Number(value, 1); }
  McapFields& U16(uint16_t value) { return Number(value, 2); }
  McapFields& U32(uint32_t value) { return Number(value, 4); }
  McapFields& U64(uint64_t value) { return Number(value, 8); }
  McapFields& Bytes(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  // Appends the length of `text`, a number of 32 bits, and then its bytes.  Strings, arrays and
  // maps have this form.
  McapFields& Text(std::string_view text) {
    return U32(static_cast<uint32_t>(text.size())).Bytes(text);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  McapFields& Number(uint64_t value, int count) {
    for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i)));
    return *this;
  }
  std::string bytes_;
};

std::string McapRecord(McapOp op, const McapFields& fields) {
  McapFields record;
  record.U8(static_cast<uint8_t>(op)).U64(fields.bytes().size()).Bytes(fields.bytes());
  return record.bytes();
}

uint64_t McapTimeOf(int64_t time_us) { return static_cast<uint64_t>(time_us) * 1000; }

}  // namespace

void McapWriter::Times::Add(uint64_t time_ns) {
  first = is_empty ? time_ns : std::min(first, time_ns);
  last = is_empty ? time_ns : std::max(last, time_ns);
  is_empty = false;
}

McapWriter::McapWriter(std::string_view library, Sink sink) : sink_(std::move(sink)) {
  Write(std::string(kMcapMagic) + McapRecord(McapOp::kHeader, McapFields().Text("").Text(library)));
}

void McapWriter::Write(std::string_view bytes) {
  crc_ = Crc(crc_, bytes);
  offset_ += bytes.size();
  sink_(bytes);
}

uint16_t McapWriter::AddSchema(std::string_view name, std::string_view json_schema) {
  const uint16_t number = ++schema_count_;  // schemas are numbered from 1; 0 means "no schema"
  const std::string record = McapRecord(
      McapOp::kSchema, McapFields().U16(number).Text(name).Text("jsonschema").Text(json_schema));
  schemas_ += record;
  Write(record);
  return number;
}

uint16_t McapWriter::AddChannel(std::string_view topic, uint16_t schema) {
  const auto number = static_cast<uint16_t>(message_counts_.size());
  message_counts_.push_back(0);
  const std::string record = McapRecord(
      McapOp::kChannel, McapFields().U16(number).U16(schema).Text(topic).Text("json").Text(""));
  channels_ += record;
  Write(record);
  return number;
}

void McapWriter::Add(uint16_t channel, int64_t time_us, std::string_view json) {
  ASSERT(channel < message_counts_.size());
  const uint64_t time_ns = McapTimeOf(time_us);
  in_chunk_[channel].emplace_back(time_ns, chunk_.size());
  chunk_times_.Add(time_ns);
  times_.Add(time_ns);
  const auto sequence = static_cast<uint32_t>(message_counts_[channel]++);
  chunk_ +=
      McapRecord(McapOp::kMessage,
                 McapFields().U16(channel).U32(sequence).U64(time_ns).U64(time_ns).Bytes(json));
}

void McapWriter::EndChunk() {
  if (chunk_.empty()) return;
  ChunkPlace place;
  place.times = chunk_times_;
  place.offset = offset_;
  place.size = chunk_.size();
  std::string bytes = McapRecord(McapOp::kChunk, McapFields()
                                                     .U64(chunk_times_.first)
                                                     .U64(chunk_times_.last)
                                                     .U64(chunk_.size())
                                                     .U32(Crc(0, chunk_))
                                                     // Leaves the name of the compression empty,
                                                     // because the chunk is not compressed.
                                                     .Text("")
                                                     .U64(chunk_.size())
                                                     .Bytes(chunk_));
  place.length = bytes.size();
  for (const auto& [channel, messages] : in_chunk_) {
    place.indexes.emplace_back(channel, offset_ + bytes.size());
    McapFields entries;
    for (const auto& [time_ns, at] : messages) entries.U64(time_ns).U64(at);
    bytes += McapRecord(McapOp::kMessageIndex, McapFields().U16(channel).Text(entries.bytes()));
  }
  place.indexes_length = bytes.size() - place.length;
  Write(bytes);
  chunks_.push_back(std::move(place));
  chunk_.clear();
  in_chunk_.clear();
  chunk_times_ = {};
}

std::string McapWriter::Statistics() const {
  McapFields counts;
  uint64_t sum = 0;
  for (size_t channel = 0; channel < message_counts_.size(); ++channel) {
    counts.U16(static_cast<uint16_t>(channel)).U64(message_counts_[channel]);
    sum += message_counts_[channel];
  }
  return McapRecord(McapOp::kStatistics, McapFields()
                                             .U64(sum)
                                             .U16(schema_count_)
                                             .U32(static_cast<uint32_t>(message_counts_.size()))
                                             .U32(0)  // number of attachments in the file
                                             .U32(0)  // number of metadata records in the file
                                             .U32(static_cast<uint32_t>(chunks_.size()))
                                             .U64(times_.first)
                                             .U64(times_.last)
                                             .Text(counts.bytes()));
}

void McapWriter::Finish() {
  EndChunk();
  Write(McapRecord(McapOp::kDataEnd, McapFields().U32(crc_)));
  const uint64_t summary_start = offset_;
  std::string chunk_indexes;
  for (const ChunkPlace& chunk : chunks_) {
    McapFields offsets;
    for (const auto& [channel, offset] : chunk.indexes) offsets.U16(channel).U64(offset);
    chunk_indexes += McapRecord(McapOp::kChunkIndex, McapFields()
                                                         .U64(chunk.times.first)
                                                         .U64(chunk.times.last)
                                                         .U64(chunk.offset)
                                                         .U64(chunk.length)
                                                         .Text(offsets.bytes())
                                                         .U64(chunk.indexes_length)
                                                         .Text("")
                                                         .U64(chunk.size)
                                                         .U64(chunk.size));
  }
  std::string summary, summary_offsets;
  const auto add_group = [&](McapOp op, const std::string& records) {
    if (records.empty()) return;
    summary_offsets += McapRecord(McapOp::kSummaryOffset, McapFields()
                                                              .U8(static_cast<uint8_t>(op))
                                                              .U64(summary_start + summary.size())
                                                              .U64(records.size()));
    summary += records;
  };
  add_group(McapOp::kSchema, schemas_);
  add_group(McapOp::kChannel, channels_);
  add_group(McapOp::kStatistics, Statistics());
  add_group(McapOp::kChunkIndex, chunk_indexes);
  // Writes the footer with its checksum, which the MCAP specification defines over the summary and
  // the first two fields of the footer.
  McapFields footer;
  footer.U8(static_cast<uint8_t>(McapOp::kFooter)).U64(8 + 8 + 4);
  footer.U64(summary_start).U64(summary_start + summary.size());
  const std::string end = summary + summary_offsets + footer.bytes();
  Write(end + McapFields().U32(Crc(0, end)).bytes() + std::string(kMcapMagic));
}

}  // namespace openr_host
