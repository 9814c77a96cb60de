// The commands of the remote control for files, with a stick in a folder of the test's own.
#include <dirent.h>
#include <signal.h>
#include <sys/resource.h>

#include <random>

#include "files_fixture.h"
#include "image_bytes.h"

namespace openr_host {
namespace {

// ---- The list

// Returns whether readdir() works on `folder`, which has files.  That of a 32-bit C library, as in
// the tests for MIPS, fails on file systems of the host whose positions have 64 bits.
bool CanList(const std::string& folder) {
  DIR* const dir = opendir(folder.c_str());
  const bool can = dir != nullptr && readdir(dir) != nullptr;
  if (dir != nullptr) closedir(dir);
  return can;
}

TEST_F(FilesTest, MotionsAreListedByNameWithTheirSizes) {
  if (!CanList(Motion(""))) GTEST_SKIP() << "readdir() fails here";
  for (const char* name : {"WALK.MTN", "NOD.MTN", "SIT.MTN", "README.TXT", "long-name.MTN", "MTN"})
    Write(Motion(name), Bytes(std::string(name).size()));
  std::filesystem::create_directory(Motion("SUB"));
  std::filesystem::create_directory(Motion("XSUB.MTN"));
  const RcList list = List(0);
  EXPECT_EQ(list.total, 4);
  ASSERT_EQ(list.entries.size(), 4u);
  EXPECT_EQ(list.entries[0].name, "NOD.MTN");
  EXPECT_EQ(list.entries[0].size, 7u);
  EXPECT_EQ(list.entries[1].name, "SIT.MTN");
  EXPECT_EQ(list.entries[2].name, "WALK.MTN");
  EXPECT_EQ(list.entries[3].name, "XSUB.MTN");
  EXPECT_EQ(list.entries[3].size, 0u) << "a folder";
}

TEST_F(FilesTest, AListComesInPartsThatFitIntoAPacket) {
  if (!CanList(Motion(""))) GTEST_SKIP() << "readdir() fails here";
  for (int i = 0; i < 120; ++i) Write(Motion("LONG" + std::to_string(1000 + i) + ".MTN"), {1});
  std::vector<std::string> names;
  for (int first = 0; first < 120;) {
    const RcList part = List(first);
    EXPECT_EQ(part.total, 120);
    EXPECT_EQ(part.first, first);
    ASSERT_FALSE(part.entries.empty());
    for (const RcListEntry& entry : part.entries) names.push_back(entry.name);
    first += static_cast<int>(part.entries.size());
  }
  EXPECT_EQ(names.size(), 120u);
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_TRUE(List(120).entries.empty());
  EXPECT_EQ(Ask(rcMTN_LIST, {121, 0}), rcerrorBAD_VALUE);
}

TEST_F(FilesTest, AFolderWithMoreThanTheRobotListsKeepsTheFirstNames) {
  if (!CanList(Motion(""))) GTEST_SKIP() << "readdir() fails here";
  for (int i = 0; i < 700; ++i) Write(Motion("M" + std::to_string(1000 + i) + ".MTN"), {});
  EXPECT_EQ(List(0).total, 682);
  EXPECT_EQ(List(681).entries[0].name, "M1681.MTN");
}

TEST_F(FilesTest, WithoutItsFolderTheListIsEmpty) {
  std::filesystem::remove_all(Motion(""));
  EXPECT_EQ(List(0).total, 0);
}

// ---- Upload

TEST_F(FilesTest, AMotionIsUploaded) {
  ASSERT_EQ(Upload(rcfileMOTION, "nod.mtn", kGoodMotion), rcOK) << error_;
  EXPECT_EQ(Read(Motion("NOD.MTN")), kGoodMotion);
  EXPECT_EQ(Files(), std::vector<std::string>{"NOD.MTN"});
}

TEST_F(FilesTest, DataMayComeByteByByte) {
  ASSERT_EQ(Begin(rcfileMOTION, "NOD.MTN", kGoodMotion), rcOK);
  EXPECT_EQ(payload_, (Bytes{RC_MAX_UPLOAD_DATA & 0xff, RC_MAX_UPLOAD_DATA >> 8}));
  ASSERT_EQ(DataOf(kGoodMotion, 0, kGoodMotion.size(), 1), rcOK) << error_;
  EXPECT_FALSE(std::filesystem::exists(Motion("NOD.MTN"))) << "not before the end";
  ASSERT_EQ(Ask(rcUPLOAD_END, {}), rcOK) << error_;
  EXPECT_EQ(Read(Motion("NOD.MTN")), kGoodMotion);
}

TEST_F(FilesTest, TheOldMotionStaysUntilTheNewOneIsGood) {
  const Bytes old = MtnBytes::OneJoint("PRM:/r1/c1-Joint2:j1", {5, 6}).Bytes();
  Write(Motion("NOD.MTN"), old);
  Bytes bad = kGoodMotion;
  bad[0] = 'X';
  EXPECT_EQ(Upload(rcfileMOTION, "NOD.MTN", bad), rcerrorBAD_FILE);
  EXPECT_NE(error_.find("NOD.MTN: "), std::string::npos) << error_;
  EXPECT_EQ(Read(Motion("NOD.MTN")), old);
  EXPECT_EQ(Files().size(), 1u);
  EXPECT_EQ(Upload(rcfileMOTION, "NOD.MTN", kGoodMotion), rcOK);
  EXPECT_EQ(Read(Motion("NOD.MTN")), kGoodMotion);
}

TEST_F(FilesTest, AMotionForAnotherRobotIsRefused) {
  const Bytes other = MtnBytes::OneJoint("PRM:/r1/c1-Joint2:11", {0, 1}).Bytes();
  EXPECT_EQ(Upload(rcfileMOTION, "SEVEN.MTN", other), rcerrorBAD_FILE);
  EXPECT_NE(error_.find("the ERS-210 has no joint"), std::string::npos) << error_;
  EXPECT_TRUE(Files().empty());
}

TEST_F(FilesTest, AnImageKeepsTheOldOne) {
  Write(ImagePath("CONTROLL.BIN"), {1, 2, 3});
  Write(ImagePath("CONTROLL.OLD"), {9});
  ASSERT_EQ(Upload(rcfileIMAGE, "CONTROLL.BIN", OwnImage()), rcOK) << error_;
  EXPECT_EQ(Read(ImagePath("CONTROLL.BIN")), OwnImage());
  EXPECT_EQ(Read(ImagePath("CONTROLL.OLD")), (Bytes{1, 2, 3}));
  EXPECT_EQ(Files(), (std::vector<std::string>{"CONTROLL.BIN", "CONTROLL.OLD"}));
}

TEST_F(FilesTest, AnImageForTheOtherProcessorIsRefused) {
  Write(ImagePath("CONTROLL.BIN"), {1, 2, 3});
  EXPECT_EQ(Upload(rcfileIMAGE, "CONTROLL.BIN", OtherImage()), rcerrorBAD_FILE);
  EXPECT_EQ(error_, std::string("CONTROLL.BIN: is an image for ") +
                        ImageProcessorName(imageMIPS + imageX86_64 - OwnProcessor()) +
                        "; this robot needs one for " + ImageProcessorName(OwnProcessor()));
  EXPECT_EQ(Upload(rcfileIMAGE, "CONTROLL.BIN", Bytes(100, 65)), rcerrorBAD_FILE);
  EXPECT_EQ(error_, "CONTROLL.BIN: is no image of an object");
  EXPECT_EQ(Upload(rcfileIMAGE, "CONTROLL.BIN", {1}), rcerrorBAD_FILE);
  EXPECT_EQ(Read(ImagePath("CONTROLL.BIN")), (Bytes{1, 2, 3}));
  EXPECT_EQ(Files(), std::vector<std::string>{"CONTROLL.BIN"});
}

TEST_F(FilesTest, NamesThatLeadElsewhereAreRefused) {
  for (const char* name : {"../A.MTN", "..", "", "A", "A.TXT", "A/B.MTN", "LONGERNAME.MTN",
                           "/A.MTN", "A.MTN.MTN", ".MTN", "A\\B.MTN", "UPLOAD0.TMP", "A B.MTN"}) {
    EXPECT_EQ(Begin(rcfileMOTION, name, kGoodMotion), rcerrorNO_SUCH_FILE) << name;
    EXPECT_EQ(AskWith(rcDELETE, RcFileName{rcfileMOTION, name}), rcerrorNO_SUCH_FILE) << name;
    EXPECT_EQ(AskWith(rcDOWNLOAD, RcDownload{rcfileMOTION, name, 0}), rcerrorNO_SUCH_FILE) << name;
  }
  for (const char* name : {"RCSERVER.BIN", "CONTROLL.OLD", "../OBJS/CONTROLL.BIN", "CONTROLL"})
    EXPECT_EQ(Begin(rcfileIMAGE, name, OwnImage()), rcerrorNO_SUCH_FILE) << name;
  EXPECT_EQ(Begin(2, "A.MTN", kGoodMotion), rcerrorBAD_VALUE);
  EXPECT_TRUE(Files().empty());
}

TEST_F(FilesTest, SizesAreBoundedBeforeTheyAreUsed) {
  const auto begin = [this](int kind, uint32_t size) {
    const std::string name = kind == rcfileMOTION ? "A.MTN" : "CONTROLL.BIN";
    return AskWith(rcUPLOAD_BEGIN, RcUploadBegin{static_cast<Uint8>(kind), name, size, 0});
  };
  EXPECT_EQ(begin(rcfileMOTION, 0), rcerrorBAD_VALUE);
  EXPECT_EQ(begin(rcfileMOTION, RC_MAX_MOTION + 1), rcerrorBAD_VALUE);
  EXPECT_EQ(error_, "A.MTN has 1048577 bytes, must have 1 to 1048576");
  EXPECT_EQ(begin(rcfileMOTION, 0xffffffff), rcerrorBAD_VALUE);
  EXPECT_EQ(begin(rcfileIMAGE, RC_MAX_IMAGE + 1), rcerrorBAD_VALUE);
  EXPECT_TRUE(Files().empty());
  EXPECT_EQ(begin(rcfileIMAGE, RC_MAX_IMAGE), rcOK);
}

TEST_F(FilesTest, AWrongCrcIsRefused) {
  const RcUploadBegin request{rcfileMOTION, "A.MTN", static_cast<Uint32>(kGoodMotion.size()), 1};
  ASSERT_EQ(AskWith(rcUPLOAD_BEGIN, request), rcOK);
  ASSERT_EQ(DataOf(kGoodMotion, 0, kGoodMotion.size(), 100), rcOK);
  EXPECT_EQ(Ask(rcUPLOAD_END, {}), rcerrorBAD_FILE);
  EXPECT_NE(error_.find("00000001 was announced"), std::string::npos) << error_;
  EXPECT_TRUE(Files().empty());
}

TEST_F(FilesTest, LessOrMoreDataThanAnnouncedIsRefused) {
  ASSERT_EQ(Begin(rcfileMOTION, "A.MTN", kGoodMotion), rcOK);
  ASSERT_EQ(Data(0, {1, 2, 3}), rcOK);
  EXPECT_EQ(Ask(rcUPLOAD_END, {}), rcerrorBAD_FILE);
  EXPECT_EQ(error_.find("A.MTN: 3 bytes have arrived"), 0u) << error_;
  EXPECT_TRUE(Files().empty());

  ASSERT_EQ(Begin(rcfileMOTION, "A.MTN", {1, 2, 3}), rcOK);
  EXPECT_EQ(Data(0, {1, 2, 3, 4}), rcerrorBAD_VALUE);
  EXPECT_TRUE(Files().empty());
  EXPECT_EQ(Ask(rcUPLOAD_END, {}), rcerrorNO_UPLOAD) << "the upload has ended";
}

TEST_F(FilesTest, AWrongOffsetEndsTheUploadAndTheNextIsGood) {
  for (const size_t offset : {size_t{0}, size_t{2}, size_t{4}, size_t{0xffffffff}}) {
    ASSERT_EQ(Begin(rcfileMOTION, "A.MTN", kGoodMotion), rcOK);
    ASSERT_EQ(Data(0, {1, 2, 3}), rcOK);
    EXPECT_EQ(Data(offset, {4}), rcerrorBAD_VALUE) << offset;
    EXPECT_TRUE(Files().empty());
    EXPECT_EQ(Data(3, {4}), rcerrorNO_UPLOAD);
  }
  EXPECT_EQ(Upload(rcfileMOTION, "A.MTN", kGoodMotion), rcOK);
}

TEST_F(FilesTest, AClientThatBeginsAnewHasOneUpload) {
  ASSERT_EQ(Begin(rcfileMOTION, "A.MTN", kGoodMotion), rcOK);
  ASSERT_EQ(Data(0, {1, 2, 3}), rcOK);
  ASSERT_EQ(Upload(rcfileMOTION, "B.MTN", kGoodMotion), rcOK);
  EXPECT_EQ(Files(), std::vector<std::string>{"B.MTN"});
  ASSERT_EQ(Begin(rcfileIMAGE, "CONTROLL.BIN", OwnImage()), rcOK);
  EXPECT_EQ(Begin(rcfileMOTION, "../A.MTN", kGoodMotion), rcerrorNO_SUCH_FILE);
  EXPECT_EQ(Files(), std::vector<std::string>{"B.MTN"}) << "a refused one ends the one before, too";
}

TEST_F(FilesTest, AClientThatVanishesLeavesNothing) {
  ASSERT_EQ(Begin(rcfileMOTION, "A.MTN", kGoodMotion, 3), rcOK);
  ASSERT_EQ(Data(0, {1, 2, 3}, 3), rcOK);
  EXPECT_EQ(Files(), std::vector<std::string>{"UPLOAD3.TMP"});
  handler_->EndClient(3);
  EXPECT_TRUE(Files().empty());
  EXPECT_EQ(Data(3, {4}, 3), rcerrorNO_UPLOAD) << "the next client at this place";
  EXPECT_EQ(Upload(rcfileMOTION, "A.MTN", kGoodMotion, 3), rcOK);
}

TEST_F(FilesTest, UploadsOfTwoClientsDoNotMix) {
  const Bytes other = MtnBytes::OneJoint("PRM:/r1/c1-Joint2:j1", {7, 8, 9, 10}).Bytes();
  ASSERT_EQ(Begin(rcfileMOTION, "A.MTN", kGoodMotion, 0), rcOK);
  ASSERT_EQ(DataOf(kGoodMotion, 0, 40, 7, 0), rcOK);
  ASSERT_EQ(Begin(rcfileMOTION, "B.MTN", other, 8), rcOK);
  ASSERT_EQ(DataOf(other, 0, 30, 11, 8), rcOK);
  EXPECT_EQ(Data(0, {1}, 5), rcerrorNO_UPLOAD);
  ASSERT_EQ(DataOf(kGoodMotion, 40, kGoodMotion.size(), 7, 0), rcOK);
  ASSERT_EQ(DataOf(other, 30, other.size(), 11, 8), rcOK);
  EXPECT_EQ(Ask(rcUPLOAD_END, {}, 0), rcOK) << error_;
  EXPECT_EQ(Ask(rcUPLOAD_END, {}, 8), rcOK) << error_;
  EXPECT_EQ(Read(Motion("A.MTN")), kGoodMotion);
  EXPECT_EQ(Read(Motion("B.MTN")), other);
}

TEST_F(FilesTest, WhatAKilledRunHasLeftIsRemovedAtTheStart) {
  Write(Motion("UPLOAD0.TMP"), {1});
  Write(Motion("UPLOAD8.TMP"), {1});
  Write(ImagePath("UPLOAD2.TMP"), {1});
  Write(ImagePath("UPLOAD2.OLD"), {1});
  Write(Motion("UPLOAD.MTN"), {1});
  Boot();
  EXPECT_EQ(Files(), std::vector<std::string>{"UPLOAD.MTN"});
  EXPECT_EQ(kept_, "");
  Boot();
  EXPECT_EQ(kept_, "") << "nothing was left";
}

// Where rename() replaces no file, an upload renames the old file first.  The power failed then, or
// before the old file was removed.
TEST_F(FilesTest, FilesThatAnUploadHasRenamedGetTheirNamesBackAtTheStart) {
  Write(Motion("WALK.~TN"), {1});
  Write(Motion("TURN.~TN"), {2});
  Write(Motion("TURN.MTN"), {3});
  Write(Motion("UPLOAD0.TMP"), {4});
  Write(ImagePath("CONTROLL.~IN"), {5});
  Write(ImagePath("CONTROLL.~LD"), {6});
  if (!CanList(Motion(""))) GTEST_SKIP() << "readdir() fails here";
  Boot();
  EXPECT_EQ(kept_, "");
  EXPECT_EQ(Files(),
            (std::vector<std::string>{"CONTROLL.BIN", "CONTROLL.OLD", "TURN.MTN", "WALK.MTN"}));
  EXPECT_EQ(Read(Motion("WALK.MTN")), Bytes{1});
  EXPECT_EQ(Read(Motion("TURN.MTN")), Bytes{3});
  EXPECT_EQ(Read(ImagePath("CONTROLL.BIN")), Bytes{5});
  EXPECT_EQ(Read(ImagePath("CONTROLL.OLD")), Bytes{6});
}

TEST_F(FilesTest, AFileThatCannotBeRemovedAtTheStartIsNamed) {
  std::filesystem::create_directory(ImagePath("UPLOAD4.OLD"));
  Write(ImagePath("UPLOAD4.OLD/A"), {1});  // remove() leaves a folder with a file
  Boot();
  EXPECT_EQ(kept_, ImagePath("UPLOAD4.OLD"));
}

TEST_F(FilesTest, AMalformedRequestEndsTheUpload) {
  for (const auto& [command, request] : {std::pair<int, Bytes>{rcUPLOAD_DATA, {3, 0, 0}},
                                         {rcUPLOAD_DATA, {3, 0, 0, 0}},
                                         {rcUPLOAD_END, {0}},
                                         {rcUPLOAD_BEGIN, {0, 200, 'A'}}}) {
    ASSERT_EQ(Begin(rcfileMOTION, "A.MTN", kGoodMotion), rcOK);
    ASSERT_EQ(Data(0, {1, 2, 3}), rcOK);
    EXPECT_EQ(Ask(command, request), rcerrorMALFORMED);
    EXPECT_TRUE(Files().empty()) << command;
    EXPECT_EQ(Data(3, {4}), rcerrorNO_UPLOAD) << command;
  }
}

TEST_F(FilesTest, MalformedRequestsAreRefused) {
  EXPECT_EQ(Ask(rcMTN_LIST, {0}), rcerrorMALFORMED);
  EXPECT_EQ(Ask(rcUPLOAD_BEGIN, {0, 200, 'A'}), rcerrorMALFORMED);
  EXPECT_EQ(Ask(rcUPLOAD_DATA, {0, 0, 0}), rcerrorMALFORMED);
  EXPECT_EQ(Ask(rcUPLOAD_DATA, {0, 0, 0, 0}), rcerrorMALFORMED) << "no data";
  EXPECT_EQ(Ask(rcUPLOAD_END, {0}), rcerrorMALFORMED);
  EXPECT_EQ(Ask(rcDELETE, {}), rcerrorMALFORMED);
  EXPECT_EQ(Ask(rcDOWNLOAD, {0}), rcerrorMALFORMED);
  EXPECT_EQ(Ask(rcREBOOT, {0}), rcerrorMALFORMED);
  EXPECT_EQ(Ask(rcSHUTDOWN, {0}), rcerrorMALFORMED);
  EXPECT_TRUE(ends_.empty());
}

// ---- A stick that takes no more

// Limits the size of the files that this process writes, as a full stick would.
class FullStick {
 public:
  explicit FullStick(rlim_t bytes) : handler_(signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullStick() {
    setrlimit(RLIMIT_FSIZE, &before_);
    signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_;
  sighandler_t handler_;
};

TEST_F(FilesTest, AStickThatIsFullIsNamedByThePartThatFindsNoRoom) {
  const Bytes image = OwnImage();
  Write(ImagePath("CONTROLL.BIN"), {1, 2, 3});
  {
    const FullStick full(2000);
    ASSERT_EQ(Begin(rcfileIMAGE, "CONTROLL.BIN", image), rcOK);
    EXPECT_EQ(DataOf(image, 0, 2000, 500), rcOK) << error_;
    EXPECT_EQ(DataOf(image, 2000, 3000, 500), rcerrorNOT_WRITTEN);
    EXPECT_EQ(error_,
              "CONTROLL.BIN: byte 2000 cannot be written; is the stick full or write-protected?");
    EXPECT_EQ(Files(), std::vector<std::string>{"CONTROLL.BIN"});
  }
  EXPECT_EQ(Upload(rcfileIMAGE, "CONTROLL.BIN", image), rcOK) << error_;
}

TEST_F(FilesTest, AnOldImageThatCannotBeKeptStays) {
  const Bytes old = Image(2, 62, 9000);
  Write(ImagePath("CONTROLL.BIN"), old);
  const FullStick full(4000);
  EXPECT_EQ(Upload(rcfileIMAGE, "CONTROLL.BIN", OwnImage()), rcerrorNOT_WRITTEN);
  EXPECT_NE(error_.find("cannot be kept as CONTROLL.OLD"), std::string::npos) << error_;
  EXPECT_EQ(Read(ImagePath("CONTROLL.BIN")), old);
  EXPECT_EQ(Files(), std::vector<std::string>{"CONTROLL.BIN"});
}

TEST_F(FilesTest, AStickWithoutTheFolderRefusesUploads) {
  std::filesystem::remove_all(Motion(""));
  EXPECT_EQ(Begin(rcfileMOTION, "A.MTN", kGoodMotion), rcerrorNOT_WRITTEN);
}

TEST_F(FilesTest, AFolderOfThatNameIsNoFile) {
  std::filesystem::create_directory(Motion("A.MTN"));
  EXPECT_EQ(Upload(rcfileMOTION, "A.MTN", kGoodMotion), rcerrorNOT_WRITTEN);
  EXPECT_EQ(error_, Motion("A.MTN") + ": is a folder, and a file cannot replace it");
  EXPECT_EQ(AskWith(rcDELETE, RcFileName{rcfileMOTION, "A.MTN"}), rcerrorNO_SUCH_FILE);
  EXPECT_EQ(AskWith(rcDOWNLOAD, RcDownload{rcfileMOTION, "A.MTN", 0}), rcerrorNO_SUCH_FILE);
  EXPECT_TRUE(std::filesystem::is_directory(Motion("A.MTN")));
  EXPECT_TRUE(Files().empty());
}

// ---- Download, delete, the end of the run

TEST_F(FilesTest, AFileIsDownloadedInParts) {
  const Bytes image = OwnImage();
  Write(ImagePath("CONTROLL.BIN"), image);
  Bytes all;
  do {
    const auto at = static_cast<Uint32>(all.size());
    ASSERT_EQ(AskWith(rcDOWNLOAD, RcDownload{rcfileIMAGE, "CONTROLL.BIN", at}), rcOK) << error_;
    RcReader reader(payload_.data(), static_cast<int>(payload_.size()));
    EXPECT_EQ(reader.U32(), image.size());
    all.insert(all.end(), reader.Rest(), reader.Rest() + reader.RestSize());
  } while (all.size() < image.size() && payload_.size() > 4);
  EXPECT_EQ(all, image);
  EXPECT_EQ(AskWith(rcDOWNLOAD, RcDownload{rcfileIMAGE, "CONTROLL.BIN", 3000}), rcOK) << "no more";
  EXPECT_EQ(payload_.size(), 4u);
  EXPECT_EQ(AskWith(rcDOWNLOAD, RcDownload{rcfileIMAGE, "CONTROLL.BIN", 3001}), rcerrorBAD_VALUE);
  EXPECT_EQ(AskWith(rcDOWNLOAD, RcDownload{rcfileMOTION, "NONE.MTN", 0}), rcerrorNO_SUCH_FILE);
  EXPECT_EQ(AskWith(rcDOWNLOAD, RcDownload{rcfileMOTION, "NONE.MTN", 1}), rcerrorNO_SUCH_FILE);
}

TEST_F(FilesTest, AnOffsetBehindAnEmptyFileIsABadValue) {
  Write(Motion("EMPTY.MTN"), {});
  EXPECT_EQ(AskWith(rcDOWNLOAD, RcDownload{rcfileMOTION, "EMPTY.MTN", 0}), rcOK) << error_;
  EXPECT_EQ(AskWith(rcDOWNLOAD, RcDownload{rcfileMOTION, "EMPTY.MTN", 1}), rcerrorBAD_VALUE);
}

TEST_F(FilesTest, AMotionIsDeletedAndAnImageIsNot) {
  Write(Motion("A.MTN"), kGoodMotion);
  Write(ImagePath("CONTROLL.BIN"), {1});
  EXPECT_EQ(AskWith(rcDELETE, RcFileName{rcfileMOTION, "a.mtn"}), rcOK) << error_;
  EXPECT_EQ(AskWith(rcDELETE, RcFileName{rcfileMOTION, "A.MTN"}), rcerrorNO_SUCH_FILE);
  EXPECT_EQ(AskWith(rcDELETE, RcFileName{rcfileIMAGE, "CONTROLL.BIN"}), rcerrorBAD_VALUE);
  EXPECT_EQ(Files(), std::vector<std::string>{"CONTROLL.BIN"});
}

TEST_F(FilesTest, ShutdownAndRebootAreHandedOn) {
  EXPECT_EQ(Ask(rcSHUTDOWN, {}), rcOK);
  EXPECT_EQ(Ask(rcREBOOT, {}), rcOK);
  EXPECT_EQ(ends_, (std::vector<bool>{false, true}));
}

TEST_F(FilesTest, RandomRequestsAlwaysGetAnAnswerAndStayInTheFolders) {
  std::mt19937 random(17);
  const int commands[] = {rcMTN_LIST,   rcUPLOAD_BEGIN, rcUPLOAD_DATA,
                          rcUPLOAD_END, rcDELETE,       rcDOWNLOAD};
  for (int i = 0; i < 3000; ++i) {
    Bytes payload(random() % 24);
    for (uint8_t& byte : payload)
      byte = static_cast<uint8_t>(random() % 3 == 0 ? random() : random() % 8);
    Ask(commands[random() % 6], payload, static_cast<int>(random() % 9));
  }
  for (int client = 0; client < 9; ++client) handler_->EndClient(client);
  EXPECT_TRUE(Files().empty());
}

}  // namespace
}  // namespace openr_host
