// openr mtn from-csv, plot and oda.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "openr/motion/mtn_csv.h"
#include "openr/motion/oda_file.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

std::string FileBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string MotionOnStick(const std::string& name) {
  return std::string(OPENR_STICK) + "/OPEN-R/MW/DATA/P/" + name;
}

TEST(MtnFromCsvTest, WhatDumpPrintsBecomesTheSameFileAgain) {
  const ScratchFolder folder;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MotionOnStick(""))) {
    const std::string motion = entry.path().string();
    if (entry.path().extension() != ".MTN") continue;
    const ProgramResult dump = RunProgram({"mtn", "dump", motion});
    ASSERT_EQ(dump.status, 0) << dump.err;
    folder.Write("table.csv", dump.out);
    const ProgramResult made = RunProgram({"mtn", "from-csv", folder.File("table.csv"), "--like",
                                           motion, "-o", folder.File("AGAIN.MTN")});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(folder.Read("AGAIN.MTN"), FileBytes(motion)) << motion;
    ++count;
  }
  EXPECT_EQ(count, 7);
}

TEST(MtnFromCsvTest, NamesAreThoseOfTheFlags) {
  const ScratchFolder folder;
  folder.Write("turn.csv",
               "key_frame,time_ms,roll_deg,pitch_deg,yaw_deg,PRM:/r1/c1/c2-Joint2:j2\r\n"
               "0,0,0,0,0,-10\r\n1,64,0,0,0,10.5\r\n\r\n");
  ASSERT_EQ(RunProgram({"mtn", "from-csv", folder.File("turn.csv"), "-o", folder.File("T.MTN"),
                        "--creator", "me"})
                .status,
            0);
  const auto info =
      nlohmann::json::parse(RunProgram({"mtn", "info", "--json", folder.File("T.MTN")}).out);
  EXPECT_EQ(info["name"], "turn");
  EXPECT_EQ(info["creator"], "me");
  EXPECT_EQ(info["design_label"], "DRX-900");
  EXPECT_EQ(info["duration_ms"], 64);
  EXPECT_TRUE(info["warnings"].empty());
}

