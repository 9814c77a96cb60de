// Replays the corpus of the fuzz target of the remote control, and random sessions.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/fuzz/remote_driver.h"

namespace openr_host {
namespace {

using Program = std::vector<uint8_t>;

std::string ProblemOf(FuzzStick* stick, const Program& program) {
  try {
    RemoteDriver(stick).Run(program.data(), program.size());
  } catch (const Violation& violation) {
    return violation.what();
  }
  stick->Restore();
  return "";
}

TEST(RemoteFuzzTest, SessionsOfTheCorpusKeepEveryProperty) {
  FuzzStick stick;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(OPENR_FUZZ_CORPUS)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  EXPECT_GE(files.size(), 10u);
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    const Program program{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    ASSERT_EQ(ProblemOf(&stick, program), "") << file;
  }
}

TEST(RemoteFuzzTest, RandomSessionsKeepEveryProperty) {
  FuzzStick stick;
  for (uint32_t seed = 1; seed <= 400; ++seed) {
    std::mt19937 random(seed);
    Program program(200 + random() % 800);
    for (uint8_t& byte : program) byte = static_cast<uint8_t>(random());
    ASSERT_EQ(ProblemOf(&stick, program), "") << "seed " << seed;
  }
}

// With few clients and few kinds of steps, uploads come to their end and answers pile up.
TEST(RemoteFuzzTest, SessionsOfTwoClientsKeepEveryProperty) {
  constexpr uint8_t kSteps[] = {0x10, 0x40, 0x40, 0x50, 0x60, 0x90, 0xa0, 0xa0, 0xc0, 0xc0, 0xe0};
  FuzzStick stick;
  for (uint32_t seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    Program program;
    while (program.size() < 900) {
      program.push_back(static_cast<uint8_t>(kSteps[random() % std::size(kSteps)] + random() % 2));
      for (uint32_t count = random() % 4; count > 0; --count) {
        program.push_back(static_cast<uint8_t>(random()));
      }
    }
    ASSERT_EQ(ProblemOf(&stick, program), "") << "seed " << seed;
  }
}

// AddressSanitizer has a heap of its own, of which mallinfo2() tells nothing.
#if !defined(__SANITIZE_ADDRESS__)
TEST(RemoteFuzzTest, TheHeapDoesNotGrowWithTheLengthOfASession) {
  FuzzStick stick;
  std::mt19937 random(5);
  Program program(4000);
  size_t before = 0;
  for (int round = 0; round < 12; ++round) {
    for (uint8_t& byte : program) byte = static_cast<uint8_t>(random());
    RemoteDriver(&stick).Run(program.data(), program.size());
    stick.Restore();
    if (round == 1) before = mallinfo2().uordblks;
  }
  EXPECT_LT(mallinfo2().uordblks, before + 20'000);
}
#endif

// Returns a program that uploads a file whose packet of UPLOAD_BEGIN is made by `begin`.
Program UploadProgram(uint8_t begin) {
  Program program;
  const std::vector<uint8_t> kinds = {begin, 1, 1, 1, 1, 1, 1, 1, 1, 5};  // begin, data, end
  for (const uint8_t kind : kinds) {
    const Program packet = {0x40, kind, 0xa0, 0xc0, 0xa0, 0xc0};
    program.insert(program.end(), packet.begin(), packet.end());
  }
  return program;
}

// Programs get through to the places where files change.
TEST(RemoteFuzzTest, AProgramUploadsAMotion) {
  FuzzStick stick;
  const Program program = UploadProgram(0);
  EXPECT_NO_THROW(RemoteDriver(&stick).Run(program.data(), program.size()));
  EXPECT_TRUE(std::filesystem::exists(stick.root() + "/MS/OPEN-R/MW/DATA/P/F0.MTN"));
}

TEST(RemoteFuzzTest, AProgramUploadsAnImage) {
  FuzzStick stick;
  const Program program = UploadProgram(8);
  EXPECT_NO_THROW(RemoteDriver(&stick).Run(program.data(), program.size()));
  EXPECT_TRUE(std::filesystem::exists(stick.root() + "/MS/OPEN-R/MW/OBJS/CONTROLL.OLD"));
}

// A check that finds nothing would let every session pass.
TEST(RemoteFuzzTest, AFileOutsideItsFoldersIsFound) {
  FuzzStick stick;
  EXPECT_NO_THROW(stick.Check());
  std::ofstream(stick.root() + "/MS/OPEN-R/MW/OBJS/UPLOAD3.TMP") << "left";
  EXPECT_THROW(stick.Check(), Violation);
  stick.Restore();
  EXPECT_NO_THROW(stick.Check());
  std::ofstream(stick.root() + "/SECRET.TXT") << "touched";
  EXPECT_THROW(stick.Check(), Violation);
}

}  // namespace
}  // namespace openr_host
