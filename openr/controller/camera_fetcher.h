// CameraFetcher, which fetches pictures from the robot's camera one after the other.
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "openr/remote/connection.h"

namespace openr_host {

// Fetches pictures of the robot's camera in a thread with a connection of its own, because a
// picture has 153 packets, and commands on the same connection would wait for them.
class CameraFetcher {
 public:
  CameraFetcher(const openr::remote::Address& address, openr::remote::Options options);
  ~CameraFetcher();
  CameraFetcher(const CameraFetcher&) = delete;
  CameraFetcher& operator=(const CameraFetcher&) = delete;

  // If a new picture of the camera has come since the last call, puts the newest picture into
  // `*rgb`, three bytes a pixel from the top left, and returns true.  Otherwise returns false.
  bool CopyNewPicture(std::string* rgb);

  // Returns the reason why no pictures come from the robot's camera; "" if no new reason has been
  // found since the last call.  A camera that another client uses becomes a reason only after 10 s.
  std::string TakeProblem();

 private:
  void Fetch();

  const openr::remote::Address address_;
  const openr::remote::Options options_;
  std::atomic<bool> is_ended_ = false;
  std::mutex mutex_;
  std::string
      picture_;  // newest picture of the camera; "" if CopyNewPicture() has already returned it
  std::string problem_;
  std::thread thread_;
};

}  // namespace openr_host
