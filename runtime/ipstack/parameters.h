// The settings of the network stack, which programs read by key with antEnvInitGetParamMsg.
//
// The keys are those of WLANCONF.TXT.  Sony documents only ETHER_IP, whose value is a text.  Our
// choice: programs can also read the other keys, and the values of flags and numbers are Int32.
#pragma once

#include <antEnvMsg.h>

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "runtime/config/wlan_config.h"

namespace openr_host {

class Hasher;
class MemoryStick;

class Parameters {
 public:
  // Reads WLANCONF.TXT of `stick`, or WLANDFLT.TXT if there is no WLANCONF.TXT.  If neither file
  // exists, or if `stick` is null, uses the values of Sony's WLANDFLT.TXT.  `address` replaces
  // ETHER_IP unless it is "".
  Parameters(MemoryStick* stick, const std::string& address);

  // Looks up the setting of the network stack whose key `message` names and stores the value in
  // `message`.  Returns ANT_REGISTRY_NO_KEY for an unknown key.  A text is cut to
  // ANTENV_VALUE_LENGTH_MAX.
  antError Get(antEnvInitGetParamMsg* message) const;

  // Changes the setting of the network stack whose key is in `message`.  Returns
  // ANT_REGISTRY_WRONG_TYPE unless the value is a text or a number.
  antError Set(const antEnvInitSetParamMsg& message);

  const WlanConfig& wlan() const { return wlan_; }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  void HashState(Hasher* hasher) const;

 private:
  WlanConfig wlan_;
  std::vector<Diagnostic> diagnostics_;
  std::map<std::string, std::variant<int32_t, std::string>> values_;
};

// Converts "10.0.1.2" to 0x0a000102.  Returns 0 if `text` is no address.
uint32_t IpFromText(const std::string& text);

}  // namespace openr_host
