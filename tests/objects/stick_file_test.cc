#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "StickFile.h"

namespace openr_host {
namespace {

class StickFileTest : public testing::Test {
 protected:
  StickFileTest() {
    std::string name = (std::filesystem::temp_directory_path() / "openr-test-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) folder_ = name;
  }
  ~StickFileTest() override { std::filesystem::remove_all(folder_); }
  std::string folder_;
};

TEST_F(StickFileTest, AFolderIsRefusedAsWhatItIs) {
  const std::string path = folder_ + "/WALK.MTN";
  std::filesystem::create_directory(path);
  std::vector<Uint8> bytes(1);
  std::string error;
  EXPECT_FALSE(ReadStickFile(path, &bytes, &error));
  EXPECT_EQ(error, path + ": is a folder, not a file");
  EXPECT_TRUE(bytes.empty());
}

TEST_F(StickFileTest, AFileIsReadAndAMissingOneIsCalledThat) {
  const std::string path = folder_ + "/A.MTN";
  std::vector<Uint8> bytes;
  std::string error;
  EXPECT_FALSE(ReadStickFile(path, &bytes, &error));
  EXPECT_EQ(error, path + ": no such file on the Memory Stick");
  std::ofstream(path) << "ab";
  EXPECT_TRUE(ReadStickFile(path, &bytes, &error));
  EXPECT_EQ(bytes, (std::vector<Uint8>{'a', 'b'}));
}

}  // namespace
}  // namespace openr_host
