// openr run --leaks, and blocks and regions that an object frees twice.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The program Greeter with `statements` in its DoStart, from line 20 of Greeter.cc on.
class Leaking {
 public:
  explicit Leaking(const std::string& statements) : folder_("handmade") {
    std::string source = folder_.Read("Greeter/Greeter.cc");
    const std::string last = "    OSYSPRINT((\"handmade: start\\n\"));\n";
    source.replace(source.find(last), last.size(), statements + "\n");
    source =
        "#include <MCOOP.h>\n#include <OPENR/OPENRAPI.h>\n#include <OPENR/RCRegion.h>\n"
        "#include <list>\n#include <vector>\nstatic void* kept;\n" +
        source;
    folder_.Write("Greeter/Greeter.cc", source);
    const ProgramResult built = folder_.Build({"--debug"});
    EXPECT_EQ(built.status, 0) << built.err;
  }

  ProgramResult Run(const std::vector<std::string>& flags = {"--leaks"}) const {
    std::vector<std::string> words{"run",    "--stick", folder_.File("MS"), "--for",     "100ms",
                                   "--rate", "max",     "--no-panel",       "--rc-port", "0"};
    words.insert(words.end(), flags.begin(), flags.end());
    return RunProgram(words);
  }

 private:
  const KitFolder folder_;
};

#if !defined(__SANITIZE_ADDRESS__)  // objects have no heaps of their own with AddressSanitizer

TEST(LeaksTest, BlocksThatNothingPointsToAreNamedWithTheirLine) {
  const Leaking program(
      "    for (int i = 0; i < 40; i++) { int* volatile lost = new int[25]; (void)lost; }");
  const ProgramResult result = program.Run();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: greeter (message "));
  EXPECT_THAT(result.err,
              HasSubstr("leak: 40 blocks of 4480 bytes, made at Greeter.cc:20: nothing points to "
                        "them any more"));
}

TEST(LeaksTest, WithoutTheFlagTheRunSaysNothing) {
  const Leaking program("    int* volatile lost = new int[25]; (void)lost;");
  const ProgramResult result = program.Run({});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("leak")));
}

TEST(LeaksTest, WhatIsStillInReachIsNoLeak) {
  const Leaking program(
      "    static std::list<std::vector<int> > all;\n"
      "    for (int i = 0; i < 9; i++) all.push_back(std::vector<int>(100));\n"
      "    char* inside = new char[900]; kept = inside + 300;\n"
      "    static RCRegion* region; region = new RCRegion(100);\n"
      "    static MemoryRegionID id; OSoundVectorData* sound; OPENR::NewSoundVectorData(1, 10, "
      "&id, &sound);\n"
      "    void* mine; NewRegion(500, &mine); *(void**)mine = new char[77];");
  const ProgramResult result = program.Run();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("no leaks of blocks or regions were found"));
}

TEST(LeaksTest, AListThatLosesItsHeadIsLostAsAWhole) {
  const Leaking program(
      "    void** head = 0;\n"
      "    for (int i = 0; i < 6; i++) { void** one = new void*[2]; one[0] = head; head = one; }");
  EXPECT_THAT(program.Run().err, HasSubstr("leak: 6 blocks of 96 bytes, made at Greeter.cc:21"));
}

TEST(LeaksTest, RegionsThatNobodyHoldsAreNamedWithTheirLine) {
  const Leaking program(
      "    for (int i = 0; i < 5; i++) { RCRegion* volatile lost = new RCRegion(100); (void)lost; "
      "}\n"
      "    for (int i = 0; i < 3; i++) { MemoryRegionID id; OSoundVectorData* sound;\n"
      "        OPENR::NewSoundVectorData(1, 10, &id, &sound); }");
  const ProgramResult result = program.Run();
  EXPECT_THAT(result.err, HasSubstr("leak: 5 regions of 500 bytes, made at Greeter.cc:20"));
  EXPECT_THAT(result.err, HasSubstr("leak: 3 regions of "));
  EXPECT_THAT(result.err, HasSubstr("made at Greeter.cc:22"));
}

TEST(LeaksTest, ABlockFreedTwiceIsAFindingAndTheHeapStaysWhole) {
  const Leaking program(
      "    char* volatile block = new char[10]; delete[] block; delete[] block;\n"
      "    void* a = new char[10]; void* b = new char[10];\n"
      "    OSYSPRINT((a == b ? \"same\\n\" : \"two blocks\\n\"));");
  const ProgramResult result = program.Run({});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("error: greeter (message "));
  EXPECT_THAT(result.err, HasSubstr("DoStart: a block is freed that was freed before, at "
                                    "Greeter.cc:20: on the robot this damages the heap"));
  EXPECT_THAT(result.err, HasSubstr("two blocks"));
}

