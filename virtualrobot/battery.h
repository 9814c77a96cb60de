// The battery of a robot: its capacity at boot, and whether it drains.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace openr_host {

// Capacity below which the bit for low capacity is set.  Objects shut the robot down then.  Chosen.
constexpr int kLowCapacityPercent = 10;

struct Battery {
  // Chosen: a full battery lasts 90 minutes, the running time of an ERS-210 in use.
  static constexpr int64_t kEmptyUs = int64_t{90} * 60 * 1'000'000;

  int percent = 100;   // capacity at boot, 1 to 100 % of the full one
  bool drains = true;  // loses 1 % every 54 s, down to 0 %; otherwise the percentage stays

  // Whether the bit for low capacity is set at boot.  Then it never changes, so no object is
  // notified.
  bool is_low_at_boot() const { return percent < kLowCapacityPercent; }

  // Remaining capacity in percent, `time_us` of virtual time after boot.
  int PercentAt(int64_t time_us) const;
};

// Reads "100%" (full, and stays full), "drain" (full at boot, and drains) or "1%" to "99%"
// (capacity at boot, and drains).  Returns "", or what is wrong with `text` and what was probably
// meant.
std::string ParseBattery(std::string_view text, Battery* battery);

}  // namespace openr_host
