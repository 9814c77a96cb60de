// Tests of the bytes that measured.md describes in 1.25 to 1.29.
#include "runtime/gateway/gateway_stream.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace openr_host
