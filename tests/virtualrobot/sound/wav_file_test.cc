#include "virtualrobot/sound/wav_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "virtualrobot/sound/sound_sink.h"
#include "virtualrobot/sound/sound_source.h"

namespace openr_host {
namespace {

std::string Little(uint32_t value, int size) {
  std::string text;
  for (int i = 0; i < size; ++i) text += static_cast<char>(value >> 8 * i & 0xff);
  return text;
}

std::string Wav(uint32_t kind, uint32_t channels, uint32_t rate, uint32_t bits,
                const std::string& data) {
  const std::string format = Little(kind, 2) + Little(channels, 2) + Little(rate, 4) +
                             Little(rate * channels * bits / 8, 4) +
                             Little(channels * bits / 8, 2) + Little(bits, 2);
  const std::string list = "LIST" + Little(3, 4) + std::string("odd\0", 4);  // padded
  const std::string body = "WAVEfmt " + Little(16, 4) + format + list + "data" +
                           Little(static_cast<uint32_t>(data.size()), 4) + data;
  return "RIFF" + Little(static_cast<uint32_t>(body.size()), 4) + body;
}

// The name of a file that is removed with this object.
struct ScratchWav {
  const std::string name = testing::TempDir() + "wav_file_test_a.wav";
  ~ScratchWav() { std::remove(name.c_str()); }
};

// Reads `bytes` from a file named a.wav.
WavSound Read(const std::string& bytes) {
  const ScratchWav file;
  std::ofstream(file.name, std::ios::binary) << bytes;
  return ReadWavFile(file.name);
}

// The complaint about such a file, without its folder.
std::string ErrorIn(const std::string& bytes) {
  try {
    Read(bytes);
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    return text.substr(text.find("a.wav"));
  }
  return "";
}

TEST(WavFileTest, SixteenBitStereoIsReadBehindOtherChunks) {
  const WavSound sound = Read(Wav(1, 2, 16000, 16, Little(0x8001, 2) + Little(7, 2)));
  EXPECT_EQ(sound.rate_hz, 16000);
  EXPECT_EQ(sound.channels, 2);
  EXPECT_THAT(sound.samples, testing::ElementsAre(-32767, 7));
}

TEST(WavFileTest, EightBitsAreUnsignedInTheFile) {
  EXPECT_THAT(Read(Wav(1, 1, 8000, 8, "\x80\xff\x01")).samples,
              testing::ElementsAre(0, 127 * 256, -127 * 256));
}

TEST(WavFileTest, ADataChunkThatIsCutOffIsReadAsFarAsItGoes) {
  std::string bytes = Wav(1, 1, 8000, 16, Little(1, 2) + Little(2, 2));
  bytes.resize(bytes.size() - 1);
  EXPECT_THAT(Read(bytes).samples, testing::ElementsAre(1));
}

TEST(WavFileTest, WhatIsNotReadIsNamed) {
  EXPECT_EQ(ErrorIn("hello"), "a.wav: is no WAV file that can be read: Format not recognised");
  EXPECT_EQ(ErrorIn(""), "a.wav: is no WAV file that can be read: Format not recognised");
  EXPECT_EQ(ErrorIn("RIFF    WAVE"),
            "a.wav: is no WAV file that can be read: Error in WAV file. No 'data' chunk marker");
  EXPECT_EQ(ErrorIn(Wav(3, 1, 8000, 32, "")),
            "a.wav: holds samples of kind '32 bit float'; PCM of 8 or 16 bits is read");
  EXPECT_EQ(ErrorIn(Wav(1, 1, 8000, 24, "")),
            "a.wav: holds samples of kind 'Signed 24 bit PCM'; PCM of 8 or 16 bits is read");
  EXPECT_EQ(ErrorIn(Wav(1, 6, 8000, 16, "")), "a.wav: has 6 channels; 1 or 2 are read");
  EXPECT_EQ(ErrorIn(Wav(1, 1, 200'000, 16, "")),
            "a.wav: has 200000 samples a second; 1000 to 192000 are read");
  EXPECT_EQ(ErrorIn(Wav(1, 1, 999, 16, "")),
            "a.wav: has 999 samples a second; 1000 to 192000 are read");
  EXPECT_THAT(ErrorIn(Wav(1, 1, 0, 16, "")),
              testing::StartsWith("a.wav: is no WAV file that can be read: "));
}

// A file of 200 KB with 1 sample a second grew to 13 GB.
TEST(WavFileTest, ASmallFileWithFewSamplesASecondDoesNotGrowWithoutBound) {
  const std::string bytes(200'000, '\x80');
  EXPECT_EQ(ErrorIn(Wav(1, 1, 1, 8, bytes)),
            "a.wav: has 1 samples a second; 1000 to 192000 are read");
  EXPECT_EQ(ToStereo(Read(Wav(1, 1, 1000, 8, bytes)), 16'000).size(), 16u * bytes.size());
}

TEST(WavFileTest, ASoundOfMoreThanFourHoursIsRefused) {
  constexpr size_t kLongest = 4 * 3600 * 1000;
  EXPECT_EQ(Read(Wav(1, 1, 1000, 8, std::string(kLongest, '\x80'))).samples.size(), kLongest);
  EXPECT_EQ(ErrorIn(Wav(1, 1, 1000, 8, std::string(kLongest + 1, '\x80'))),
            "a.wav: is longer than 14400 s, the most that is read");
}

TEST(WavFileTest, AnotherRateIsReachedByStraightLinesAndMonoGoesToBothSides) {
  const auto stereo = ToStereo({8000, 1, {0, 100, 200}}, 16000);
  ASSERT_EQ(stereo.size(), 6u);
  const int wanted[] = {0, 50, 100, 150, 200, 200};
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(stereo[i].L, wanted[i]);
    EXPECT_EQ(stereo[i].R, wanted[i]);
  }
  EXPECT_EQ(ToStereo({32000, 2, {1, 2, 3, 4, 5, 6, 7, 8}}, 16000).size(), 2u);
  EXPECT_TRUE(ToStereo({16000, 1, {}}, 16000).empty());
}

TEST(WavFileTest, TheSpeakersFileIsTheVirtualTimeAndCanBeTheMicrophones) {
  const ScratchWav file;
  {
    const auto sink = OpenSpeakerFile(file.name);
    SoundFrame samples;
    samples.fill(1000);
    EXPECT_EQ(sink->Play(0, samples), "");
    samples.fill(-2000);
    EXPECT_EQ(sink->Play(2, samples), "");  // frame 1 is silent
  }
  const WavSound sound = ReadWavFile(file.name);
  EXPECT_EQ(sound.rate_hz, 16000);
  EXPECT_EQ(sound.channels, 1);
  ASSERT_EQ(sound.samples.size(), 3u * kSoundSamplesPerFrame);
  EXPECT_EQ(sound.samples[127], 1000);
  EXPECT_EQ(sound.samples[128], 0);
  EXPECT_EQ(sound.samples[256], -2000);
  const auto source = OpenMicrophoneFile(file.name, AfterEnd::kSilence);
  OSoundSampleStereo16 heard;
  source->Read(300, &heard, 1);
  EXPECT_EQ(heard.L, -2000);
  EXPECT_EQ(heard.R, -2000);
}

TEST(WavFileTest, TheSpeakersFileCanBeReadWhileTheRunGoesOn) {
  const ScratchWav file;
  const auto sink = OpenSpeakerFile(file.name);
  EXPECT_TRUE(ReadWavFile(file.name).samples.empty());
  SoundFrame samples;
  samples.fill(1000);
  EXPECT_EQ(sink->Play(3, samples), "");
  const WavSound sound = ReadWavFile(file.name);
  ASSERT_EQ(sound.samples.size(), 4u * kSoundSamplesPerFrame);
  EXPECT_EQ(sound.samples[383], 0);
  EXPECT_EQ(sound.samples[384], 1000);
}

TEST(WavFileTest, AFileThatIsMissingIsNamed) {
  try {
    ReadWavFile("/no/such/a.wav");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "/no/such/a.wav: cannot be read: No such file or directory");
  }
}

TEST(WavFileTest, AFileThatCannotBeWrittenIsNamed) {
  try {
    OpenSpeakerFile("/no/such/folder/a.wav");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "/no/such/folder/a.wav: cannot be written: No such file or directory");
  }
}

}  // namespace
}  // namespace openr_host
