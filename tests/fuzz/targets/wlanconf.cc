// The fuzz target wlanconf: WLANCONF.TXT.
#include <cstdint>

#include "runtime/config/wlan_config.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::wlanconf(std::string_view bytes) {
  const WlanResult result = ParseWlanConfig("WLANCONF.TXT", bytes);
  Render(result.diagnostics);
  FuzzCheck(result.config.hostname.size() <= 8 && result.config.essid.size() <= 32, "a length");
  FuzzCheck(result.config.channel >= 1 && result.config.channel <= 11, "a channel");
  ReachFuzzState(static_cast<uint64_t>(result.config.channel * 3 + result.config.ap_mode));
  return result.config.channel > 5 && result.config.ap_mode == 0;
}

}  // namespace openr_host
