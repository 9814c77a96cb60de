// The files of the stick, and an upload without a client.
#include "FileUpload.h"
#include "StickStore.h"
#include "files_fixture.h"

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
