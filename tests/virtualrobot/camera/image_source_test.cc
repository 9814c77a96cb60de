#include "virtualrobot/camera/image_source.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace openr_host {
namespace {

Picture Black(int width, int height) {
  return {width, height,
          std::vector<uint8_t>(static_cast<size_t>(width) * static_cast<size_t>(height) * 3)};
}

std::vector<int> Rgb(Picture& picture, int x, int y) {
  const uint8_t* const rgb = picture.At(x, y);
  return {rgb[0], rgb[1], rgb[2]};
}

TEST(TestPatternTest, ShowsBarsGreysTheNumberAndABallThatMoves) {
  TestPattern pattern;
  Picture picture = Black(352, 288);
  CameraShot shot;
  shot.number = 0x8001;  // first and last cell are white
  EXPECT_EQ(pattern.Capture(shot, &picture), "");
  EXPECT_EQ(Rgb(picture, 5, 5), (std::vector<int>{255, 255, 255}));
  EXPECT_EQ(Rgb(picture, 30, 5), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(Rgb(picture, 347, 5), (std::vector<int>{255, 255, 255}));
  EXPECT_EQ(Rgb(picture, 60, 30), (std::vector<int>{255, 255, 0}));
  EXPECT_EQ(Rgb(picture, 351, 287), (std::vector<int>{255, 255, 255}));
  const Picture before = picture;
  shot.number += 1;
  pattern.Capture(shot, &picture);
  EXPECT_NE(picture.rgb, before.rgb);
  shot.number = 50;
  pattern.Capture(shot, &picture);
  EXPECT_EQ(Rgb(picture, 316, 144), (std::vector<int>{250, 115, 174}));
}

TEST(TestPatternTest, IsAFunctionOfTheNumber) {
  TestPattern one, other;
  Picture a = Black(416, 320), b = Black(416, 320);
  CameraShot shot;
  for (shot.number = 1; shot.number < 20; ++shot.number) one.Capture(shot, &a);
  shot.number = 19;
  other.Capture(shot, &b);
  EXPECT_EQ(a.rgb, b.rgb);
}

TEST(ImageSourceTest, PicturesOfAnotherSizeAreScaled) {
  Picture four = Black(2, 2);
  for (int i = 0; i < 4; ++i) four.rgb[static_cast<size_t>(i) * 3] = static_cast<uint8_t>(i + 1);
  MemoryImageSource source({four});
  Picture picture = Black(8, 4);
  CameraShot shot;
  shot.number = 1;
  source.Capture(shot, &picture);
  EXPECT_EQ(Rgb(picture, 3, 1)[0], 1);
  EXPECT_EQ(Rgb(picture, 4, 1)[0], 2);
  EXPECT_EQ(Rgb(picture, 0, 2)[0], 3);
  EXPECT_EQ(Rgb(picture, 7, 3)[0], 4);
}

// ---- files

class ImageFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    folder = testing::TempDir() + "image_files_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::string Write(const std::string& name, const std::string& bytes) {
    const std::string file = folder + "/" + name;
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }
  static std::string ErrorIn(const std::string& file) {
    try {
      ReadPicture(file);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(file.size());
    }
    return "";
  }
  std::string folder;
};

TEST_F(ImageFilesTest, PpmAndPng) {
  Picture ppm = ReadPicture(Write("a.ppm", "P6\n# by hand\n2 1\n255\nabcdef"));
  EXPECT_EQ(ppm.width, 2);
  EXPECT_EQ(Rgb(ppm, 1, 0), (std::vector<int>{'d', 'e', 'f'}));

  // 1 x 2 pixels, "ABC" over "DEF".
  const char kPng[] =
      "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00"
      "\x00\x01\x00\x00\x00\x02\x08\x02\x00\x00\x00\x16\xe3\x21\x70\x00\x00\x00"
      "\x10\x49\x44\x41\x54\x78\x9c\x63\x70\x74\x72\x66\x70\x71\x75\x03\x00\x06"
      "\x46\x01\x96\x07\x71\x45\xbb\x00\x00\x00\x00\x49\x45\x4e\x44\xae\x42\x60"
      "\x82";
  Picture png = ReadPicture(Write("b.png", std::string(kPng, sizeof kPng - 1)));
  EXPECT_EQ(png.height, 2);
  EXPECT_EQ(Rgb(png, 0, 1), (std::vector<int>{'D', 'E', 'F'}));
}

TEST_F(ImageFilesTest, WhatIsNoPictureIsNamed) {
  EXPECT_EQ(ErrorIn(Write("a", "hello")), ": is neither a PNG nor a PPM (P6) file");
  EXPECT_EQ(ErrorIn(Write("b", "P6 2 1 255\nabc")),
            ": is cut off: 3 bytes of pixels, 2 x 1 need 6");
  EXPECT_EQ(ErrorIn(Write("c", "P6 2 1 65535\nabc")),
            ": PPM with values up to 65535; only 255 is read");
  EXPECT_EQ(ErrorIn(Write("d", "P6 2")), ": PPM header: a number from 1 to 8192 is missing");
  EXPECT_EQ(ErrorIn(Write("e", "P6 99999 1 255\n")),
            ": PPM header: a number from 1 to 8192 is missing");
  EXPECT_EQ(ErrorIn(Write("f", "P6#")), ": PPM header: a number from 1 to 8192 is missing");
  EXPECT_EQ(ErrorIn(Write("g", "\x89PNG\r\n\x1a\nrubbish")).substr(0, 4), ": no");
  EXPECT_EQ(ErrorIn(folder + "/none"), ": No such file or directory");
}

TEST_F(ImageFilesTest, AFolderIsShownInTheOrderOfItsNamesAndFromTheFirstAgain) {
  Write("2.ppm", "P6 1 1 255\nBBB");
  Write("1.ppm", "P6 1 1 255\nAAA");
  Write("3.ppm", "rubbish");
  Write("readme.txt", "no picture");
  const auto source = OpenImageFolder(folder);
  Picture picture = Black(8, 8);
  CameraShot shot;
  std::string seen;
  for (shot.number = 1; shot.number < 6; ++shot.number) {
    if (source->Capture(shot, &picture).empty()) {
      seen += static_cast<char>(picture.rgb[0]);
    } else {
      seen += '!';
    }
  }
  EXPECT_EQ(seen, "AB!AB");
}

TEST_F(ImageFilesTest, AFolderWithoutPicturesIsRefused) {
  EXPECT_THROW(OpenImageFolder(folder), std::runtime_error);
  EXPECT_THROW(OpenImageFolder(folder + "/none"), std::runtime_error);
}

}  // namespace
}  // namespace openr_host
