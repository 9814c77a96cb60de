// How full a robot's battery is when it boots, and whether it drains.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace openr_host {

// Below it the bit for low capacity is set, at which objects shut the robot down.  Chosen.
constexpr int kLowCapacityPercent = 10;

struct Battery {
  // Chosen: a full battery lasts 90 minutes, the running time of an ERS-210 in use.
  static constexpr int64_t kEmptyUs = int64_t{90} * 60 * 1'000'000;

  int percent = 100;   // of the full capacity, at boot: 1 to 100
  bool drains = true;  // 1 % less every 54 s, down to 0 %; else it stays as it is

  // Whether the bit for low capacity is set from the boot on, so that no object hears of a change.
  bool is_low_at_boot() const { return percent < kLowCapacityPercent; }

  // Remaining capacity in percent after so much virtual time.
  int PercentAt(int64_t time_us) const;
};

// "100%": full, and stays so.  "drain": full at boot.  "1%" to "99%": so much at boot, and drains
// as fast.  Returns "" or what is wrong with `text`, and what was probably meant.
std::string ParseBattery(std::string_view text, Battery* battery);

}  // namespace openr_host
