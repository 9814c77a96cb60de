// A cable between two network interfaces whose other ends are here: passes packets on as it is
// told.
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

// What happens to a packet on its way.
struct Weather {
  double loss = 0;      // share of 0..1 that does not arrive
  double doubling = 0;  // share that arrives twice
  int delay_us = 0;
  int jitter_us = 0;  // at most so much later, so that packets overtake each other
};

// Makes a TUN device of this network namespace: the descriptor of its other end, or -1.
int OpenTun(std::string* name);

class Relay {
 public:
  struct Counts {
    uint64_t passed = 0;
    uint64_t bytes = 0;  // of those
    uint64_t lost = 0;
    uint64_t doubled = 0;
    uint64_t overtaken = 0;  // arrived after one that was sent later
    uint64_t cut = 0;        // met no cable
  };

  // Takes over the two descriptors (OpenTun()).
  Relay(int left, int right, uint32_t seed);
  ~Relay();
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

  void set_weather(const Weather& weather);
  void Cut();   // nothing arrives any more, what is on its way included
  void Mend();  // and again
  Counts counts() const;

 private:
  struct Packet {
    size_t to;        // end
    uint64_t number;  // in its direction
    std::vector<char> bytes;
  };

  void Run();
  bool TakeFrom(size_t end);
  void Take(size_t to, std::vector<char> bytes);
  int64_t SendWhatIsDue();  // returns how long until the next is, in ns
  bool Happens(double share) { return std::uniform_real_distribution<>(0, 1)(random_) < share; }

  const std::array<int, 2> ends_;
  mutable std::mutex mutex_;  // of what follows
  Weather weather_;
  bool is_cut_ = false;
  Counts counts_;
  std::mt19937 random_;
  std::multimap<int64_t, Packet> under_way_;  // by the time when they arrive
  std::array<uint64_t, 2> last_taken_{}, last_arrived_{};
  std::atomic<bool> is_over_ = false;
  std::thread thread_;
};

}  // namespace openr_host
