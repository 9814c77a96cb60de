// Latency: a histogram of durations on the wall clock, from which reports compute means and
// percentiles.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/base/wall_clock.h"

namespace openr_host {

class Latency {
 public:
  // Measures the time from its construction to its destruction, and adds that time to two
  // histograms: for example, the histogram of a worker and the histogram of an object of the
  // worker.
  class Timer {
   public:
    Timer(Latency* first, Latency* second)
        : first_(first), second_(second), begin_ns_(WallClockNs()) {}
    ~Timer() {
      const int64_t ns = WallClockNs() - begin_ns_;
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
  // Returns a percentile in microseconds, the duration that the share `p` (0 to 1) of all durations
  // did not exceed.  The result is at most 1/16 too high, because durations are counted in buckets.
  double PercentileUs(double p) const;
  double MaxUs() const { return static_cast<double>(max_ns_) / 1000; }
  double MeanUs() const;

  // Returns a histogram of only those durations that are not in `before`, an earlier copy of this
  // histogram.  The maximum of the result may be up to 1/16 too high, because it is computed from
  // the buckets.
  Latency Since(const Latency& before) const;

 private:
  uint64_t count_ = 0;
  int64_t max_ns_ = 0;
  double sum_ns_ = 0;
  // The number of durations in each bucket of the histogram.  A bucket counts durations of similar
  // length; there are 16 buckets for each power of two.
  std::vector<uint64_t> buckets_;
};

}  // namespace openr_host
