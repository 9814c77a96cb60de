#include "openr/panel/run_link.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace openr_host {
namespace {

// Returns a connection to the socket of the run.
int ConnectTo(const LiveRun& run) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, run.socket.c_str(),
              std::min(run.socket.size(), sizeof address.sun_path - 1));
  const int descriptor = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor >= 0 &&
      connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
    return descriptor;
  const int error = errno;
  if (descriptor >= 0) close(descriptor);
  throw std::runtime_error(fmt::format(
      "run {} (process {}) cannot be reached: {}", run.name, run.process,
      error == EAGAIN ? "too many others wait for it; is it stopped?" : std::strerror(error)));
}

}  // namespace

RunLink::RunLink(WebLoop* loop, const LiveRun& run, Owner owner)
    : loop_(loop),
      name_(fmt::format("run {} (process {})", run.name, run.process)),
      owner_(std::move(owner)),
      descriptor_(ConnectTo(run)) {
  watched_ = loop_->Watch(descriptor_, this);
  if (watched_ == nullptr) throw std::runtime_error("the panel has no descriptors left");
}

RunLink::~RunLink() {
  if (watched_ != nullptr) loop_->Forget(watched_);
}

bool RunLink::Send(const std::string& line) {
  to_send_ += line;
  to_send_ += '\n';
  loop_->WantWrite(watched_);
  return to_send_.size() <= kWaitingMax;
}

bool RunLink::OnReadable() {
  char buffer[64 << 10];
  // Limits the number of reads from the run's socket in one call.  A run that writes all the time
  // must not keep the event loop from serving other pages.
  constexpr int kReadsMax = 8;
  for (int i = 0; i < kReadsMax; ++i) {
    const ssize_t count = recv(descriptor_, buffer, sizeof buffer, 0);
    if (count < 0) return errno == EAGAIN || errno == EINTR;
    if (count == 0) return false;
    received_.append(buffer, static_cast<size_t>(count));
    PassOnLines();
    if (received_.size() > kLineMax) return false;
  }
  return true;
}

void RunLink::PassOnRest() {
  char buffer[64 << 10];
  // Limits the number of reads, so that this loop ends in any case.  256 reads of 64 KiB take
  // 16 MiB, and the socket of an ended run holds far less, so no bytes are lost.
  constexpr int kReadsMax = 256;
  for (int i = 0; i < kReadsMax; ++i) {
    const ssize_t count = recv(descriptor_, buffer, sizeof buffer, 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    received_.append(buffer, static_cast<size_t>(count));
    PassOnLines();
  }
}

void RunLink::PassOnLines() {
  size_t begin = 0;
  for (size_t end = received_.find('\n'); end != std::string::npos;
       end = received_.find('\n', begin)) {
    has_answered_ = true;
    owner_.take_line(received_.substr(begin, end - begin));
    begin = end + 1;
  }
  received_.erase(0, begin);
}

bool RunLink::OnWritable() {
  const bool was_full = to_send_.size() > kWaitingMax;
  const ssize_t count = send(descriptor_, to_send_.data(), to_send_.size(), MSG_NOSIGNAL);
  if (count < 0 && errno != EAGAIN && errno != EINTR) {
    PassOnRest();  // the run has ended, but its last answers may not have been read yet
    return false;
  }
  if (count > 0) to_send_.erase(0, static_cast<size_t>(count));
  if (!to_send_.empty()) loop_->WantWrite(watched_);
  if (was_full && to_send_.size() <= kWaitingMax) owner_.resume();
  return true;
}

void RunLink::OnClosed() {
  watched_ = nullptr;
  const auto end = owner_.end;  // a copy, because the call of `end` may delete this link
  end(has_answered_ ? name_ + " has ended"
                    : name_ + " has ended, or serves as many clients as it can (32)");
}

}  // namespace openr_host
