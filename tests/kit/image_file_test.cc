// Images as Makefiles install them: compressed or not, for this machine or for the robot.
#include "runtime/core/image_file.h"

#include <elf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

constexpr char kPowerMonitor[] = OPENR_IMAGES "/POWERMON.BIN";

std::string Compressed(const std::string& bytes) {
  std::string packed(compressBound(bytes.size()) + 64, '\0');
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string RobotHeader() {
  Elf32_Ehdr header{};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_ident[EI_CLASS] = ELFCLASS32;
  header.e_machine = EM_MIPS;
  return std::string(reinterpret_cast<const char*>(&header), sizeof header);
}

ImageFile Read(const ScratchFolder& folder, const std::string& bytes) {
  folder.Write("X.BIN", bytes);
  return ReadImageFile(folder.File("X.BIN"));
}

TEST(ImageFileTest, ACompressedImageIsTheImage) {
  const ScratchFolder folder;
  const ImageFile plain = ReadImageFile(kPowerMonitor);
  ASSERT_EQ(plain.problem, "");
  EXPECT_FALSE(plain.is_compressed);
  const ImageFile packed = Read(folder, Compressed(plain.bytes));
  EXPECT_EQ(packed.problem, "");
  EXPECT_TRUE(packed.is_compressed);
  EXPECT_EQ(packed.bytes, plain.bytes);
}

TEST(ImageFileTest, ABinaryForTheRobotIsKnownThroughItsCompression) {
  const ScratchFolder folder;
  for (const std::string& bytes : {RobotHeader(), Compressed(RobotHeader())}) {
    const ImageFile image = Read(folder, bytes);
    EXPECT_TRUE(image.is_for_robot);
    EXPECT_THAT(image.problem, HasSubstr("is a binary for the robot (MIPS)"));
  }
}

TEST(ImageFileTest, WhatWasCutOffOrDamagedIsSaidSo) {
  const ScratchFolder folder;
  const std::string packed = Compressed(ReadImageFile(kPowerMonitor).bytes);
  EXPECT_THAT(Read(folder, packed.substr(0, packed.size() / 2)).problem,
              HasSubstr("ends too early"));
  std::string damaged = packed;
  for (size_t i = 40; i < 80; ++i) damaged[i] = static_cast<char>(~damaged[i]);
  EXPECT_THAT(Read(folder, damaged).problem, HasSubstr("damaged gzip file"));
  EXPECT_EQ(Read(folder, Compressed("text")).problem,
            "is not an object image; build the object for the host (openr build)");
  EXPECT_EQ(ReadImageFile(folder.File("NONE.BIN")).problem, "cannot be read");
}

// field-notes.md 5.11.
TEST(ImageFileTest, AnImageThatWasSentAsTextIsSaidSo) {
  const ScratchFolder folder;
  const std::string packed = Compressed(ReadImageFile(kPowerMonitor).bytes);
  std::string sent;
  for (const char c : packed) sent += c == '\n' ? "\r\n" : std::string(1, c);
  // The reader needs at least four line ends; the image has about 20, by chance.
  ASSERT_GE(sent.size(), packed.size() + 4);
  EXPECT_THAT(Read(folder, sent).problem,
              HasSubstr("was changed on its way: each line end in it is CR LF, as after a transfer "
                        "of text (FTP: type A)"));
  // The same image, cut off but not changed.
  EXPECT_THAT(Read(folder, packed.substr(0, packed.size() / 2)).problem,
              HasSubstr("ends too early"));
}

}  // namespace
}  // namespace openr_host
