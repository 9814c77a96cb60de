// A cable between two network interfaces whose other ends are in this process.  It forwards packets
// as the test demands.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace openr_host {

// How packets are forwarded.
struct Weather {
  double loss = 0;      // share (0 to 1) of packets that do not arrive
  double doubling = 0;  // share (0 to 1) of packets that arrive twice
  int delay_us = 0;
  int jitter_us = 0;  // largest additional delay; packets may overtake each other
};

// Makes a TUN device in this network namespace.  Returns the descriptor of its other end, or -1.
int OpenTun(std::string* name);

class Relay {
 public:
  struct Counts {
    uint64_t passed = 0;
    uint64_t bytes = 0;  // bytes of the packets that `passed` counts
    uint64_t lost = 0;
    uint64_t doubled = 0;
    uint64_t overtaken = 0;  // arrived after a packet that was sent later
    uint64_t cut = 0;        // sent while the cable was cut
  };

  // Takes ownership of two descriptors of OpenTun().
  Relay(int left, int right, uint32_t seed);
  ~Relay();
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

  void set_weather(const Weather& weather);
  void Cut();   // from now on no packet arrives, nor one that is on its way
  void Mend();  // packets arrive again
  Counts counts() const;

 private:
  struct Packet {
    size_t to;        // index of the receiving end
    uint64_t number;  // counts the packets of this direction
    std::vector<char> bytes;
  };

  void Run();
  bool ReadPackets(size_t end);
  void AddPacket(size_t to, std::vector<char> bytes);
  int64_t SendWhatIsDue();  // returns the time until the next packet is due, in ns
  bool Happens(double share) { return std::uniform_real_distribution<>(0, 1)(random_) < share; }

  const std::array<int, 2> ends_;
  mutable std::mutex mutex_;  // guards the members below
  Weather weather_;
  bool is_cut_ = false;
  Counts counts_;
  std::mt19937 random_;
  std::multimap<int64_t, Packet> under_way_;  // packets on their way, by the time of their arrival
  std::array<uint64_t, 2> last_taken_{}, last_arrived_{};
  std::atomic<bool> is_over_ = false;
  std::thread thread_;
};

}  // namespace openr_host
