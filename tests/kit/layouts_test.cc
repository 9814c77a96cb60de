// openr check: a struct that is sent and that sender and receiver lay out in different ways.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/process.h"
#include "runtime/base/read_file.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kBoth[] = "longword number; char text[LINE_SIZE];";

// examples/TalkListen, in which Talker sends Listener a Line with number and text.
// All tests share a folder, because openr build then compiles only what a test has changed.
class LayoutsTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { folder_ = new KitFolder(""); }
  static void TearDownTestSuite() { delete folder_; }

  LayoutsTest() {
    namespace fs = std::filesystem;
    const fs::path example = std::string(OPENR_DOCS) + "/../examples/TalkListen";
    for (const auto& entry : fs::recursive_directory_iterator(example)) {
      const std::string name = entry.path().lexically_relative(example);
      if (entry.is_regular_file() && !name.starts_with("common/"))
        WriteIfChanged(name, ReadFile(entry.path()).value_or(""));
    }
    // Removes the images, because a test may have changed them.
    fs::remove_all(folder_->File("MS/OPEN-R/MW/OBJS"));
  }

  // Leaves a file with the same text alone, so that it does not count as newer than its object
  // file.
  static void WriteIfChanged(const std::string& name, const std::string& text) {
    if (folder_->Read(name) != text) folder_->Write(name, text);
  }

  // Writes the header of one object.
  void Declare(const std::string& object, const std::string& members) const {
    WriteIfChanged(object + "/Line.h",
                   "#include <Types.h>\n#include <stdint.h>\n"
                   "const size_t LINE_SIZE = 32;\nstruct Line { " +
                       members + " };\n");
  }
  void Replace(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = folder_->Read(file);
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << file;
    folder_->Write(file, text.replace(at, from.size(), to));
  }
  std::string Built() const {
    const ProgramResult built = folder_->Build();
    EXPECT_EQ(built.status, 0) << built.err;
    return Checked();
  }
  std::string Checked() const { return RunProgram({"check", folder_->File("")}).out; }
  std::string BuiltWith(const std::string& talker, const std::string& listener) const {
    Declare("Talker", talker);
    Declare("Listener", listener);
    return Built();
  }

  static inline const KitFolder* folder_ = nullptr;
};

TEST_F(LayoutsTest, FieldsInAnotherOrderAreAWarningWithTheirPlaces) {
  EXPECT_THAT(BuiltWith(kBoth, "char text[LINE_SIZE]; longword number;"),
              HasSubstr("CONNECT.CFG:2: warning: 'Line' is not the same struct in both images: "
                        "'text' begins at byte 4 in Talker, at byte 0 in Listener; include one "
                        "header in both objects, and build both"));
}

TEST_F(LayoutsTest, AFieldOfAnotherSizeIsAWarning) {
  EXPECT_THAT(BuiltWith(kBoth, "word number; char text[LINE_SIZE];"),
              HasSubstr("'number' has 4 bytes in Talker, 2 in Listener"));
}

TEST_F(LayoutsTest, AFieldThatNobodySendsIsAWarningUnlessTheObserverAsksForTheSize) {
  Replace("Listener/Listener.cc", "line->text));", "line->text));\n if (line->mood) return;");
  EXPECT_THAT(BuiltWith(kBoth, std::string(kBoth) + " longword mood;"),
              HasSubstr("Listener reads 'mood' at byte 36, and Talker sends 36 bytes"));
  Replace("Listener/Listener.cc", "if (line->mood)",
          "if (event.RCData(i)->Size() > 36 && line->mood)");
  EXPECT_THAT(Built(), Not(HasSubstr("same struct")));
}

// The header of the struct changed between the builds of the two objects.
TEST_F(LayoutsTest, AnImageOfAnOlderHeaderIsAWarning) {
  EXPECT_THAT(BuiltWith(kBoth, kBoth), Not(HasSubstr("same struct")));
  const std::string image = "MS/OPEN-R/MW/OBJS/LISTENER.BIN";
  const std::string old = folder_->Read(image);
  const std::string changed = "longword mood; longword number; char text[LINE_SIZE];";
  EXPECT_THAT(BuiltWith(changed, changed), Not(HasSubstr("same struct")));
  folder_->Write(image, old);
  EXPECT_THAT(Checked(), HasSubstr("'number' begins at byte 4 in Talker, at byte 0 in Listener"));
}

// OBJECT.CFG may list one image for several models.
TEST_F(LayoutsTest, ImagesOfTwoSectionsAreCompared) {
  BuiltWith(kBoth, "word number; char text[LINE_SIZE];");
  const std::string config = "MS/OPEN-R/MW/CONF/OBJECT.CFG";
  const std::string lines = folder_->Read(config);
  folder_->Write(config, "[ERS-210]\n" + lines + "[ERS-7]\n" + lines);
  EXPECT_THAT(Checked(), HasSubstr("'number' has 4 bytes in Talker, 2 in Listener"));
}

