// Tests of the changes that the fuzzer makes to its inputs.
#include "tests/fuzz/mutate.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

namespace openr_host {
namespace {

std::set<std::string> ManyMutations(const std::string& text) {
  std::set<std::string> found;
  FuzzRandom random(1);
  for (int i = 0; i < 5000; ++i) found.insert(MutateText(text, &random));
  return found;
}

TEST(MutateTest, AWordIsRenamedInAllItsPlaces) {
  EXPECT_TRUE(ManyMutations("abc.S abc.O\n").contains("a.S a.O\n"));
}

TEST(MutateTest, ANumberGetsANearValue) {
  EXPECT_TRUE(ManyMutations("port 54300\n").contains("port 54301\n"));
}

TEST(MutateTest, LinesAreCopiedRemovedAndMoved) {
  const std::set<std::string> found = ManyMutations("a 1\nb 2\n");
  EXPECT_TRUE(found.contains("a 1\nb 2\na 1\n"));
  EXPECT_TRUE(found.contains("b 2\n"));
  EXPECT_TRUE(found.contains("b 2\na 1\n"));
}

TEST(MutateTest, ControlCharactersAreNoText) {
  EXPECT_TRUE(IsText("a 1\r\n\tb \xe4\n"));
  EXPECT_FALSE(IsText("OMTN\x01"));
  EXPECT_FALSE(IsText(std::string("a\0b", 3)));
}

TEST(MutateTest, BytesWithoutWordsStayAsTheyAre) {
  FuzzRandom random(1);
  EXPECT_EQ(MutateText("\x01\x02", &random), "\x01\x02");
  EXPECT_EQ(MutateText("", &random), "");
}

TEST(MutateTest, ANumberOfFewBytesIsChanged) {
  std::set<std::string> found;
  FuzzRandom random(1);
  for (int i = 0; i < 5000; ++i) found.insert(MutateNumber("\x05\x07", &random));
  EXPECT_TRUE(found.contains("\x01\x01"));  // 257
  EXPECT_TRUE(found.contains("\x06\x07"));
  EXPECT_TRUE(found.contains("\x05\x4d"));
  EXPECT_EQ(MutateNumber("", &random), "");
}

TEST(MutateTest, ASecondInputIsPutBehindTheFirst) {
  std::set<std::string> found;
  FuzzRandom random(1);
  for (int i = 0; i < 100; ++i) found.insert(JoinTexts("a\n", "b\n", &random));
  EXPECT_EQ(found, (std::set<std::string>{"a\nb\n", "b\na\n"}));
}

TEST(MutateTest, TheChecksumsOfARecordingAreMadeRight) {
  std::ifstream in(OPENR_SOURCE_DIR "/tests/openr/data/version3.rec", std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::string changed = good;
  FixRecording(&changed);
  EXPECT_EQ(changed, good);
  changed.back() = static_cast<char>(changed.back() ^ 1);
  const std::string damaged = changed;
  FixRecording(&changed);
  EXPECT_NE(changed, damaged);
}

TEST(MutateTest, CompressedBytesAreTheSameAfterwards) {
  const std::string text(1000, 'x');
  EXPECT_LT(Compress(text).size(), 100u);
  EXPECT_EQ(Decompress(Compress(text)), text);
  EXPECT_EQ(Decompress("no gzip file"), "");
}

}  // namespace
}  // namespace openr_host