TEST(LeaksTest, AnAddressInsideABlockCannotBeFreed) {
  const Leaking program(
      "    char* volatile block = new char[100]; free(block + 16); delete[] block;");
  const ProgramResult result = program.Run({});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("DoStart: an address is freed that no block begins at, at "
                                    "Greeter.cc:20"));
}

TEST(LeaksTest, MemoryOfAnObjectOutsideOfItsHeapCannotBeFreed) {
  const Leaking program(
      "    static char fixed[100]; char local[100];\n"
      "    void* volatile block = fixed; free(block);\n"
      "    block = local; free(block);\n"
      "    block = (void*)\"text\"; free(block);\n"
      "    RCRegion* region = new RCRegion(100); block = region->Base(); free(block);\n"
      "    block = fixed; OSYSPRINT((realloc(block, 200) == 0 ? \"no block\\n\" : \"moved\\n\"));");
  const ProgramResult result = program.Run({});
  EXPECT_EQ(result.status, 1);
  for (int line = 21; line <= 25; ++line) {
    EXPECT_THAT(result.err,
                HasSubstr("DoStart: an address is freed that no block begins at, at Greeter.cc:" +
                          std::to_string(line)));
  }
  EXPECT_THAT(result.err, HasSubstr("no block\n"));
}

TEST(LeaksTest, AStreamThatIsNotOpenCannotBeClosed) {
  const Leaking program(
      "    FILE* volatile file = fopen(\"/MS/OPEN-R/MW/CONF/OBJECT.CFG\", \"r\");\n"
      "    int first = fclose(file);\n"
      "    int second = fclose(file);\n"
      "    file = fmemopen(0, 100, \"w\");\n"
      "    OSYSPRINT((\"closed %d %d %d\\n\", first, second, fclose(file)));");
  const ProgramResult result = program.Run({});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("DoStart: fclose() of a stream that is not open, at "
                                    "Greeter.cc:22"));
  EXPECT_THAT(result.err, HasSubstr("closed 0 -1 0\n"));
}

TEST(LeaksTest, ARegionDeletedTwiceIsAWarning) {
  const Leaking program(
      "    MemoryRegionID id; void* base;\n"
      "    NewSharedMemoryRegion(100, MEMPROTINFO_RW, &id, &base);\n"
      "    DeleteSharedMemoryRegion(id); DeleteSharedMemoryRegion(id);\n"
      "    DeleteSharedMemoryRegion(0x70007);");
  const ProgramResult result = program.Run({});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err,
              HasSubstr("DoStart: region 0x10001 is deleted that was deleted before, at "
                        "Greeter.cc:22"));
  EXPECT_THAT(result.err, Not(HasSubstr("0x70007")));
}

TEST(LeaksTest, TheExamplesLoseNothing) {
  const std::string examples = std::string(OPENR_KIT_FIXTURES) + "/../../../examples";
  for (const char* const name : {"BallChaser", "Camera", "Ears", "HttpServer", "Lights",
                                 "ManyToMany", "Sensors", "StandUp", "TalkListen", "Tone"}) {
    SCOPED_TRACE(name);
    const KitFolder folder("");
    std::filesystem::copy(examples + "/" + name, folder.File(""),
                          std::filesystem::copy_options::recursive);
    const ProgramResult built = folder.Build();
    ASSERT_EQ(built.status, 0) << built.err;
    const ProgramResult result =
        RunProgram({"run", "--stick", folder.File("MS"), "--leaks", "--for", "3s", "--rate", "max",
                    "--no-panel", "--rc-port", "0", "--body", "ideal"});
    EXPECT_THAT(result.err, HasSubstr("no leaks of blocks or regions were found"));
    EXPECT_THAT(result.err, Not(HasSubstr("freed")));
  }
}

TEST(LeaksTest, TheObjectsOfTheDefaultStickLoseNothing) {
  const ProgramResult result = RunProgram(
      {"run", "--leaks", "--for", "5s", "--rate", "max", "--no-panel", "--rc-port", "0"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("no leaks of blocks or regions were found"));
}

#endif

}  // namespace
}  // namespace openr_host
