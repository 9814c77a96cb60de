// McapWriter: writes MCAP, the open container format for timestamped messages that Foxglove and
// PlotJuggler read (mcap.dev/spec).
//
// Messages are collected in chunks without compression.  Each chunk is written as a whole, with an
// index of its messages.  So the file of a program that was killed can still be used up to its last
// chunk.  The summary at the end of the file lets readers find a moment without reading the whole
// file.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openr_host {

// The opcodes of the MCAP records that openr writes and reads.
enum class McapOp : uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0b,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

// The bytes with which an MCAP file begins and ends.
constexpr std::string_view kMcapMagic("\x89MCAP0\r\n", 8);

class McapWriter {
 public:
  // The type of a function that appends bytes to the MCAP file.
  using Sink = std::function<void(std::string_view bytes)>;

  // Writes the beginning of the MCAP file.  `library` names the program that writes it.
  McapWriter(std::string_view library, Sink sink);

  // Adds a JSON schema with the name `name`.  Returns the number of the schema.
  uint16_t AddSchema(std::string_view name, std::string_view json_schema);
  // Adds a channel to the file: messages in JSON that have the schema with the number `schema`.
  // Returns the number of the channel.
  uint16_t AddChannel(std::string_view topic, uint16_t schema);

  // Adds a message to the channel `channel`.  Messages may come in any order of time.
  void Add(uint16_t channel, int64_t time_us, std::string_view json);

  // Writes a chunk, a block of the file, with the messages that were added since the last chunk.
  void EndChunk();
  size_t chunk_bytes() const { return chunk_.size(); }

  // Writes the last messages, the summary and the end of the file.  No other function may be called
  // afterwards.
  void Finish();

 private:
  struct Times {
    uint64_t first = 0, last = 0;
    bool is_empty = true;
    void Add(uint64_t time_ns);
  };
  struct ChunkPlace {
    Times times;
    uint64_t offset = 0, length = 0;
    // Number of each channel that has messages in this chunk, and the offset in the file at which
    // the index of these messages begins.
    std::vector<std::pair<uint16_t, uint64_t>> indexes;
    uint64_t indexes_length = 0;
    uint64_t size = 0;  // number of bytes of the records in the chunk
  };

  void Write(std::string_view bytes);
  std::string Statistics() const;

  const Sink sink_;
  uint64_t offset_ = 0;             // number of bytes written so far
  uint32_t crc_ = 0;                // checksum of all bytes written so far
  std::string schemas_, channels_;  // records of all schemas and channels, for the summary
  uint16_t schema_count_ = 0;
  std::vector<uint64_t> message_counts_;  // number of messages in each channel
  std::string chunk_;                     // records of the present chunk
  Times chunk_times_, times_;
  // The messages of the present chunk.  The key is the channel; the value has the time of each
  // message and its place in the chunk.
  std::map<uint16_t, std::vector<std::pair<uint64_t, uint64_t>>> in_chunk_;
  std::vector<ChunkPlace> chunks_;
};

}  // namespace openr_host
