// Tests of the changes that the fuzzer makes to its inputs.
#include "tests/fuzz/mutate.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/mutate_json.h"
#include "tests/fuzz/mutate_steps.h"

namespace openr_host {
namespace {

std::set<std::string> ManyMutations(const std::string& text, const FuzzWords& words = {}) {
  std::set<std::string> found;
  FuzzRandom random(1);
  for (int i = 0; i < 5000; ++i) found.insert(MutateText(text, words, &random));
  return found;
}

std::set<std::string> ManyPrograms(const std::string& program, const FuzzStarts& starts) {
  std::set<std::string> found;
  FuzzRandom random(1);
  for (int i = 0; i < 5000; ++i) found.insert(MutateSteps(program, starts, &random));
  return found;
}

std::set<std::string> ManyParts(const std::string& input) {
  std::set<std::string> found;
  FuzzRandom random(1);
  for (int i = 0; i < 5000; ++i) found.insert(MutateParts(input, {}, &random));
  return found;
}

TEST(MutateTest, AWordIsRenamedInAllItsPlaces) {
  EXPECT_TRUE(ManyMutations("abc.S abc.O\n").contains("a.S a.O\n"));
}

TEST(MutateTest, ANumberGetsANearValue) {
  EXPECT_TRUE(ManyMutations("port 54300\n").contains("port 54301\n"));
}

TEST(MutateTest, ANumberIsMultipliedAndKeepsItsUnit) {
  const std::set<std::string> found = ManyMutations("within 7s");
  EXPECT_TRUE(found.contains("within 35s"));
  EXPECT_TRUE(found.contains("within 8s"));
}

TEST(MutateTest, AHexadecimalNumberStaysAsLong) {
  EXPECT_TRUE(ManyMutations("cause: 0x00000010").contains("cause: 0x00000030"));
}

TEST(MutateTest, AWordOfTheDictionaryTakesThePlaceOfAWord) {
  EXPECT_TRUE(ManyMutations("{\"do\":\"step\"}", {"act"}).contains("{\"do\":\"act\"}"));
}

TEST(MutateTest, ASymbolTakesThePlaceOfAnother) {
  const std::set<std::string> found = ManyMutations("a == 1\nb < 2\n", {"!=", "from"});
  EXPECT_TRUE(found.contains("a < 1\nb < 2\n"));
  EXPECT_TRUE(found.contains("a == 1\nb != 2\n"));
}

TEST(MutateTest, TheNumbersOfAColumnAreMultiplied) {
  const std::set<std::string> found = ManyMutations("n,ms,deg\n0,0,1.5\n1,160,2\r\n2,320,3");
  EXPECT_TRUE(found.contains("n,ms,deg\n0,0,1.5\n1,480,2\r\n2,960,3"));
  EXPECT_TRUE(ManyMutations("a 1\nb\nc 3\n").contains("a 2\nb\nc 6\n"));
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
  EXPECT_EQ(MutateText("\x01\x02", {}, &random), "\x01\x02");
  EXPECT_EQ(MutateText("", {}, &random), "");
}

TEST(MutateTest, ATextBetweenOtherBytesIsChangedAndTheBytesBehindItStay) {
  const auto input = [](std::string text) {
    text.resize(14);
    return "\x01" + text + "\x02";
  };
  std::set<std::string> found;
  FuzzRandom random(1);
  for (int i = 0; i < 5000; ++i) found.insert(MutateTextIn(input("object a 128"), {}, &random));
  EXPECT_TRUE(found.contains(input("object a 127")));
  EXPECT_TRUE(found.contains(input("object a 5")));
  EXPECT_TRUE(found.contains(input("object a 1280")));  // over a NUL
}

TEST(MutateTest, ATextAtTheEndOfOtherBytesDoesNotGrow) {
  std::set<std::string> found;
  FuzzRandom random(1);
  for (int i = 0; i < 5000; ++i) found.insert(MutateTextIn("\x01object 16", {}, &random));
  EXPECT_TRUE(found.contains("\x01object 17"));
  EXPECT_TRUE(found.contains("\x01object 12"));  // the first two digits of 128
  for (const std::string& bytes : found) EXPECT_EQ(bytes.size(), 10u);
}

TEST(MutateTest, ShortTextsBetweenOtherBytesStayAsTheyAre) {
  FuzzRandom random(1);
  EXPECT_EQ(MutateTextIn("\x01x 12345\x02", {}, &random), "\x01x 12345\x02");
  EXPECT_EQ(MutateTextIn("", {}, &random), "");
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

TEST(MutateStepsTest, StepsAreCopiedRemovedAndMoved) {
  const std::set<std::string> found = ManyPrograms("aBBcccc", {0, 1, 3});
  EXPECT_TRUE(found.contains("aaBBcccc"));
  EXPECT_TRUE(found.contains("acccc"));
  EXPECT_TRUE(found.contains("BBacccc"));
  EXPECT_TRUE(found.contains("aBBccccaBBcccc"));
}

TEST(MutateStepsTest, AByteOfAStepIsChanged) {
  const std::set<std::string> found = ManyPrograms("aBBcccc", {0, 1, 3});
  EXPECT_TRUE(found.contains("aBDcccc"));
  EXPECT_TRUE(found.contains("aBBccc#"));
}

// The target dds_message runs its input twice, so it notes each step twice.
TEST(MutateStepsTest, StepsThatAreNotedTwiceCountOnce) {
  EXPECT_EQ(ManyPrograms("aBBcccc", {0, 1, 3, 0, 1, 3}), ManyPrograms("aBBcccc", {0, 1, 3}));
}

TEST(MutateStepsTest, AProgramWithoutStepsStaysAsItIs) {
  EXPECT_EQ(ManyPrograms("abc", {}), std::set<std::string>{"abc"});
  EXPECT_EQ(ManyPrograms("", {0}), std::set<std::string>{""});
}

TEST(MutateStepsTest, StepsOfASecondProgramArePutBetween) {
  std::set<std::string> found;
  FuzzRandom random(1);
  for (int i = 0; i < 1000; ++i) {
    found.insert(JoinSteps("aBB", {0, 1}, "cDDD", {0, 1}, &random));
  }
  EXPECT_TRUE(found.contains("aDDDBB"));
  EXPECT_TRUE(found.contains("aBBcDDD"));
  EXPECT_TRUE(found.contains("caBB"));
  EXPECT_EQ(JoinSteps("aBB", {0, 1}, "", {}, &random), "aBB");
}

TEST(MutateStepsTest, ATargetNotesItsSteps) {
  FuzzStarts starts;
  NoteFuzzSteps(&starts);
  FindFuzzTarget("panel_websocket")->run(std::string("\0\2\0ab\1\1\0c", 9));
  NoteFuzzSteps(nullptr);
  EXPECT_EQ(starts, (FuzzStarts{0, 5}));
  FindFuzzTarget("panel_websocket")->run("abc");
  EXPECT_EQ(starts.size(), 2u);
}

uint64_t noted_state = 0;

// Returns the state that the target `name` notes for `input`; 0 if it notes none.
uint64_t StateOf(const char* name, const std::string& input) {
  noted_state = 0;
  NoteFuzzStates([](uint64_t state) { noted_state = state; });
  FindFuzzTarget(name)->run(input);
  NoteFuzzStates(nullptr);
  return noted_state;
}

TEST(FuzzStatesTest, EachCommandThatServeAcceptsIsAState) {
  const uint64_t run = StateOf("serve", R"({"do":"run","for_s":1.5})");
  EXPECT_NE(run, 0u);
  EXPECT_NE(StateOf("serve", R"({"do":"step","count":2})"), run);
  EXPECT_EQ(StateOf("serve", R"({"do":"step","frames":2})"), 0u);
  EXPECT_NE(StateOf("serve", R"({"do":"act","frames":2})"), StateOf("serve", R"({"do":"act"})"));
}

TEST(FuzzStatesTest, FilesOnTheStickOfTheRemoteControlAreAState) {
  const uint64_t before = StateOf("remote_control", "");
  const std::string begin("\x40\0", 2), data("\x40\1"), end("\x40\5");
  std::string upload = begin + data;
  EXPECT_EQ(StateOf("remote_control", upload), before);
  for (int part = 1; part < 8; ++part) upload += data;
  EXPECT_NE(StateOf("remote_control", upload + end), before);
  EXPECT_EQ(StateOf("remote_control", ""), before);
}

TEST(FuzzStatesTest, SetsThatReachTheRobotAndConnectionsOfTheGatewayAreAState) {
  const std::string connect("\x10\xd0\xd0\xa0\0\xd0", 6), one_item("\x50\1\1a\xd0", 5);
  const uint64_t before = StateOf("gateway", "");
  const uint64_t connected = StateOf("gateway", connect);
  EXPECT_NE(connected, before);
  EXPECT_NE(StateOf("gateway", connect + one_item), connected);
  EXPECT_EQ(StateOf("gateway", one_item), before);
}

TEST(FuzzStatesTest, TheSizeOfAPictureIsAState) {
  const std::string pixels(12, 'x');
  EXPECT_NE(StateOf("camera_picture", "P6 2 2 255\n" + pixels), 0u);
  EXPECT_NE(StateOf("camera_picture", "P6 4 1 255\n" + pixels),
            StateOf("camera_picture", "P6 2 2 255\n" + pixels));
  EXPECT_EQ(StateOf("camera_picture", "P6 3 3 255\n" + pixels), 0u);  // some pixels are missing
}

TEST(FuzzStatesTest, TheNumberOfFunctionsThatAreCalledIsAState) {
  std::ifstream in(OPENR_FUZZ_FOLDER "/corpus/gateway_wire/call", std::ios::binary);
  const std::string call{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  constexpr size_t kSelectorAt = 1 + 5 * 4;  // behind the size of the piece and five words
  std::string other = call;
  other[kSelectorAt] = static_cast<char>(other[kSelectorAt] + 1);
  EXPECT_EQ(StateOf("gateway_wire", call), 1u);
  EXPECT_EQ(StateOf("gateway_wire", call + call), 1u);
  EXPECT_EQ(StateOf("gateway_wire", call + other), 2u);
}

TEST(FuzzStatesTest, WhatAnAcceptedImageSaysIsAState) {
  const std::string folder = OPENR_FUZZ_FOLDER "/corpus/image/";
  std::ifstream in(folder + "small.bin", std::ios::binary);
  const std::string image{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::string other = image;
  other.replace(other.find(" 128 "), 5, " 255 ");
  EXPECT_NE(StateOf("image", image), 0u);
  EXPECT_NE(StateOf("image", other), StateOf("image", image));
  EXPECT_NE(StateOf("image", Compress(image)), StateOf("image", image));
  other.replace(other.find("object"), 6, "OBJECT");
  EXPECT_EQ(StateOf("image", other), 0u);
}

TEST(FuzzStatesTest, StatesAreNotNotedWithoutAListener) {
  noted_state = 0;
  FindFuzzTarget("remote_control")->run("");
  EXPECT_EQ(noted_state, 0u);
}

TEST(MutateJsonTest, JsonStaysJson) {
  std::set<std::string> found;
  FuzzRandom random(1);
  for (int i = 0; i < 5000; ++i) {
    found.insert(MutateJson("{\"do\": \"step\", \"list\": [2, true]}", {"act"}, &random));
  }
  EXPECT_FALSE(found.contains(""));
  EXPECT_TRUE(found.contains("{\"do\":\"act\",\"list\":[2,true]}"));
  EXPECT_TRUE(found.contains("{\"do\":\"step\",\"list\":[77,true]}"));
  EXPECT_TRUE(found.contains("{\"do\":\"step\",\"list\":[2,false]}"));
  EXPECT_TRUE(found.contains("{\"do\":\"step\",\"list\":[2,2,true]}"));
  EXPECT_TRUE(found.contains("{\"do\":\"step\",\"act\":[2,true]}"));
  EXPECT_TRUE(found.contains("{\"list\":[2,true]}"));
}

TEST(MutateJsonTest, OnlyWholeJsonThatIsFlatIsJson) {
  EXPECT_TRUE(IsJson("{\"do\": [1, \"step\"]}"));
  EXPECT_FALSE(IsJson("{\"do\": [1"));
  EXPECT_FALSE(IsJson(std::string(60, '[') + std::string(60, ']')));
}

TEST(MutateJsonTest, OtherBytesAreLeftToOthers) {
  FuzzRandom random(1);
  EXPECT_EQ(MutateJson("{\"do\"", {}, &random), "");
  EXPECT_EQ(MutateJson(std::string(60, '[') + std::string(60, ']'), {}, &random), "");
}

TEST(MutatePartsTest, ATextIsChangedAndItsSizeIsRight) {
  EXPECT_TRUE(ManyParts(std::string("\1\4\0id:7", 7)).contains(std::string("\1\5\0id:77", 8)));
}

TEST(MutatePartsTest, PartsAreDividedAndJoined) {
  const std::string whole("\1\4\0id:7", 7), divided("\0\2\0id\1\2\0:7", 10);
  EXPECT_TRUE(ManyParts(whole).contains(divided));
  EXPECT_TRUE(ManyParts(divided).contains(whole));
}

TEST(MutatePartsTest, AnInputWithoutPartsStaysAsItIs) {
  EXPECT_EQ(ManyParts("ab"), std::set<std::string>{"ab"});
}

}  // namespace
}  // namespace openr_host
