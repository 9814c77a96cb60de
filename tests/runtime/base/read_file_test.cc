#include "runtime/base/read_file.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>
#include <string>

#include "runtime/base/temp_folder.h"

namespace openr_host {
namespace {

TEST(FileReaderTest, PiecesAreFullUntilTheFileEnds) {
  const TempFolder folder;
  const std::string path = folder.path() + "/file";
  std::ofstream(path, std::ios::binary) << "abcdefgh";
  FileReader reader(path);
  ASSERT_TRUE(reader.is_open());
  std::string piece = "text from before";
  ASSERT_TRUE(reader.Read(5, &piece));
  EXPECT_EQ(piece, "abcde");
  ASSERT_TRUE(reader.Read(5, &piece));
  EXPECT_EQ(piece, "fgh");
  ASSERT_TRUE(reader.Read(5, &piece));
  EXPECT_EQ(piece, "");
}

TEST(FileReaderTest, FileThatIsMissingIsNotOpen) {
  const TempFolder folder;
  const FileReader reader(folder.path() + "/missing");
  EXPECT_FALSE(reader.is_open());
  EXPECT_EQ(errno, ENOENT);
}

TEST(FileReaderTest, FolderCannotBeRead) {
  const TempFolder folder;
  FileReader reader(folder.path());
  ASSERT_TRUE(reader.is_open());
  std::string piece;
  EXPECT_FALSE(reader.Read(5, &piece));
  EXPECT_EQ(errno, EISDIR);
}

TEST(ReadFileTest, FileOfTheGreatestSizeIsRead) {
  const TempFolder folder;
  const std::string path = folder.path() + "/file";
  std::ofstream(path, std::ios::binary) << "abcdefgh";
  EXPECT_EQ(ReadFile(path, 8), "abcdefgh");
}

TEST(ReadFileTest, LargerFileIsRefused) {
  const TempFolder folder;
  const std::string path = folder.path() + "/file";
  std::ofstream(path, std::ios::binary) << "abcdefgh";
  EXPECT_EQ(ReadFile(path, 7), std::nullopt);
  EXPECT_EQ(errno, EFBIG);
}

TEST(ReadFileTest, FileWithoutEndIsRefused) {
  EXPECT_EQ(ReadFile("/dev/zero", 100'000), std::nullopt);
  EXPECT_EQ(errno, EFBIG);
}

}  // namespace
}  // namespace openr_host
