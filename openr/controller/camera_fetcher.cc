#include "openr/controller/camera_fetcher.h"

#include <utility>

namespace openr_host {
namespace {

namespace remote = openr::remote;

constexpr int kLargestLayer = 0;
// Time between two attempts to fetch a camera picture while the robot serves another client.
constexpr std::chrono::milliseconds kBusyWait{100};
// After this number of attempts in a row without a picture, TakeProblem() reports that no pictures
// come.  The attempts last 10 s.  Another client occupies the camera for a far shorter time, so a
// busy camera alone is not reported.
constexpr int kSilentTries = 100;

}  // namespace

CameraFetcher::CameraFetcher(const remote::Address& address, remote::Options options)
    : address_(address), options_(options), thread_([this] { Fetch(); }) {}

CameraFetcher::~CameraFetcher() {
  is_ended_ = true;
  thread_.join();
}

void CameraFetcher::Fetch() {
  try {
    remote::Connection robot(address_, options_);
    for (int tries = 0; !is_ended_; ++tries) {
      try {
        std::string rgb = robot.TakePicture(kLargestLayer).Rgb();
        const std::lock_guard lock(mutex_);
        picture_ = std::move(rgb);
        // Resets `tries`, because a picture has come.  The loop then adds 1, so the next attempt
        // has number 0.
        tries = -1;
      } catch (const remote::Error& error) {
        if (error.status() != rcerrorBUSY && error.status() != rcerrorNO_PICTURE) throw;
        if (tries == kSilentTries) {
          const std::lock_guard lock(mutex_);
          problem_ = std::string("none has come for 10 s; still trying: ") + error.what();
        }
        std::this_thread::sleep_for(kBusyWait);
      }
    }
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    problem_ = error.what();
  }
}

bool CameraFetcher::CopyNewPicture(std::string* rgb) {
  const std::lock_guard lock(mutex_);
  if (picture_.empty()) return false;
  *rgb = std::move(picture_);
  picture_.clear();
  return true;
}

std::string CameraFetcher::TakeProblem() {
  const std::lock_guard lock(mutex_);
  return std::exchange(problem_, "");
}

}  // namespace openr_host
