#include "kit/makefile_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "kit/image_match.h"
#include "kit/referred_places.h"
#include "runtime/base/temp_folder.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;

TEST(MakefileTextTest, AbsolutePathsOfAnSdkAreReplaced) {
  EXPECT_EQ(AdaptMakefile("CXX=/opt/sony/sdk/bin/mipsel-linux-g++\n"
                          "INC=-I/opt/sony/sdk/OPEN_R/include -I/opt/sony/sdk2\n"
                          "ROOT ?= /usr/local/OPEN_R_SDK\n",
                          "/kit"),
            "CXX=/kit/bin/mipsel-linux-g++\n"
            "INC=-I/kit/OPEN_R/include -I/opt/sony/sdk2\n"
            "ROOT ?= /kit\n");
}

TEST(MakefileTextTest, LinesEndAsMakeWantsThem) {
  EXPECT_EQ(AdaptMakefile("all:\r\n\ttrue\r\n", "/kit"), "all:\n\ttrue\n");
}

TEST(MakefileTextTest, PathsBehindVariablesStay) {
  const std::string text = "CXX=$(TOP)/sdk/bin/mipsel-linux-g++ $(HOME)/OPEN_R_SDK\n";
  EXPECT_EQ(AdaptMakefile(text, "/kit"), text);
}

TEST(MakefileTextTest, VariablesForTheSdkAreKnownByTheirUse) {
  const auto variables = SdkVariables(
      "SONY = $(HOME)/sony\nTOOLS=$(SONY)/x\nINC = ${SONY}/OPEN_R/include\n"
      "CXX = $(TOOLS)/mipsel-linux-g++\nMK = $(OBIN)/mkbin\nOTHER = $(STICK)/OPEN-R\n");
  ASSERT_EQ(variables.size(), 3u);
  EXPECT_EQ(variables[0].name, "SONY");
  EXPECT_EQ(variables[0].folder, "");
  EXPECT_THAT(variables[0].values, ElementsAre("$(HOME)/sony"));
  EXPECT_EQ(variables[1].name, "TOOLS");
  EXPECT_EQ(variables[1].folder, "/bin");
  EXPECT_EQ(variables[2].name, "OBIN");
  EXPECT_EQ(variables[2].folder, "/OPEN_R/bin");
  EXPECT_FALSE(variables[2].is_defined);
}

TEST(MakefileTextTest, VariablesForTheStickAreKnownByTheirUse) {
  const auto variables = StickVariables("MS ?= ../MS  # here\n\tcp x $(MS)/OPEN-R/MW/OBJS/X.BIN\n");
  ASSERT_EQ(variables.size(), 1u);
  EXPECT_EQ(variables[0].name, "MS");
  EXPECT_THAT(variables[0].values, ElementsAre("../MS"));
}

TEST(MakefileTextTest, AStickElsewhereBecomesTheOneOfTheCopy) {
  EXPECT_EQ(
      AdaptMakefile("D=/mnt/ms/OPEN-R/MW\n\tcp a /mnt/ms/OPEN-R/x; echo /MS/OPEN-R/MW\n", "/k"),
      "D=${OPENR_KIT_STICK}/OPEN-R/MW\n\tcp a ${OPENR_KIT_STICK}/OPEN-R/x; echo "
      "/MS/OPEN-R/MW\n");
  EXPECT_EQ(AdaptMakefile("X=$(TOP)/ms/OPEN-R ../MS/OPEN-R\n", "/k"),
            "X=$(TOP)/ms/OPEN-R ../MS/OPEN-R\n");
}

TEST(MakefileTextTest, InstalledImagesAreNamed) {
  EXPECT_THAT(InstalledImages("\tgzip -c a.bin > $(D)/OPEN-R/MW/OBJS/HELLO.BIN\n"
                              "\trm -f $(D)/OPEN-R/MW/OBJS/HELLO.BIN $(OBJS)/$(NAME).BIN\n"),
              ElementsAre("HELLO.BIN"));
}

