// The stack's parameters: what antEnvInitGetParamMsg answers, by key.
//
// Keys are those of WLANCONF.TXT.  ETHER_IP as text is documented; that the others can be
// read, and the flags and numbers as Int32, is our choice.
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
  // Reads WLANCONF.TXT of the stick, else WLANDFLT.TXT; without either, and without a
  // stick (null), the values of Sony's file.  `address`, unless empty, replaces ETHER_IP.
  Parameters(MemoryStick* stick, const std::string& address);

  // ANT_REGISTRY_NO_KEY for an unknown key.  Text is cut to ANTENV_VALUE_LENGTH_MAX.
  antError Get(antEnvInitGetParamMsg* message) const;

  // ANT_REGISTRY_WRONG_TYPE for a type that is none.
  antError Set(const antEnvInitSetParamMsg& message);

  const WlanConfig& wlan() const { return wlan_; }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  void HashState(Hasher* hasher) const;

 private:
  WlanConfig wlan_;
  std::vector<Diagnostic> diagnostics_;
  std::map<std::string, std::variant<int32_t, std::string>> values_;
};

// 0x0a000102 for "10.0.1.2"; 0 for what is no address.
uint32_t IpFromText(const std::string& text);

}  // namespace openr_host
