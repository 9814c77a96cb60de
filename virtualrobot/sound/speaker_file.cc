// Writes the speaker's sound to a WAV file.
#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "virtualrobot/sound/sound_library.h"
#include "virtualrobot/sound/sound_sink.h"
#include "virtualrobot/sound/wav_file.h"

namespace openr_host {
namespace {

class SpeakerFile : public SoundSink {
 public:
  explicit SpeakerFile(std::string file) : file_(std::move(file)) {
    SF_INFO info{};
    info.samplerate = kSoundRate;
    info.channels = 1;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    stream_ = Sndfile().sf_open(file_.c_str(), SFM_WRITE, &info);
    if (stream_ == nullptr) throw std::runtime_error(Failed());
    // Makes libsndfile update the header after every frame, so that the file can be read even if
    // the run is killed.
    Sndfile().sf_command(stream_, SFC_SET_UPDATE_HEADER_AUTO, nullptr, SF_TRUE);
  }

  ~SpeakerFile() override { Close(); }

  // Writes the samples to the place in the file that belongs to the time of the frame, so that
  // frames without sound become zeros.
  std::string Play(int64_t frame, const SoundFrame& samples) override {
    const auto count = static_cast<sf_count_t>(samples.size());
    const bool is_written =
        Sndfile().sf_seek(stream_, frame * kSoundSamplesPerFrame, SEEK_SET) >= 0 &&
        Sndfile().sf_write_short(stream_, samples.data(), count) == count &&
        Sndfile().sf_error(stream_) == 0;
    return is_written ? "" : Failed();
  }

  std::string Close() override {
    if (stream_ == nullptr) return "";
    const int error = Sndfile().sf_close(std::exchange(stream_, nullptr));
    return error == 0
               ? ""
               : fmt::format("{}: cannot be written: {}", file_, Sndfile().sf_error_number(error));
  }

 private:
  std::string Failed() const {
    return fmt::format("{}: cannot be written: {}", file_, SoundFileError(stream_));
  }

  const std::string file_;
  SNDFILE* stream_ = nullptr;  // null when the file is closed
};

}  // namespace

std::unique_ptr<SoundSink> OpenSpeakerFile(const std::string& file) {
  return std::make_unique<SpeakerFile>(file);
}

}  // namespace openr_host
