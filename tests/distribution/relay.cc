#include "tests/distribution/relay.h"

#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <poll.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <utility>

namespace openr_host {
namespace {

constexpr int64_t kLookNs = 20'000'000;  // between checks whether the relay ends
constexpr size_t kPacketMax = 65536;

int64_t NowNs() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace

int OpenTun(std::string* name) {
  const int end = open("/dev/net/tun", O_RDWR | O_CLOEXEC | O_NONBLOCK);
  ifreq request{};
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  strcpy(request.ifr_name, "openr%d");
  if (end >= 0 && ioctl(end, TUNSETIFF, &request) != 0) {
    close(end);
    return -1;
  }
  *name = request.ifr_name;
  return end;
}

Relay::Relay(int left, int right, uint32_t seed)
    : ends_{left, right}, random_(seed), thread_([this] { Run(); }) {}

Relay::~Relay() {
  is_over_ = true;
  thread_.join();
  for (const int end : ends_) close(end);
}

void Relay::set_weather(const Weather& weather) {
  const std::lock_guard lock(mutex_);
  weather_ = weather;
}

void Relay::Cut() {
  const std::lock_guard lock(mutex_);
  is_cut_ = true;
  counts_.cut += under_way_.size();
  under_way_.clear();
}

void Relay::Mend() {
  const std::lock_guard lock(mutex_);
  is_cut_ = false;
}

Relay::Counts Relay::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

void Relay::Run() {
  while (!is_over_) {
    const int64_t wait_ns = std::min(SendWhatIsDue(), kLookNs);
    const timespec wait = {0, static_cast<long>(wait_ns)};
    pollfd wanted[2] = {{ends_[0], POLLIN, 0}, {ends_[1], POLLIN, 0}};
    if (ppoll(wanted, 2, &wait, nullptr) <= 0) continue;
    for (size_t end = 0; end < 2; ++end) {
      if (wanted[end].revents != 0 && !ReadPackets(end)) return;  // the host is gone
    }
  }
}

// Reads all packets that have arrived at this end.  False when the interface is gone.
bool Relay::ReadPackets(size_t end) {
  for (;;) {
    std::vector<char> bytes(kPacketMax);
    const ssize_t size = read(ends_[end], bytes.data(), bytes.size());
    if (size <= 0) return errno == EAGAIN || errno == EINTR;
    bytes.resize(static_cast<size_t>(size));
    const std::lock_guard lock(mutex_);
    AddPacket(1 - end, std::move(bytes));
  }
}

void Relay::AddPacket(size_t to, std::vector<char> bytes) {
  const uint64_t number = ++last_taken_[to];
  if (is_cut_) {
    ++counts_.cut;
  } else if (Happens(weather_.loss)) {
    ++counts_.lost;
  } else {
    const bool twice = Happens(weather_.doubling);
    counts_.doubled += twice ? 1 : 0;
    std::uniform_int_distribution<int64_t> jitter_us(0, weather_.jitter_us);
    for (int i = 0; i < (twice ? 2 : 1); ++i) {
      const int64_t due_ns = NowNs() + (weather_.delay_us + jitter_us(random_)) * 1000;
      under_way_.emplace(due_ns, Packet{to, number, bytes});
    }
  }
}

int64_t Relay::SendWhatIsDue() {
  const std::lock_guard lock(mutex_);
  while (!under_way_.empty()) {
    const auto first = under_way_.begin();
    const int64_t wait_ns = first->first - NowNs();
    if (wait_ns > 0) return wait_ns;
    const Packet& packet = first->second;
    const ssize_t written = write(ends_[packet.to], packet.bytes.data(), packet.bytes.size());
    if (written > 0) ++counts_.passed;
    if (written > 0) counts_.bytes += static_cast<uint64_t>(written);
    if (packet.number < last_arrived_[packet.to]) ++counts_.overtaken;
    last_arrived_[packet.to] = std::max(last_arrived_[packet.to], packet.number);
    under_way_.erase(first);
  }
  return kLookNs;
}

}  // namespace openr_host
