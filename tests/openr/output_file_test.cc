#include "openr/output_file.h"

#include <gtest/gtest.h>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

TEST(OutputFileTest, LookingAtAFileChangesNothing) {
  const ScratchFolder folder;
  folder.Write("old.json", "{}");
  EXPECT_EQ(WhyNotWritable(folder.File("old.json")), "");
  EXPECT_EQ(folder.Read("old.json"), "{}");
  EXPECT_EQ(WhyNotWritable(folder.File("new.json")), "");
  EXPECT_FALSE(std::filesystem::exists(folder.File("new.json")));
}

TEST(OutputFileTest, AFolderIsNoFile) {
  const ScratchFolder folder;
  EXPECT_EQ(WhyNotWritable(folder.path()), folder.path() + ": is a folder; name a file");
}

TEST(OutputFileTest, AFolderThatIsMissingIsNotMade) {
  const ScratchFolder folder;
  const std::string file = folder.File("none/a.json");
  EXPECT_EQ(WhyNotWritable(file), file + ": cannot be written: there is no such folder");
}

TEST(OutputFileTest, ALinkToAFileOfTheFutureIsGoodAndStays) {
  const ScratchFolder folder;
  std::filesystem::create_symlink(folder.File("future"), folder.File("link"));
  EXPECT_EQ(WhyNotWritable(folder.File("link")), "");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.File("link")));
  EXPECT_EQ(WriteFile(folder.File("link"), "now"), "");
  EXPECT_EQ(folder.Read("future"), "now");
}

TEST(OutputFileTest, AFullDiskIsReportedWithTheFile) {
  EXPECT_EQ(WriteFile("/dev/full", "text"),
            "/dev/full: cannot be written: No space left on device");
}

}  // namespace
}  // namespace openr_host
