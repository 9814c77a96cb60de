// The speaker's sound as a WAV file.
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "virtualrobot/sound/sound_sink.h"
#include "virtualrobot/sound/wav_file.h"

namespace openr_host {
namespace {

constexpr int64_t kFrameBytes = kSoundSamplesPerFrame * 2;

std::string Failed(const std::string& file) {
  return fmt::format("{}: cannot be written: {}", file, std::strerror(errno));
}

class SpeakerFile : public SoundSink {
 public:
  explicit SpeakerFile(std::string file)
      : file_(std::move(file)), stream_(std::fopen(file_.c_str(), "wb")) {
    if (stream_ == nullptr) throw std::runtime_error(Failed(file_));
    WriteHeader();
  }

  ~SpeakerFile() override { Close(); }

  // Silent frames are left out, as a hole of zeros.
  std::string Play(int64_t frame, const SoundFrame& samples) override {
    std::string bytes;
    for (const int16_t sample : samples) {
      bytes += static_cast<char>(sample & 0xff);
      bytes += static_cast<char>(sample >> 8 & 0xff);
    }
    if (std::fseek(stream_, static_cast<long>(kHeaderBytes + frame * kFrameBytes), SEEK_SET) != 0 ||
        std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) {
      return Failed(file_);
    }
    end_ = (frame + 1) * kFrameBytes;
    return "";
  }

  std::string Close() override {
    if (stream_ == nullptr) return "";
    const bool has_header = WriteHeader();
    const std::string problem = has_header ? "" : Failed(file_);
    const bool is_closed = std::fclose(std::exchange(stream_, nullptr)) == 0;
    return has_header && !is_closed ? Failed(file_) : problem;
  }

 private:
  static constexpr int64_t kHeaderBytes = 44;

  bool WriteHeader() {
    const std::string header = WavHeader(kSoundRate, static_cast<uint32_t>(end_));
    return std::fseek(stream_, 0, SEEK_SET) == 0 &&
           std::fwrite(header.data(), 1, header.size(), stream_) == header.size();
  }

  const std::string file_;
  std::FILE* stream_;  // null: closed
  int64_t end_ = 0;    // bytes of sound
};

}  // namespace

std::unique_ptr<SoundSink> OpenSpeakerFile(const std::string& file) {
  return std::make_unique<SpeakerFile>(file);
}

}  // namespace openr_host
