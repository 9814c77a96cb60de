#include "distribution/latency.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

constexpr int kBucketsPerOctave = 16;

// Returns the number of the bucket of the histogram that counts a duration.  Each power of two has
// 16 buckets; the four bits after the highest set bit of the duration choose one of these buckets.
size_t BucketOf(int64_t ns) {
  const auto value = static_cast<uint64_t>(std::max<int64_t>(ns, kBucketsPerOctave));
  const int octave = std::bit_width(value) - 1;
  const uint64_t step = (value >> (octave - 4)) & (kBucketsPerOctave - 1);
  return static_cast<size_t>(octave) * kBucketsPerOctave + step;
}

// Returns the limit below which the durations in a bucket of the histogram lie, in nanoseconds.
double UpperNs(size_t bucket) {
  const double octave = std::ldexp(1.0, static_cast<int>(bucket / kBucketsPerOctave));
  return octave * (1 + static_cast<double>(bucket % kBucketsPerOctave + 1) / kBucketsPerOctave);
}

}  // namespace

void Latency::Add(int64_t ns) {
  ++count_;
  max_ns_ = std::max(max_ns_, ns);
  sum_ns_ += static_cast<double>(ns);
  const size_t bucket = BucketOf(ns);
  if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
  ++buckets_[bucket];
}

double Latency::PercentileUs(double p) const {
  ASSERT(p >= 0 && p <= 1, "{}", p);
  const auto wanted = static_cast<uint64_t>(std::ceil(p * static_cast<double>(count_)));
  uint64_t seen = 0;
  for (size_t i = 0; i < buckets_.size(); ++i) {
    seen += buckets_[i];
    if (seen >= wanted && seen > 0) return std::min(UpperNs(i) / 1000, MaxUs());
  }
  return 0;
}

double Latency::MeanUs() const {
  return count_ == 0 ? 0 : sum_ns_ / static_cast<double>(count_) / 1000;
}

Latency Latency::Since(const Latency& before) const {
  ASSERT(before.count_ <= count_ && before.buckets_.size() <= buckets_.size(), "{} of {}",
         before.count_, count_);
  Latency since = *this;
  since.count_ -= before.count_;
  since.sum_ns_ -= before.sum_ns_;
  for (size_t i = 0; i < before.buckets_.size(); ++i) since.buckets_[i] -= before.buckets_[i];
  while (!since.buckets_.empty() && since.buckets_.back() == 0) since.buckets_.pop_back();
  const double upper_ns = since.buckets_.empty() ? 0 : UpperNs(since.buckets_.size() - 1);
  since.max_ns_ = std::min(max_ns_, static_cast<int64_t>(upper_ns));
  return since;
}

}  // namespace openr_host
