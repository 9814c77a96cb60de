// Parses WLANCONF.TXT and WLANDFLT.TXT, the network settings of the robot.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// The network settings of a robot.  Initial values are those of WLANDFLT.TXT, the default file of
// the robot's system (Installation Guide 3.2.2), so an empty WLANCONF.TXT has the same effect as
// WLANDFLT.TXT.
struct WlanConfig {
  std::string hostname = "AIBO";        // up to 8 letters and digits
  std::string ether_ip = "10.0.1.100";  // an IPv4 address, as are ether_netmask and ip_gateway
  std::string ether_netmask = "255.255.255.0";
  std::string ip_gateway = "10.0.1.1";
  std::string essid = "AIBONET";  // name of the wireless network, up to 32 characters
  bool wep_enable = true;
  // The key of the wireless network as WLANCONF.TXT has it: characters, or 0x and hexadecimal
  // digits.
  std::string wep_key = "AIBO2";
  int ap_mode = 2;                 // kind of network: 0 ad hoc demo, 1 infrastructure, 2 automatic
  int channel = 3;                 // radio channel 1..11, used in ad hoc mode only
  std::string dns_server_1;        // "" if the file does not set it
  std::string dns_default_domain;  // "" if the file does not set it
  bool use_dhcp = false;
};

struct WlanResult {
  WlanConfig config;
  std::vector<std::string> keys;  // the keys that the file sets, in file order, each once
  std::vector<Diagnostic> diagnostics;
};

// Parses the KEY=VALUE lines of WLANCONF.TXT; a line that begins with '#' is a comment.  Reports a
// line with blanks around '=': the robot refuses such a line, although its guide shows it.  A bad
// line is reported and does not change its setting.  A key given twice is reported, and its last
// value is used.  An unknown key only causes a warning.  This file has no sections for robot
// designs, unlike other files.
WlanResult ParseWlanConfig(const std::string& file, std::string_view text);

}  // namespace openr_host
