// The battery of a robot: its capacity at boot, and whether it drains.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace openr_host {

// Remaining capacity, in percent, below which the robot sets its status bit for a low battery.
// Objects then shut the robot down.  The number is our choice.
constexpr int kLowCapacityPercent = 10;

struct Battery {
  // Time in which a full battery becomes empty: 90 minutes, the running time of an ERS-210 in use.
  // The number is our choice.
  static constexpr int64_t kEmptyUs = int64_t{90} * 60 * 1'000'000;

  int percent = 100;   // remaining capacity at boot, in percent of a full battery; 1 to 100
  bool drains = true;  // whether the battery loses 1 % every 54 s, down to 0 %

  // Returns whether the robot sets its status bit for a low battery at boot already.  Objects are
  // notified only when this bit changes, so they never hear of such a battery; the report of the
  // run then has a note about this.
  bool is_low_at_boot() const { return percent < kLowCapacityPercent; }

  // Returns the remaining capacity of the battery in percent, `time_us` of virtual time after boot.
  int PercentAt(int64_t time_us) const;
};

// Reads the text of the option --battery into `battery`.  With "100%", the battery is full at boot
// and stays full.  With "drain", it is full at boot and drains.  With "1%" to "99%", it has this
// capacity at boot and drains.  Returns "", or an error that names the mistake in `text` and, if it
// can be guessed, the text that was meant.
std::string ParseBattery(std::string_view text, Battery* battery);

}  // namespace openr_host
