// Tests of the bytes that measured.md describes in 1.25 to 1.29, and of those of OPEN-R calls
// (core.md, 5.4).
#include "runtime/gateway/gateway_stream.h"

#include <gtest/gtest.h>

#include "runtime/gateway/proxy_wire.h"
#include "tests/runtime/gateway/gateway_bytes.h"

namespace openr_host {
namespace {

using Result = GatewayStream::Result;

// Returns the error of these bytes; "" if they are one whole set, or the beginning of one.
std::string ErrorIn(const std::string& bytes) {
  GatewayStream stream;
  stream.Feed(bytes);
  GatewaySet set;
  return stream.NextSet(&set) == Result::kBroken ? stream.error() : "";
}

TEST(GatewayStreamTest, WordsAreLittleEndian) {
  EXPECT_EQ(EncodeWord(0x01020304), std::string("\x04\x03\x02\x01", 4));
  GatewayStream stream;
  stream.Feed(std::string("\x03\0\0\0\xff\xfe\xfd\xfc", 8));
  uint32_t word = 0;
  EXPECT_EQ(stream.NextWord(&word), Result::kTaken);
  EXPECT_EQ(word, kGatewayAssert);
  EXPECT_EQ(stream.NextWord(&word), Result::kTaken);
  EXPECT_EQ(word, 0xfcfdfeffu);
  EXPECT_EQ(stream.NextWord(&word), Result::kNeedsMore);
}

TEST(GatewayStreamTest, SetIsByteCountNumberOfItemsAndItems) {
  EXPECT_EQ(EncodeSet({"ab", "xyz"}), Words({4 + 4 + 2 + 4 + 3, 2, 2}) + "ab" + Words({3}) + "xyz");
}

TEST(GatewayStreamTest, SetsArriveInAnyPieces) {
  const std::string bytes = EncodeSet({"ab", "xyz"}) + EncodeSet({"c"});
  for (size_t piece = 1; piece <= bytes.size(); ++piece) {
    GatewayStream stream;
    std::vector<GatewaySet> sets;
    for (size_t at = 0; at < bytes.size(); at += piece) {
      stream.Feed(bytes.substr(at, piece));
      GatewaySet set;
      while (stream.NextSet(&set) == Result::kTaken) sets.push_back(set);
    }
    EXPECT_EQ(sets, (std::vector<GatewaySet>{{"ab", "xyz"}, {"c"}})) << piece;
  }
}

TEST(GatewayStreamTest, ThirteenItemsAreTheMost) {
  EXPECT_EQ(ErrorIn(EncodeSet(GatewaySet(13, "x"))), "");
  EXPECT_EQ(ErrorIn(EncodeSet(GatewaySet(14, "x"))),
            "announces 14 items; a notification has 1 to 13");
  EXPECT_EQ(ErrorIn(Words({8, 0, 0})), "announces 8 bytes, which no set of data has");
  EXPECT_EQ(ErrorIn(Words({12, 0, 0, 0})), "announces 0 items; a notification has 1 to 13");
}

// The size is checked before the bytes arrive, so no memory is used for a set that is too large.
TEST(GatewayStreamTest, SizeIsBoundedBeforeItIsBelieved) {
  EXPECT_EQ(ErrorIn(Words({kGatewaySetBytesMax})), "");
  EXPECT_EQ(ErrorIn(Words({kGatewaySetBytesMax + 1})),
            "announces 1048577 bytes, the limit is 1048576");
  EXPECT_EQ(ErrorIn(Words({0xffffffff})), "announces 4294967295 bytes, the limit is 1048576");
}

TEST(GatewayStreamTest, ItemsMustFitTheSet) {
  EXPECT_EQ(ErrorIn(Words({12, 1, 5}) + "abcd"), "item 1 of 1 has 5 bytes, 4 are left");
  EXPECT_EQ(ErrorIn(Words({12, 1, 0xffffffff}) + "abcd"),
            "item 1 of 1 has 4294967295 bytes, 4 are left");
  EXPECT_EQ(ErrorIn(Words({12, 2, 4}) + "abcd"), "item 2 of 2 has 0 bytes, 0 are left");
  EXPECT_EQ(ErrorIn(Words({12, 1, 0}) + "abcd"), "item 1 of 1 has 0 bytes, 4 are left");
  EXPECT_EQ(ErrorIn(Words({12, 1, 3}) + "abcd"), "1 bytes are left after the last item");
}

// ---- OPEN-R calls

// Returns the error of the OPEN-R call with these bytes; "" if there is none.
std::string ErrorInFrame(const std::string& item) {
  ProxyFrame frame;
  return DecodeProxyFrame(item, &frame);
}

TEST(ProxyWireTest, EachCommandHasTheWordsOfTheReference) {
  EXPECT_EQ(EncodeProxyFrame({.command = ProxyCommand::kFind, .name = "OVirtualRobot"}),
            OneItem(Words({1}) + Padded("OVirtualRobot", 64)));
  EXPECT_EQ(EncodeProxyFrame({.command = ProxyCommand::kFindReply, .error = 12, .oid = 7}),
            OneItem(Words({2, 12, 7})));
  EXPECT_EQ(
      EncodeProxyFrame({.command = ProxyCommand::kSend, .oid = 7, .selector = 4, .bytes = "abc"}),
      OneItem(Words({3, 7, 4, 3}) + "abc"));
  EXPECT_EQ(EncodeProxyFrame({.command = ProxyCommand::kSendReply, .error = 2}),
            OneItem(Words({4, 2})));
  EXPECT_EQ(EncodeProxyFrame({.command = ProxyCommand::kCall,
                              .oid = 7,
                              .selector = 4,
                              .reply_size = 12,
                              .bytes = "abc"}),
            OneItem(Words({5, 7, 4, 3, 12}) + "abc"));
  EXPECT_EQ(EncodeProxyFrame({.command = ProxyCommand::kCallReply, .bytes = "abc"}),
            OneItem(Words({6, 0, 3}) + "abc"));
}

TEST(ProxyWireTest, WhatIsReadIsWhatWasWritten) {
  ProxyFrame frame;
  EXPECT_EQ(DecodeProxyFrame(Words({5, 7, 4, 3, 12}) + "abc", &frame), "");
  EXPECT_EQ(frame.oid, 7u);
  EXPECT_EQ(frame.selector, 4u);
  EXPECT_EQ(frame.reply_size, 12u);
  EXPECT_EQ(frame.bytes, "abc");
  EXPECT_EQ(DecodeProxyFrame(Words({1}) + std::string(64, 'x'), &frame), "");
  EXPECT_EQ(frame.name, std::string(63, 'x'));
}

TEST(ProxyWireTest, WhatNoSourceKnowsIsRefusedByName) {
  EXPECT_EQ(ErrorInFrame(""), "has the command 0, which no source names");
  EXPECT_EQ(ErrorInFrame(Words({9})), "has the command 9, which no source names");
  EXPECT_EQ(ErrorInFrame(Words({7})),
            "has the command 7 (SENDWITHRBOX), whose layout is not known and "
            "which is not carried");
  EXPECT_EQ(ErrorInFrame(Words({5, 7, 4})), "ends within the words of CALL");
  EXPECT_EQ(ErrorInFrame(Words({5, 7, 4, 0xffffffff, 0}) + "abc"),
            "has 3 bytes in a CALL that announces 4294967295; 256 is the limit");
  EXPECT_EQ(ErrorInFrame(Words({1}) + "short"),
            "has 5 bytes in a FIND that announces 64; 256 is the "
            "limit");
}

}  // namespace
}  // namespace openr_host
