#include "runtime/core/host_addresses.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "runtime/core/address_plan.h"

namespace openr_host {
namespace {

// The range of host addresses.  The kernel puts programs, their heaps and libraries above all
// planned addresses, from 17 TiB on, and below 128 TiB, where the addresses of a program end.
constexpr uint64_t kLowest = uint64_t{0x1100} << 32;
constexpr uint64_t kEnd = uint64_t{1} << 47;

// With AddressSanitizer and ThreadSanitizer, messages are not searched for host addresses.  These
// tools reserve so much memory that many numbers look like addresses in it.  Also, the memory of
// objects has no planned addresses then.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSearched = false;
#else
constexpr bool kIsSearched = true;
#endif

bool MayBeAddress(uint64_t word) { return word - kLowest < kEnd - kLowest; }

// Returns begin and end of all mapped ranges outside the address plan.
std::vector<std::pair<uint64_t, uint64_t>> ReadRanges() {
  std::vector<std::pair<uint64_t, uint64_t>> ranges;
  std::FILE* const maps = std::fopen("/proc/self/maps", "re");
  if (maps == nullptr) return ranges;
  char line[512];
  while (std::fgets(line, sizeof line, maps) != nullptr) {
    uint64_t begin = 0, end = 0;
    if (std::sscanf(line, "%" SCNx64 "-%" SCNx64, &begin, &end) == 2 &&
        !IsPlanned(reinterpret_cast<const void*>(begin)))
      ranges.emplace_back(begin, end);
  }
  std::fclose(maps);
  return ranges;
}

}  // namespace

bool HostAddresses::IsMapped(uint64_t address) {
  const auto contains = [&] {
    const auto after = std::upper_bound(ranges_.begin(), ranges_.end(),
                                        std::pair<uint64_t, uint64_t>(address, UINT64_MAX));
    return after != ranges_.begin() && address < std::prev(after)->second;
  };
  if (contains()) return true;
  ranges_ = ReadRanges();  // memory may have been mapped since the last call
  if (contains()) return true;
  ++misses_;
  return false;
}

int64_t HostAddresses::FindIn(const void* data, size_t size) {
  if (!kIsSearched || misses_ >= kMissesMax) return -1;
  const auto* const bytes = static_cast<const char*>(data);
  for (size_t at = 0; at + sizeof(uint64_t) <= size; at += sizeof(uint64_t)) {
    uint64_t word;
    std::memcpy(&word, bytes + at, sizeof word);
    if (MayBeAddress(word) && IsMapped(word)) return static_cast<int64_t>(at);
  }
  return -1;
}

}  // namespace openr_host
