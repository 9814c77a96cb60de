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

TEST(OutputFileTest, AFolderMayBeThereOrCanBeMade) {
  const ScratchFolder folder;
  EXPECT_EQ(WhyNoFolder(folder.path()), "");
  EXPECT_EQ(WhyNoFolder(folder.File("a/b/c")), "");
  EXPECT_FALSE(std::filesystem::exists(folder.File("a")));
}

TEST(OutputFileTest, WhatIsNoFolderIsSaidInWords) {
  const ScratchFolder folder;
  folder.Write("file", "");
  const std::string file = folder.File("file");
  EXPECT_EQ(WhyNoFolder(""), "'' names no folder");
  EXPECT_EQ(WhyNoFolder(file), file + ": is a file; name a folder");
  EXPECT_EQ(WhyNoFolder(file + "/a"), file + "/a: " + file +
                                          " is a file, so nothing can be in it; name another "
                                          "folder");
}

TEST(OutputFileTest, CommandsThatMakeFoldersSayItBeforeTheyBegin) {
  const ScratchFolder folder;
  folder.Write("file", "");
  const std::string file = folder.File("file");
  const std::vector<std::vector<std::string>> commands = {
      {"stick", "host", "-o"},
      {"stick", "robot", "-o"},
      {"controller", "build", folder.path(), "-o"},
      {"controller", "new", "wave"},
      {"build", folder.path(), "-o"},
      {"new", "Wave"}};
  for (std::vector<std::string> command : commands) {
    command.push_back(file);
    ProgramResult result = RunProgram(command);
    EXPECT_EQ(result.status, 2) << command[0] << " " << command[1];
    EXPECT_NE(result.err.find(file + ": is a file; name a folder\n"), std::string::npos)
        << result.err;
    command.back() = "";
    result = RunProgram(command);
    EXPECT_EQ(result.status, 2) << command[0] << " " << command[1];
    EXPECT_NE(result.err.find("'' names no folder\n"), std::string::npos) << result.err;
  }
}

TEST(OutputFileTest, AnErrorOfTheFileSystemIsSaidWithThePath) {
  std::error_code error = std::make_error_code(std::errc::no_space_on_device);
  EXPECT_EQ(Explain({"copying", "from", "to/it", error}), "to/it: no room is left on the disk");
  error = std::make_error_code(std::errc::not_a_directory);
  EXPECT_EQ(Explain({"making", "a/b", error}),
            "a/b: a part of this name is a file, where a folder has to be; name another place");
}

TEST(OutputFileTest, AFullDiskIsReportedWithTheFile) {
  EXPECT_EQ(WriteFile("/dev/full", "text"),
            "/dev/full: cannot be written: No space left on device");
}

}  // namespace
}  // namespace openr_host
