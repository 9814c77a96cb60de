// The copies of images in the temporary folder of a run.
#include "runtime/core/run_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

// Adds a copy of an image with the bytes `original`, loads `changed` from it, so to speak, and puts
// the original back.  Returns the path of the copy.
std::string CopyOf(RunFolder* folder, const std::string& original, const std::string& changed) {
  std::string problem;
  const std::string copy = folder->AddCopy("OBJECT.BIN", original, &problem);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(folder->WriteCopy(copy, changed), "");
  EXPECT_EQ(ReadFileOrThrow(copy), changed);
  folder->RestoreOriginal(copy);
  return copy;
}

TEST(RunFolderTest, TheOriginalTakesThePlaceOfTheCopy) {
  RunFolder folder;
  EXPECT_EQ(ReadFileOrThrow(CopyOf(&folder, "original", "changed")), "original");
}

TEST(RunFolderTest, RobotsWithTheSameImageShareItsOriginal) {
  RunFolder folder;
  const std::string first = CopyOf(&folder, "original", "for the first robot");
  const std::string second = CopyOf(&folder, "original", "for the second robot");
  const std::string other = CopyOf(&folder, "another image", "for the third robot");
  EXPECT_NE(first, second);
  EXPECT_TRUE(std::filesystem::equivalent(first, second));
  EXPECT_FALSE(std::filesystem::equivalent(first, other));
  EXPECT_EQ(ReadFileOrThrow(first), "original");
  EXPECT_EQ(ReadFileOrThrow(second), "original");
  EXPECT_EQ(ReadFileOrThrow(other), "another image");
}

// A load that fails leaves the changed copy where it was.
TEST(RunFolderTest, ACopyThatWasNotRestoredIsNoOriginalOfTheNextRobot) {
  RunFolder folder;
  std::string problem;
  const std::string copy = folder.AddCopy("OBJECT.BIN", "original", &problem);
  EXPECT_EQ(folder.WriteCopy(copy, "changed"), "");
  EXPECT_EQ(ReadFileOrThrow(CopyOf(&folder, "original", "changed again")), "original");
  EXPECT_EQ(ReadFileOrThrow(copy), "changed");
}

}  // namespace
}  // namespace openr_host