TEST_F(LayoutsTest, ALongTextWithoutASemicolonIsRead) {
  std::string table =
      "#define LINE_OF(e) ((const Line*)(e).Data(0))\nstatic const int table[] = {1";
  for (int i = 0; i < 100'000; ++i) table += ", 1";
  const std::string source = folder_->Read("Talker/Talker.cc");
  folder_->Write("Talker/Talker.cc", source + table + "};\nconst int* Table() { return table; }\n");
  EXPECT_THAT(BuiltWith(kBoth, "word number; char text[LINE_SIZE];"),
              HasSubstr("'number' has 4 bytes in Talker, 2 in Listener"));
}

// field-notes.md, 12.4.
TEST_F(LayoutsTest, AMemberThatHasFourBytesOnTheRobotIsANote) {
  const auto both = [&](const std::string& members) { return BuiltWith(members, members); };
  EXPECT_THAT(both("long number; char text[LINE_SIZE];"),
              HasSubstr("CONNECT.CFG:2: note: 'Line' has another size here than on the robot: in "
                        "'number', long int has 8 bytes instead of 4; sizes written as numbers do "
                        "not fit, and longword has 4 bytes on both"));
  EXPECT_THAT(both("struct { size_t at[2]; } place; int number; char text[LINE_SIZE];"),
              HasSubstr("in 'place', size_t has 8 bytes instead of 4"));
  EXPECT_THAT(both("int number; char text[LINE_SIZE]; Line* next;"),
              HasSubstr("in 'next', a pointer has 8 bytes instead of 4; sizes written as numbers "
                        "do not fit\n"));
  EXPECT_THAT(both("int64_t number; char text[LINE_SIZE]; longword far; double near;"),
              Not(HasSubstr("another size here")));
}

// ---- Programs that work on the robot

TEST_F(LayoutsTest, DataOfVariableLengthAreNoWarning) {
  EXPECT_THAT(BuiltWith(kBoth, "longword number; char text[256];"), Not(HasSubstr("same struct")));
  EXPECT_THAT(BuiltWith(kBoth, "longword number; char text[1];"), Not(HasSubstr("same struct")));
}

TEST_F(LayoutsTest, FieldsThatOneSideDoesNotUseAreNoWarning) {
  EXPECT_THAT(BuiltWith(std::string(kBoth) + " longword mood;", kBoth),
              Not(HasSubstr("same struct")));
  EXPECT_THAT(BuiltWith(kBoth, std::string(kBoth) + " longword mood;"),
              Not(HasSubstr("same struct")));
}

TEST_F(LayoutsTest, BytesAndTypesOfTheSameNameByChanceAreNoWarning) {
  // The listener takes bytes, and its Line is something of its own.
  Replace("Listener/Listener.cc", "const Line* line = (const Line*)event.Data(i);",
          "const byte* bytes = (const byte*)event.Data(i);\n        Line own = {{0}, bytes[0]};\n"
          "        const Line* line = &own;");
  EXPECT_THAT(BuiltWith(kBoth, "char text[LINE_SIZE]; longword number;"),
              Not(HasSubstr("same struct")));
  // The talker sends bytes, and the listener takes a Line.
  Replace("Listener/Listener.cc", "const Line* line = &own;", "line = (const Line*)event.Data(i);");
  Replace("Listener/Listener.cc", "Line own = {{0}, bytes[0]};", "const Line* line = 0;");
  Replace("Talker/Talker.cc", "SetData(&line, sizeof(line))", "SetData(line.text, 8)");
  EXPECT_THAT(Built(), Not(HasSubstr("same struct")));
}

TEST_F(LayoutsTest, AnImageWithoutDebugInformationIsNoWarning) {
  EXPECT_THAT(BuiltWith(kBoth, "char text[LINE_SIZE]; longword number;"), HasSubstr("same struct"));
  const std::string image = folder_->File("MS/OPEN-R/MW/OBJS/LISTENER.BIN");
  ASSERT_TRUE(RunProcess({"strip", "--strip-debug", image}).good());
  EXPECT_THAT(Checked(), Not(HasSubstr("same struct")));
}

// field-notes.md 3.9.  The robot has room for the array; the compiler of the time had not.
TEST_F(LayoutsTest, AMemberArrayOfTwoMegabytesIsANote) {
  Declare("Talker", kBoth);
  Declare("Listener", kBoth);
  Replace("Talker/Talker.h", "private:", "private:\n    char pictures_[2000000];\n");
  EXPECT_THAT(Built(), HasSubstr("Talker: note: 'pictures_' in class Talker has 2000000 bytes: the "
                                 "compiler of the first SDKs crashed at such a member"));
  Replace("Talker/Talker.h", "[2000000]", "[1999999]");
  EXPECT_THAT(Built(), Not(HasSubstr("crashed at such a member")));
}

}  // namespace
}  // namespace openr_host
