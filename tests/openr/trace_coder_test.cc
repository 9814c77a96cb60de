// TraceCoder: the payloads of a recording, of which only the bytes that differ are written.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "openr/inspect/trace_file.h"
#include "runtime/base/rng.h"

namespace openr_host {
namespace {

TraceEntry MessageWith(const std::string& payload) {
  TraceEntry entry;
  entry.kind = TraceEntry::Kind::kMessage;
  entry.payload = payload;
  return entry;
}

// Writes messages with these payloads, reads them again and returns what was read.
std::vector<std::string> Coded(const std::vector<std::string>& payloads) {
  ByteWriter out;
  TraceCoder writer(true);
  for (const std::string& payload : payloads) writer.Write(MessageWith(payload), &out);
  ByteReader in(out.bytes());
  TraceCoder reader(true);
  std::vector<std::string> read;
  while (!in.AtEnd()) read.push_back(reader.Read(&in).payload);
  return read;
}

// Returns the bytes that are written for `payload` if `before` was the last payload.
std::string Written(const std::string& before, const std::string& payload) {
  ByteWriter out;
  TraceCoder coder(true);
  coder.Write(MessageWith(before), &out);
  const size_t begin = out.bytes().size();
  coder.Write(MessageWith(payload), &out);
  const size_t head = 1 + 7 + 8;  // kind, seven small numbers and the hash
  return out.bytes().substr(begin + head);
}

TEST(TraceCoderTest, OnlyBytesThatDifferAreWritten) {
  std::string before(600, 'a');
  std::string now = before;
  now[590] = 'b';
  // Size 600; 590 equal bytes; 5 other bytes, of which 4 are equal; 5 equal bytes; no others.
  EXPECT_EQ(Written(before, now), std::string("\xd8\x04\xce\x04\x05"
                                              "baaaa"
                                              "\x05\x00",
                                              12));
  EXPECT_EQ(Written(now, now), std::string("\xd8\x04\xd8\x04\x00", 5));
}

TEST(TraceCoderTest, EachByteMayBeTheOneThatDiffers) {
  for (const size_t size : {1, 7, 8, 9, 63, 64, 65, 511, 512, 513, 600}) {
    std::vector<std::string> payloads(1, std::string(size, 'a'));
    for (size_t i = 0; i < size; ++i) {
      payloads.push_back(payloads.back());
      payloads.back()[i] = 'b';
    }
    EXPECT_EQ(Coded(payloads), payloads) << size << " bytes";
  }
}

TEST(TraceCoderTest, PayloadsThatResembleEachOtherComeBack) {
  Rng rng(1, "payloads");
  std::vector<std::string> payloads = {"", std::string(2000, '\0')};
  for (int i = 0; i < 300; ++i) {
    std::string next = payloads.back();
    for (uint64_t changes = rng.NextBelow(20); changes > 0; --changes)
      next[rng.NextBelow(next.size())] = static_cast<char>(rng.Next());
    payloads.push_back(next);
  }
  EXPECT_EQ(Coded(payloads), payloads);
}

// Returns the bytes of a message of `size` bytes that are all zero.  They are written as equal to
// bytes that were never sent, so a damaged file of some bytes can claim any size.
std::string MessageOfZeros(size_t size) {
  ByteWriter out;
  TraceCoder coder(true);
  coder.Write(MessageWith(std::string(size, '\0')), &out);
  return out.bytes();
}

TEST(TraceCoderTest, ShortBytesCannotClaimAllMemory) {
  std::string bytes;
  // One message less than 512 MiB, and a last one that goes over it.
  const size_t most = 64 << 20;
  for (size_t i = 0; i < 9; ++i) bytes += MessageOfZeros(most - i);
  EXPECT_LT(bytes.size(), 400u);
  ByteReader in(bytes);
  TraceCoder reader(true);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(reader.Read(&in).payload.size(), most - i);
  EXPECT_THROW(reader.Read(&in), std::runtime_error);
}

TEST(TraceCoderTest, TimesOfADamagedFileMayBeAnyNumber) {
  TraceEntry late = MessageWith("");
  late.record.time_us = std::numeric_limits<int64_t>::max();
  ByteWriter out;
  TraceCoder(true).Write(late, &out);
  const std::string twice = out.bytes() + out.bytes();  // a time is the difference to the last one
  ByteReader in(twice);
  TraceCoder reader(true);
  EXPECT_EQ(reader.Read(&in).record.time_us, std::numeric_limits<int64_t>::max());
  EXPECT_EQ(reader.Read(&in).record.time_us, -2);
}

}  // namespace
}  // namespace openr_host
