#include "openr/serve/request_pipe.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "openr/serve/request_too_long.h"

namespace openr_host {
namespace {

constexpr size_t kHeaderBytes = 8;
constexpr size_t kBufferBytes = size_t{64} << 10;

bool IsSocket(int descriptor) {
  struct stat facts {};
  return fstat(descriptor, &facts) == 0 && S_ISSOCK(facts.st_mode);
}

}  // namespace

RequestPipe::RequestPipe(int input, int output)
    : input_(input), output_(output), is_socket_(IsSocket(input)) {}

RequestPipe::~RequestPipe() {
  for (const int descriptor : descriptors_) close(descriptor);
}

void RequestPipe::DropDescriptors() {
  if (used_ != end_) return;
  for (const int descriptor : descriptors_) close(descriptor);
  descriptors_.clear();
}

void RequestPipe::UseSocket(int socket) {
  // Gives up, in this fork, the pipe of the original process, because this fork uses `socket`
  // instead.  If the fork kept the pipe open, the program that drives the run would not see at its
  // end of the pipe that the original process has ended.
  if (input_ == output_) {
    close(input_);  // the socket of a fork; may be closed, because nothing else uses this socket
  } else {
    // Makes both descriptors lead to /dev/null and does not close them, because standard input must
    // stay open.
    const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
    for (const int descriptor : {input_, output_}) dup2(nowhere, descriptor);
    close(nowhere);
  }
  input_ = output_ = socket;
  is_socket_ = true;
  used_ = end_ = 0;
}

int RequestPipe::TakeDescriptor() {
  if (descriptors_.empty()) return -1;
  const int descriptor = descriptors_.front();
  descriptors_.pop_front();
  return descriptor;
}

// Reads some bytes of a request, and keeps the descriptors (SCM_RIGHTS) that come with the bytes.
long RequestPipe::ReadSome(char* bytes, size_t size) {
  if (!is_socket_) return read(input_, bytes, size);
  iovec part{bytes, size};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))];
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  const long count = recvmsg(input_, &message, MSG_CMSG_CLOEXEC);
  if (count < 0) return count;
  for (cmsghdr* each = CMSG_FIRSTHDR(&message); each != nullptr;
       each = CMSG_NXTHDR(&message, each)) {
    if (each->cmsg_level != SOL_SOCKET || each->cmsg_type != SCM_RIGHTS) continue;
    int descriptor = -1;
    std::memcpy(&descriptor, CMSG_DATA(each), sizeof descriptor);
    descriptors_.push_back(descriptor);
  }
  return count;
}

// Reads until `buffer_` has `wanted` bytes that no request has used.  Returns false at the end of
// the input.
bool RequestPipe::Fill(size_t wanted) {
  if (used_ == end_) used_ = end_ = 0;
  if (buffer_.size() < used_ + wanted) {
    buffer_.erase(0, used_);
    end_ -= used_;
    used_ = 0;
    buffer_.resize(std::max(kBufferBytes, wanted));
  }
  while (end_ - used_ < wanted) {
    const long count = ReadSome(buffer_.data() + end_, buffer_.size() - end_);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    end_ += static_cast<size_t>(count);
  }
  return true;
}

bool RequestPipe::Receive(std::string* text, std::string* bytes) {
  uint32_t sizes[2];
  if (!Fill(kHeaderBytes)) return false;
  std::memcpy(sizes, buffer_.data() + used_, sizeof sizes);
  const size_t whole = size_t{sizes[0]} + sizes[1];
  if (whole > kRequestMax)
    throw RequestTooLong(
        fmt::format("a request has {} bytes, at most {} are allowed", whole, kRequestMax));
  if (!Fill(kHeaderBytes + whole)) return false;
  const size_t begin = used_ + kHeaderBytes;
  text->assign(buffer_, begin, sizes[0]);
  bytes->assign(buffer_, begin + sizes[0], sizes[1]);
  used_ = begin + whole;
  return true;
}

bool RequestPipe::Send(std::string_view text, std::string_view bytes) {
  const uint32_t sizes[2] = {static_cast<uint32_t>(text.size()),
                             static_cast<uint32_t>(bytes.size())};
  iovec parts[3] = {{const_cast<uint32_t*>(sizes), sizeof sizes},
                    {const_cast<char*>(text.data()), text.size()},
                    {const_cast<char*>(bytes.data()), bytes.size()}};
  for (size_t first = 0; first < 3;) {
    const long count = writev(output_, parts + first, static_cast<int>(3 - first));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    auto left = static_cast<size_t>(count);
    for (; first < 3 && left >= parts[first].iov_len; ++first) left -= parts[first].iov_len;
    if (first == 3) break;
    parts[first].iov_base = static_cast<char*>(parts[first].iov_base) + left;
    parts[first].iov_len -= left;
  }
  return true;
}

}  // namespace openr_host
