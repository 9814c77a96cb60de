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
  const size_t head = 1 + 5 + 8;  // kind, five small numbers and the hash
  return std::string(out.bytes().substr(begin + head));
}

TEST(TraceCoderTest, OnlyWordsThatDifferAreWritten) {
  std::string before(600, 'a');
  std::string now = before;
  now[590] = 'b';
  // Size 600; 9 equal blocks of 64 bytes; the mask of the tenth, whose fourth word differs.
  EXPECT_EQ(Written(before, now), std::string("\xd8\x04\x09\x08\x00"
                                              "aaba",
                                              9));
  EXPECT_EQ(Written(now, now), std::string("\xd8\x04\x0a", 3));
  before[0] = 'b';
  EXPECT_EQ(Written(before, std::string(600, 'a')), std::string("\xd8\x04\x00\x01\x00"
                                                                "aaaa\x09",
                                                                10));
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
  return std::string(out.bytes());
}

// Returns `message`, the first message of a file, as a later message of the same link, which leaves
// out sender, receiver and selector.
std::string Later(const std::string& message) { return message.substr(0, 2) + message.substr(5); }

TEST(TraceCoderTest, ShortBytesCannotClaimAllMemory) {
  std::string bytes;
  // Eight messages with a little less than 512 MiB in all; the ninth exceeds this limit.
  const size_t most = 64 << 20;
  bytes = MessageOfZeros(most);
  for (size_t i = 1; i < 9; ++i) bytes += Later(MessageOfZeros(most - i));
  EXPECT_LT(bytes.size(), 400u);
  ByteReader in(bytes);
  TraceCoder reader(true);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(reader.Read(&in).payload.size(), most - i);
  try {
    reader.Read(&in);
    FAIL() << "the ninth message was read";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "the contents of the messages need more than 536870912 bytes of memory; if the "
                 "file is not damaged, an older openr has recorded the run: replay it with that "
                 "one, or record the run again, which this openr can read to its end");
  }
}

TEST(TraceCoderTest, PayloadsOfMoreThan512MiBComeBack) {
  // The ninth payload exceeds the limit, and the writer forgets the payloads before it.  The tenth
  // has the size of the first again, and another byte that is not zero.
  const size_t most = 64 << 20;
  const auto payload_of = [&](size_t i) {
    std::string payload(i < 9 ? most - i : most, '\0');
    payload[i * 100] = static_cast<char>('a' + i);
    return payload;
  };
  ByteWriter out;
  {
    TraceCoder writer(true);
    for (size_t i = 0; i < 10; ++i) writer.Write(MessageWith(payload_of(i)), &out);
  }
  EXPECT_LT(out.bytes().size(), 500u);
  ByteReader in(out.bytes());
  TraceCoder reader(true);
  for (size_t i = 0; i < 10; ++i) EXPECT_TRUE(reader.Read(&in).payload == payload_of(i)) << i;
  EXPECT_TRUE(in.AtEnd());
}

TEST(TraceCoderTest, TimesOfADamagedFileMayBeAnyNumber) {
  TraceEntry late = MessageWith("");
  late.record.time_us = std::numeric_limits<int64_t>::max();
  ByteWriter out;
  TraceCoder(true).Write(late, &out);
  const std::string first(out.bytes());
  const std::string twice = first + Later(first);  // a time is the difference to the last one
  ByteReader in(twice);
  TraceCoder reader(true);
  EXPECT_EQ(reader.Read(&in).record.time_us, std::numeric_limits<int64_t>::max());
  EXPECT_EQ(reader.Read(&in).record.time_us, -2);
}

// Returns a message of link 0 from object 1 to entry 3 of object 2, with this payload.
std::string MessageOfBytes(const std::string& payload) {
  const std::string head(
      "\x0d\x00\x02\x04\x03"  // kind, link, which it defines
      "\x02\x02\x00\x06"      // number 1, cause 0, time 0, size 6
      "\0\0\0\0\0\0\0\0",
      17);  // hash
  return head + payload;
}

// Reads one message, and returns its payload or why it is damaged.
std::string PayloadOrDamage(const std::string& bytes) {
  try {
    ByteReader in(bytes);
    return TraceCoder(true).Read(&in).payload;
  } catch (const std::runtime_error& e) {
    return std::string("damage: ") + e.what();
  }
}

TEST(TraceCoderTest, DamagedPayloadsAreRefused) {
  const auto damage = [](const char* payload, size_t size) {
    return PayloadOrDamage(MessageOfBytes(std::string(payload, size)));
  };
  EXPECT_EQ(damage("\x06\x00\x02\x00xy\0\0", 8), std::string("\0\0\0\0xy", 6));
  EXPECT_EQ(damage("\x06\x01", 2), std::string(6, '\0'));
  EXPECT_EQ(damage("\x06\x02", 2), "damage: more equal blocks of a message than it has");
  EXPECT_EQ(damage("\x06\x00\x00\x00", 4),
            "damage: a changed block of a message without a changed word");
  EXPECT_EQ(damage("\x06\x00\x04\x00zzzz", 8),
            "damage: a changed word behind the end of a message");
  EXPECT_EQ(damage("\x06\x00\x03\x00zzzz", 8), "damage: the data end too early");
  EXPECT_EQ(PayloadOrDamage(std::string("\x0d\x01", 2)), "damage: a message of an unknown link");
}

TEST(TraceCoderTest, EachLinkIsDefinedOnce) {
  ByteWriter out;
  TraceCoder writer(false);
  std::vector<size_t> sizes;
  std::vector<TraceEntry> entries;
  for (const int32_t target : {4, 5, 4, 5}) {
    TraceEntry entry = MessageWith("");
    entry.record.number = entries.size();
    entry.record.sender = 3;
    entry.record.target = target;
    entry.record.selector = 7;
    const size_t before = out.bytes().size();
    writer.Write(entry, &out);
    sizes.push_back(out.bytes().size() - before);
    entries.push_back(entry);
  }
  EXPECT_EQ(sizes, (std::vector<size_t>{17, 17, 14, 14}));
  ByteReader in(out.bytes());
  TraceCoder reader(false);
  for (const TraceEntry& entry : entries) {
    const TraceRecord read = reader.Read(&in).record;
    EXPECT_EQ(read.sender, 3);
    EXPECT_EQ(read.target, entry.record.target);
    EXPECT_EQ(read.selector, 7u);
    EXPECT_EQ(read.number, entry.record.number);
  }
}

// Programs before version 5 wrote sender, receiver and selector with each message, and the payload
// as pieces: a count of equal bytes and a text of others.
TEST(TraceCoderTest, MessagesOfVersion4AreRead) {
  const std::string message(
      "\x03\x02\x02\x00\x08\x0a\x07\x06"  // as far as the size
      "\x01\0\0\0\0\0\0\0"                // hash
      "\x06\x02\x02"                      // size, 2 equal bytes, 2 others
      "ab"
      "\x02\x00",
      23);
  ByteReader in(message);
  const TraceEntry entry = TraceCoder(true).Read(&in);
  EXPECT_EQ(entry.kind, TraceEntry::Kind::kMessage);
  EXPECT_EQ(entry.record.sender, 4);
  EXPECT_EQ(entry.record.target, 5);
  EXPECT_EQ(entry.record.selector, 7u);
  EXPECT_EQ(entry.record.payload_hash, 1u);
  EXPECT_EQ(entry.payload, std::string("\0\0ab\0\0", 6));
  EXPECT_TRUE(in.AtEnd());
}

}  // namespace
}  // namespace openr_host
