// The files of the stick, and an upload without a client.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "FileUpload.h"
#include "StickStore.h"
#include "files_fixture.h"

namespace openr_host {
namespace {

// While this is true, rename() in this program replaces no file, as on some file systems.
bool g_rename_replaces_nothing = false;

}  // namespace
}  // namespace openr_host

// Takes the place of the rename() of the C library.
extern "C" int rename(const char* from, const char* to) noexcept {
  if (openr_host::g_rename_replaces_nothing && access(to, F_OK) == 0) {
    errno = EEXIST;
    return -1;
  }
  return renameat(AT_FDCWD, from, AT_FDCWD, to);
}

namespace openr_host {
namespace {

class StickStoreTest : public FilesTest {};

TEST_F(StickStoreTest, AStoreListsNothingBeforeItHasRead) {
  StickStore store;
  store.SetRoot(root_);
  EXPECT_EQ(store.Count(), 0);
}

TEST_F(StickStoreTest, AnEmptyFileIsReadAndHasNothing) {
  Write(Motion("EMPTY"), {});
  Uint8 bytes[8];
  Uint32 size = 99;
  EXPECT_EQ(StickStore::ReadPart(Motion("EMPTY"), 0, bytes, sizeof bytes, &size), 0);
  EXPECT_EQ(size, 0u);
  EXPECT_EQ(StickStore::ReadPart(Motion("EMPTY"), 1, bytes, sizeof bytes, &size), -1);
}

TEST_F(StickStoreTest, AFileIsReplacedOnlyByAnotherFile) {
  Write(Motion("OLD"), {1});
  EXPECT_FALSE(StickStore::Replace(Motion("NONE"), Motion("OLD")));
  EXPECT_EQ(Read(Motion("OLD")), Bytes{1});
  std::filesystem::create_directory(Motion("SUB"));
  EXPECT_FALSE(StickStore::Replace(Motion("SUB"), Motion("OLD")));
  EXPECT_FALSE(StickStore::Replace(Motion("OLD"), Motion("SUB")));
  EXPECT_EQ(Read(Motion("OLD")), Bytes{1});
  Write(Motion("NEW"), {2});
  EXPECT_TRUE(StickStore::Replace(Motion("NEW"), Motion("OLD")));
  EXPECT_EQ(Read(Motion("OLD")), Bytes{2});
  EXPECT_EQ(Files(), std::vector<std::string>{"OLD"});
}

class StickWithoutReplacementTest : public StickStoreTest {
 protected:
  StickWithoutReplacementTest() { g_rename_replaces_nothing = true; }
  ~StickWithoutReplacementTest() override { g_rename_replaces_nothing = false; }
};

TEST_F(StickWithoutReplacementTest, AFileIsReplacedByRenamingTheOldOneFirst) {
  for (const Bytes& old : {Bytes{1}, Bytes{}}) {
    Write(Motion("OLD.MTN"), old);
    Write(Motion("OLD.~TN"), {3});  // left by an earlier run
    Write(Motion("NEW.MTN"), {2});
    EXPECT_TRUE(StickStore::Replace(Motion("NEW.MTN"), Motion("OLD.MTN")));
    EXPECT_EQ(Read(Motion("OLD.MTN")), Bytes{2});
    EXPECT_EQ(Files(), std::vector<std::string>{"OLD.MTN"});
  }
  Write(Motion("EMPTY.MTN"), {});
  EXPECT_TRUE(StickStore::Replace(Motion("EMPTY.MTN"), Motion("OLD.MTN")));
  EXPECT_EQ(Read(Motion("OLD.MTN")), Bytes{});
}

TEST_F(StickWithoutReplacementTest, AFolderIsNeitherReplacedNorMoved) {
  Write(Motion("OLD.MTN"), {1});
  std::filesystem::create_directory(Motion("SUB.MTN"));
  EXPECT_FALSE(StickStore::Replace(Motion("SUB.MTN"), Motion("OLD.MTN")));
  EXPECT_FALSE(StickStore::Replace(Motion("OLD.MTN"), Motion("SUB.MTN")));
  EXPECT_EQ(Read(Motion("OLD.MTN")), Bytes{1});
  EXPECT_TRUE(std::filesystem::is_directory(Motion("SUB.MTN")));
}

// rename() between two file systems of the host fails, as does every rename() on a damaged stick.
TEST_F(StickStoreTest, AFileThatCannotBeReplacedStays) {
  std::string other = "/dev/shm/openr-test-XXXXXX";
  if (mkdtemp(other.data()) == nullptr) GTEST_SKIP() << "no second file system";
  Write(other + "/OLD", {1});
  Write(Motion("NEW"), {2});
  if (std::rename(Motion("NEW").c_str(), (other + "/TRY").c_str()) == 0) {
    std::filesystem::remove_all(other);
    GTEST_SKIP() << "no second file system";
  }
  EXPECT_FALSE(StickStore::Replace(Motion("NEW"), other + "/OLD"));
  EXPECT_EQ(errno, EXDEV);
  EXPECT_EQ(Read(other + "/OLD"), Bytes{1});
  EXPECT_EQ(Read(Motion("NEW")), Bytes{2});
  std::filesystem::remove_all(other);
}

TEST_F(StickStoreTest, AnUploadThatBeginsAnewRemovesItsFirstFile) {
  StickStore store;
  store.SetRoot(root_);
  FileUpload upload;
  std::string why;
  ASSERT_EQ(upload.Begin(store, RcUploadBegin{rcfileMOTION, "A.MTN", 3, 0}, &why), rcOK) << why;
  ASSERT_EQ(upload.Begin(store, RcUploadBegin{rcfileIMAGE, "CONTROLL.BIN", 3, 0}, &why), rcOK);
  EXPECT_TRUE(upload.IsOpen());
  EXPECT_FALSE(std::filesystem::exists(Motion("UPLOAD0.TMP")));
  EXPECT_TRUE(std::filesystem::exists(ImagePath("UPLOAD0.TMP")));
  upload.Abort();
  EXPECT_FALSE(upload.IsOpen());
  EXPECT_TRUE(Files().empty());
}

}  // namespace
}  // namespace openr_host