std::string MotionProblem(const std::string& rows) {
  const std::string header =
      "key_frame,time_ms,roll_deg,pitch_deg,yaw_deg,PRM:/a-Joint2:j1,PRM:/e-Joint3:j2\n";
  try {
    ParseMotionCsv(header + rows);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(MtnFromCsvTest, MistakesAreNamedWithLineAndColumn) {
  const struct {
    const char* rows;
    const char* complaint;
  } cases[] = {
      {"", "line 2: a motion has at least one key frame"},
      {"0,0,0,0,0,1,0\n1,16,0,0,0,2\n", "line 3: has 6 fields, the first line has 7"},
      {"0,16,0,0,0,1,0\n", "line 2, column time_ms: '16' must be 0 at the first key frame"},
      {"0,0,0,0,0,1,0\n2,16,0,0,0,1,0\n", "line 3, column key_frame: '2' must be 1"},
      {"0,0,0,0,0,1,0\n1,20,0,0,0,1,0\n",
       "line 3, column time_ms: '20' is 20 ms after the key frame before, must be 16 ms or a "
       "multiple of it"},
      {"0,0,0,0,0,1,0\n1,16,0,0,0,1,0\n2,-2147483648,0,0,0,1,0\n",
       "line 4, column time_ms: '-2147483648' is -2147483664 ms after the key frame before, must "
       "be "
       "16 ms or a multiple of it"},
      {"0,0,0,0,0,x,0\n", "line 2, column PRM:/a-Joint2:j1: 'x' is no number of degrees"},
      {"0,0,0,0,0,361,0\n",
       "line 2, column PRM:/a-Joint2:j1: '361' beyond +-360 degrees no angle makes sense"},
      {"0,0,0,0,0,nan,0\n",
       "line 2, column PRM:/a-Joint2:j1: 'nan' beyond +-360 degrees no angle makes sense"},
      {"0,0,0,0,0,1,2\n", "line 2, column PRM:/e-Joint3:j2: '2' an ear is 0 or 1"},
  };
  for (const auto& c : cases) EXPECT_EQ(MotionProblem(c.rows), c.complaint);
  EXPECT_EQ(MotionProblem("0,0,0,0,0,1,0\n1,16,0,0,0,2,1\n"), "");
  EXPECT_THROW(ParseMotionCsv("a,b\n"), std::runtime_error);
}

TEST(MtnPlotTest, AMotionBecomesAChart) {
  const ScratchFolder folder;
  const ProgramResult result =
      RunProgram({"mtn", "plot", MotionOnStick("BOW.MTN"), "-o", folder.File("bow.svg")});
  if (result.err.find("they need Cairo") != std::string::npos) GTEST_SKIP() << result.err;
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(folder.Read("bow.svg").find("<svg"), std::string::npos);
}

TEST(MtnPlotTest, NamesThatAreNoTextAreDrawnAsFarAsTheyAre) {
  const ScratchFolder folder;
  folder.Write("t.csv", "key_frame,time_ms,roll_deg,pitch_deg,yaw_deg,\xff" +
                            std::string(200, 'x') + "\n0,0,0,0,0,1\n1,16,0,0,0,2\n");
  ASSERT_EQ(RunProgram({"mtn", "from-csv", folder.File("t.csv"), "-o", folder.File("T.MTN"),
                        "--name", std::string(250, '\xfe')})
                .status,
            0);
  const ProgramResult result =
      RunProgram({"mtn", "plot", folder.File("T.MTN"), "-o", folder.File("t.png")});
  if (result.err.find("they need Cairo") != std::string::npos) GTEST_SKIP() << result.err;
  EXPECT_EQ(result.status, 0) << result.err;
}

// ---- Containers ----------------------------------------------------------------------

void AppendU32(uint32_t value, std::string* out) {
  for (int i = 0; i < 4; ++i) out->push_back(static_cast<char>(value >> 8 * i));
}

struct MemberText {
  std::string type, name, bytes;
};

std::string OdaOf(const std::vector<MemberText>& members) {
  std::string bytes("ODAR\0\0\3\0", 8);
  AppendU32(static_cast<uint32_t>(members.size()), &bytes);
  AppendU32(144, &bytes);
  bytes.resize(64);
  auto offset = static_cast<uint32_t>(64 + 144 * members.size());
  for (const MemberText& member : members) {
    std::string entry = member.type;
    entry.resize(4);
    entry += member.name;
    entry.resize(132);
    AppendU32(offset, &entry);
    AppendU32(static_cast<uint32_t>(member.bytes.size()), &entry);
    entry.resize(144);
    bytes += entry;
    offset += static_cast<uint32_t>(member.bytes.size());
  }
  for (const MemberText& member : members) bytes += member.bytes;
  return bytes;
}

std::string OdaProblem(const std::string& bytes) {
  try {
    ReadOda(bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(OdaTest, MembersAreUnpackedUnderSafeNames) {
  const ScratchFolder folder;
  const std::string motion = FileBytes(MotionOnStick("BOW.MTN"));
  folder.Write("ALL.ODA", OdaOf({{"OMTN", "bow", motion},
                                 {"WAVE", "cheerup1_long", "RIFF"},
                                 {"WAVE", "cheerup1_loud", "RIFF2"},
                                 {"LED", "../../etc/passwd", "L"},
                                 {"XYZ", "", ""}}));
  const auto list = nlohmann::json::parse(
      RunProgram({"mtn", "oda", "list", "--json", folder.File("ALL.ODA")}).out);
  ASSERT_EQ(list.size(), 5u);
  EXPECT_EQ(list[3]["name"], "../../etc/passwd");
  const std::vector<std::string> files = {"BOW.MTN", "CHEERUP1.WAV", "CHEERUP2.WAV", "______ET.LED",
                                          "_.BIN"};
  for (size_t i = 0; i < files.size(); ++i) EXPECT_EQ(list[i]["file"], files[i]);

  const ProgramResult unpacked =
      RunProgram({"mtn", "oda", "unpack", folder.File("ALL.ODA"), "-o", folder.File("out")});
  EXPECT_EQ(unpacked.status, 0) << unpacked.err;
  for (const std::string& file : files)
    EXPECT_TRUE(std::filesystem::exists(folder.File("out/" + file))) << file;
  EXPECT_EQ(folder.Read("out/BOW.MTN"), motion);
  EXPECT_EQ(folder.Read("out/CHEERUP2.WAV"), "RIFF2");
  EXPECT_EQ(RunProgram({"mtn", "check", folder.File("out/BOW.MTN")}).status, 0);
}

TEST(OdaTest, NothingIsOverwrittenUnlessTold) {
  const ScratchFolder folder;
  folder.Write("ALL.ODA", OdaOf({{"OMTN", "a", "new a"}, {"OMTN", "b", "new b"}}));
  folder.Write("out/B.MTN", "old b");
  const std::vector<std::string> unpack = {
      "mtn", "oda", "unpack", folder.File("ALL.ODA"), "-o", folder.File("out")};
  const ProgramResult refused = RunProgram(unpack);
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("B.MTN: is there already; nothing was unpacked"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.File("out/A.MTN")));
  std::vector<std::string> overwrite = unpack;
  overwrite.push_back("--overwrite");
  EXPECT_EQ(RunProgram(overwrite).status, 0);
  EXPECT_EQ(folder.Read("out/B.MTN"), "new b");
}

TEST(OdaTest, ALinkOutOfTheFolderIsNotFollowed) {
  const ScratchFolder folder;
  folder.Write("ALL.ODA", OdaOf({{"OMTN", "a", "new a"}}));
  folder.Write("outside", "precious");
  std::filesystem::create_directory(folder.File("out"));
  std::filesystem::create_symlink(folder.File("outside"), folder.File("out/A.MTN"));
  const ProgramResult refused = RunProgram(
      {"mtn", "oda", "unpack", folder.File("ALL.ODA"), "-o", folder.File("out"), "--overwrite"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("it is a symbolic link"), std::string::npos) << refused.err;
  EXPECT_EQ(folder.Read("outside"), "precious");
}

TEST(OdaTest, MistakesAreNamedWithTheirOffset) {
  const std::string good = OdaOf({{"OMTN", "a", "0123456789"}, {"OMTN", "b", "0123456789"}});
  EXPECT_EQ(OdaProblem(good), "");
  EXPECT_EQ(OdaProblem("OMTN"), "offset 0: a container begins with 'ODAR', this one does not");
  EXPECT_EQ(OdaProblem(good.substr(0, 40)), "offset 0: the file has 40 bytes, its head needs 64");
  EXPECT_EQ(OdaProblem("\x1f\x8b\x08" + good),
            "offset 0: the file is compressed; unpack it with gunzip first");
  EXPECT_EQ(OdaProblem(good.substr(0, 300)),
            "offset 8: 2 members need a directory of 288 bytes, the file has 236 left");
  EXPECT_EQ(OdaProblem(good.substr(0, good.size() - 1)),
            "offset 340: a member of 10 bytes begins at 362, the file has 371");
  std::string bytes = good;
  bytes[8] = bytes[9] = '\xff';
  EXPECT_EQ(OdaProblem(bytes), "offset 8: 65535 members, at most 4096 are read");
  bytes = good;
  bytes[12] = 80;
  EXPECT_EQ(OdaProblem(bytes), "offset 12: a directory entry has 80 bytes, must be 144");
}

TEST(OdaTest, MembersThatOverlapAreRefused) {
  std::string bytes = OdaOf({{"OMTN", "a", std::string(400, 'x')}, {"OMTN", "b", ""}});
  const size_t entry = 64 + 144 + 132;
  bytes.replace(entry, 8, bytes.substr(64 + 132, 8));  // b has the bytes of a
  EXPECT_EQ(OdaProblem(bytes).find("offset 208: the members overlap"), 0u) << OdaProblem(bytes);
}

}  // namespace
}  // namespace openr_host