TEST(MakefileTextTest, PathsThatLeadUpwardAreFound) {
  EXPECT_THAT(
      UpwardPaths("-I../common ../../lib/x.mk $(TOP)/../no a/../b\n#include \"../h/x.h\"\n"),
      ElementsAre("../common", "../../lib/x.mk", "../h/x.h"));
}

// Returns a path of 100,000 characters: "BEGIN/ab/ab...".
std::string LongPath(const std::string& begin) {
  std::string path = begin;
  while (path.size() < 100'000) path += "/ab";
  return path;
}

TEST(MakefileTextTest, WordsThatAreTooLongForAPathStay) {
  const std::string data = LongPath("/opt/sdk/OPEN_R");
  EXPECT_EQ(AdaptMakefile("CXX=/opt/sdk/bin/mipsel-linux-g++\n" + data + "\nI=/opt/sdk/OPEN_R/x\n" +
                              data + " /mnt/ms/OPEN-R/MW",
                          "/kit"),
            "CXX=/kit/bin/mipsel-linux-g++\n" + data + "\nI=/kit/OPEN_R/x\n" + data +
                " ${OPENR_KIT_STICK}/OPEN-R/MW");
  EXPECT_THAT(UpwardPaths("../a " + LongPath("..") + " ../b"), ElementsAre("../a", "../b"));
  EXPECT_THAT(InstalledImages("OBJS/A.BIN " + LongPath("OBJS/") + ".BIN OBJS/" +
                              std::string(100'000, 'x') + ".BIN OBJS/B.BIN"),
              ElementsAre("A.BIN", "B.BIN"));
  const auto variables = SdkVariables("S = /sdk\n" + LongPath("$(L)") + "\n$(S)/OPEN_R/lib\n");
  ASSERT_EQ(variables.size(), 1u);
  EXPECT_EQ(variables[0].name, "S");
}

TEST(MakefileTextTest, AValueMayBeLong) {
  std::string value = "a.o";
  while (value.size() < 100'000) value += " a.o";
  EXPECT_TRUE(IsDefinedIn("OBJS = " + value + "\n", "OBJS"));
  const auto variables = StickVariables("MS := " + value + " # here\n$(MS)/OPEN-R/MW\n");
  ASSERT_EQ(variables.size(), 1u);
  EXPECT_THAT(variables[0].values, ElementsAre(value));
}

TEST(MakefileTextTest, MakefilesWithLongLinesAreFollowed) {
  const TempFolder folder;
  const std::filesystem::path root(folder.path());
  std::filesystem::create_directories(root / "program");
  std::filesystem::create_directories(root / "common");
  std::string include = "include";
  while (include.size() < 100'000) include += " none.mk";
  std::ofstream(root / "program/Makefile")
      << LongPath("LONG=") << "\nLONG =" << LongPath("") << "\nC = ../common\n"
      << include << " ../common/rules.mk\n-I$(C)\n";
  EXPECT_THAT(FindReferredPlaces(root / "program").folders,
              ElementsAre(root / "program", root / "common"));
}

TEST(ImageMatchTest, EqualNamesGoFirstThenBeginningsThenLettersThenTheRest) {
  const std::vector<ImageCandidate> candidates = {
      {{"ballTracker"}}, {{"hello", "HelloWorld"}}, {{"blinkingLED"}}, {{"zebra"}}};
  EXPECT_THAT(MatchImages({"HELLO.BIN", "BLNKLED.BIN", "BALLTRAC.BIN", "OTHER.BIN"}, candidates),
              ElementsAre(1, 2, 0, 3));
}

TEST(ImageMatchTest, WhatFitsTwiceIsNotGuessed) {
  EXPECT_THAT(MatchImages({"MOVE.BIN"}, {{{"moverA"}}, {{"moverB"}}}), ElementsAre(-1));
  EXPECT_THAT(MatchImages({"SAMPLE1.BIN", "SAMPLE2.BIN"}, {{{"sample"}}}), ElementsAre(-1, -1));
}

TEST(ImageMatchTest, ShortNamesFitTheStick) {
  EXPECT_EQ(ShortImageName("ball_Tracker"), "BALLTRAC.BIN");
  EXPECT_EQ(ShortImageName("x"), "X.BIN");
}

}  // namespace
}  // namespace openr_host
