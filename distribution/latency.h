// How long things took on the wall clock, for the report.
#pragma once

#include <cstdint>
#include <vector>

namespace openr_host {

class Latency {
 public:
  // The time of a clock that only goes forward, with an arbitrary origin.
  static int64_t NowNs();
  static int64_t NowMs() { return NowNs() / 1'000'000; }

  // From its making to its end.
  class Timer {
   public:
    // Both get it.
    Timer(Latency* first, Latency* second) : first_(first), second_(second), begin_ns_(NowNs()) {}
    ~Timer() {
      const int64_t ns = NowNs() - begin_ns_;
      first_->Add(ns);
      second_->Add(ns);
    }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

   private:
    Latency* const first_;
    Latency* const second_;
    const int64_t begin_ns_;
  };

  void Add(int64_t ns);

  uint64_t count() const { return count_; }
  // The time, in microseconds, that a share `p` of 0..1 was not above; within 1/16 of it.
  double PercentileUs(double p) const;
  double MaxUs() const { return static_cast<double>(max_ns_) / 1000; }
  double MeanUs() const;

  // What has come to `before`, an earlier copy of this; its maximum within 1/16.
  Latency Since(const Latency& before) const;

 private:
  uint64_t count_ = 0;
  int64_t max_ns_ = 0;
  double sum_ns_ = 0;
  std::vector<uint64_t> buckets_;  // 16 to each power of two of nanoseconds
};

}  // namespace openr_host
