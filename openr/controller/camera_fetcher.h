// CameraFetcher, which fetches pictures of the robot's camera one after the other.
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "openr/remote/connection.h"

namespace openr_host {

// Fetches in a thread with a connection of its own, because a picture has 153 packets and commands
// must not wait for them.
class CameraFetcher {
 public:
  CameraFetcher(const openr::remote::Address& address, openr::remote::Options options);
  ~CameraFetcher();
  CameraFetcher(const CameraFetcher&) = delete;
  CameraFetcher& operator=(const CameraFetcher&) = delete;

  // If a new picture has come since the last call, puts it into `*rgb`, three bytes a pixel from
  // the top left, and returns true.
  bool Take(std::string* rgb);

  // Returns the reason why no pictures come, once; "" as long as they come, or for the first 10 s
  // in which the robot has none.
  std::string TakeProblem();

 private:
  void Fetch();

  const openr::remote::Address address_;
  const openr::remote::Options options_;
  std::atomic<bool> is_ended_ = false;
  std::mutex mutex_;
  std::string picture_;  // the newest; "" after it was taken
  std::string problem_;
  std::thread thread_;
};

}  // namespace openr_host
