#include <gtest/gtest.h>

#include "Crc32.h"
#include "ImageFile.h"
#include "image_bytes.h"

namespace openr_host {
namespace {

TEST(Crc32Test, IsThatOfZip) {
  const Bytes digits = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(Crc32(0, digits.data(), 9), 0xcbf43926u);
  EXPECT_EQ(Crc32(Crc32(0, digits.data(), 4), digits.data() + 4, 5), 0xcbf43926u);
  EXPECT_EQ(Crc32(0, nullptr, 0), 0u);
}

TEST(ImageFileTest, TheFirstBytesTellTheProcessor) {
  const auto of = [](const Bytes& bytes) {
    return ImageProcessorOf(bytes.data(), static_cast<int>(bytes.size()));
  };
  EXPECT_EQ(of(Image(2, 62)), imageX86_64);
  EXPECT_EQ(of(Image(1, 8)), imageMIPS);
  EXPECT_EQ(of(Image(2, 8)), imageUNKNOWN);
  EXPECT_EQ(of(Image(2, 183)), imageUNKNOWN) << "ARM";
  Bytes packed(30);
  packed[0] = 0x1f, packed[1] = 0x8b, packed[2] = 8;
  EXPECT_EQ(of(packed), imageMIPS);
  EXPECT_EQ(of({'h', 'e', 'l', 'l', 'o'}), imageUNKNOWN);
  EXPECT_EQ(of({}), imageUNKNOWN);
}

}  // namespace
}  // namespace openr_host
