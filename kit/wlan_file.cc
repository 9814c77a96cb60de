#include "kit/wlan_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>

#include "kit/text_files.h"

namespace openr_host {
namespace {

bool Always(const WlanConfig&) { return true; }
bool WithoutDhcp(const WlanConfig& config) { return !config.use_dhcp; }
bool WithWep(const WlanConfig& config) { return config.wep_enable; }
// Returns whether the network may be an ad hoc network.  Only such a network needs a channel from
// the user; an access point has its own channel (Installation Guide 3.2.2).
bool MayBeAdHoc(const WlanConfig& config) { return config.ap_mode != 1; }

// Returns an address such as "10.0.1.100" as a number.  The address is valid, because the parser
// has accepted it before.
uint32_t AddressOf(const std::string& text) {
  uint32_t address = 0;
  const char* at = text.c_str();
  for (int part = 0; part < 4; ++part) {
    char* end = nullptr;
    address = (address << 8) | static_cast<uint32_t>(std::strtoul(at, &end, 10));
    at = *end == '.' ? end + 1 : end;
  }
  return address;
}

std::string Flag(bool value) { return value ? "1" : "0"; }

// Returns `answer`, an answer to a question about the network, as it is written in WLANCONF.TXT: 1
// for yes and 0 for no.  Other answers stay as they are.
std::string FlagOf(const std::string& answer) {
  const std::string word = LowerCase(answer);
  return word == "yes" || word == "y" ? "1" : word == "no" || word == "n" ? "0" : answer;
}

// Returns the value of a setting of WLANCONF.TXT as a person reads it: "yes" or "no" where the file
// has 1 or 0.
std::string ShownValue(const WlanConfig& config, const WlanQuestion& question) {
  const std::string value = WlanValue(config, question.key);
  return !question.is_yes_no ? value : value == "1" ? "yes" : "no";
}

bool Sets(const WlanResult& settings, const char* key) {
  return std::find(settings.keys.begin(), settings.keys.end(), key) != settings.keys.end();
}

// Collects warnings about settings that do not fit together although each of them is valid.
class SettingsCheck {
 public:
  explicit SettingsCheck(std::string file) { place_.file = std::move(file); }
  void Warn(std::string text) { warnings_.push_back(WarningAt(place_, std::move(text))); }
  std::vector<Diagnostic> Take() { return std::move(warnings_); }

 private:
  FilePosition place_;
  std::vector<Diagnostic> warnings_;
};

void CheckAddresses(const WlanConfig& config, SettingsCheck* check) {
  const uint32_t ip = AddressOf(config.ether_ip), mask = AddressOf(config.ether_netmask);
  // Warns if the netmask has a 1 bit after a 0 bit, because no network has such a mask.
  if (std::popcount(mask) != std::countl_one(mask)) {
    check->Warn(fmt::format("ETHER_NETMASK {} is no mask of a network, which is like 255.255.255.0",
                            config.ether_netmask));
    return;
  }
  // A network of one or two addresses (mask /32 or /31) has neither a network address nor a
  // broadcast address, so the robot may have any address in it.
  const bool has_hosts = mask < 0xfffffffe;
  if (has_hosts && ((ip & ~mask) == 0 || (ip | mask) == 0xffffffff)) {
    check->Warn(
        fmt::format("ETHER_IP {} is the address of the network {} itself or of all in it; "
                    "give the robot another one",
                    config.ether_ip, config.ether_netmask));
  }
  if (((ip ^ AddressOf(config.ip_gateway)) & mask) != 0) {
    check->Warn(
        fmt::format("IP_GATEWAY {} is not in the robot's network ({}, {}); write the "
                    "robot's own address if there is no gateway",
                    config.ip_gateway, config.ether_ip, config.ether_netmask));
  }
}

}  // namespace

const std::vector<WlanQuestion>& WlanQuestions() {
  static const std::vector<WlanQuestion> kQuestions = {
      {"HOSTNAME", "--hostname", "Name of the robot, up to 8 letters and digits", false, &Always},
      {"ESSID", "--essid", "Name of the wireless network (ESSID)", false, &Always},
      {"WEPENABLE", "--wep", "Is it encrypted by WEP? yes or no; the robot knows nothing else",
       true, &Always},
      {"WEPKEY", "--wep-key", "Its key: 5 or 13 characters, or 0x and 10 or 26 hexadecimal digits",
       false, &WithWep},
      {"APMODE", "--mode", "1: by an access point, 0: ad hoc, 2: whichever is there", false,
       &Always},
      {"CHANNEL", "--channel", "Channel of the ad hoc network, 1 to 11", false, &MayBeAdHoc},
      {"USE_DHCP", "--dhcp", "Does the network give the robot its address (DHCP)? yes or no", true,
       &Always},
      {"ETHER_IP", "--ip", "Address of the robot", false, &WithoutDhcp},
      {"ETHER_NETMASK", "--netmask", "Mask of its network", false, &WithoutDhcp},
      {"IP_GATEWAY", "--gateway", "Gateway to other networks; the robot's own address if none",
       false, &WithoutDhcp},
      {"DNS_SERVER_1", "--dns", "Server for names (DNS); nothing if none", false, &WithoutDhcp},
      {"DNS_DEFDNAME", "--domain", "Domain of names without a dot; nothing if none", false,
       &WithoutDhcp},
  };
  return kQuestions;
}

std::string SetWlanKey(const std::string& key, const std::string& value, WlanConfig* config) {
  // Checks the value of the setting `key` with the parser of WLANCONF.TXT, because only the parser
  // knows which values are allowed.
  const WlanResult result = ParseWlanConfig("", key + "=" + value);
  if (!result.diagnostics.empty()) return result.diagnostics[0].message;
  // Makes a new text of WLANCONF.TXT with the values of all keys, and lets the parser read this
  // text.  The parser gives each key that is not in the text the robot's default.  So a text with
  // only `key` would lose the other values of `config`.
  std::string text;
  for (const WlanQuestion& other : WlanQuestions()) {
    const std::string old = other.key == key ? value : WlanValue(*config, other.key);
    if (!old.empty()) text += fmt::format("{}={}\n", other.key, old);
  }
  *config = ParseWlanConfig("", text).config;
  return "";
}

std::string WlanValue(const WlanConfig& config, const std::string& key) {
  if (key == "HOSTNAME") return config.hostname;
  if (key == "ESSID") return config.essid;
  if (key == "WEPENABLE") return Flag(config.wep_enable);
  if (key == "WEPKEY") return config.wep_key;
  if (key == "APMODE") return std::to_string(config.ap_mode);
  if (key == "CHANNEL") return std::to_string(config.channel);
  if (key == "USE_DHCP") return Flag(config.use_dhcp);
  if (key == "ETHER_IP") return config.ether_ip;
  if (key == "ETHER_NETMASK") return config.ether_netmask;
  if (key == "IP_GATEWAY") return config.ip_gateway;
  if (key == "DNS_SERVER_1") return config.dns_server_1;
  return config.dns_default_domain;
}

bool AskForWlan(
    const std::function<std::optional<std::string>(const std::string&, const std::string&)>& ask,
    const std::function<void(const std::string&)>& refuse, WlanConfig* config) {
  for (const WlanQuestion& question : WlanQuestions()) {
    while (question.is_asked(*config)) {
      const auto answer = ask(question.question, ShownValue(*config, question));
      if (!answer) return false;
      if (answer->empty()) break;
      const std::string value = question.is_yes_no ? FlagOf(*answer) : *answer;
      const std::string problem = SetWlanKey(question.key, value, config);
      if (problem.empty()) break;
      refuse(question.is_yes_no ? "answer yes or no" : problem);
    }
  }
  return true;
}

std::string WlanText(const WlanConfig& config) {
  std::string text =
      "# Network of the robot: KEY=VALUE, no blanks around '='.  The robot reads this file at\r\n"
      "# /MS/OPEN-R/SYSTEM/CONF/WLANCONF.TXT and nowhere else.\r\n";
  for (const WlanQuestion& question : WlanQuestions()) {
    const std::string value = WlanValue(config, question.key);
    if (!value.empty() && question.is_asked(config))
      text += fmt::format("{}={}\r\n", question.key, value);
  }
  return text;
}

std::vector<Diagnostic> CheckWlanSettings(const std::string& file, const WlanResult& settings) {
  // Gives no warnings if the file has errors.  A setting in a line with an error keeps its initial
  // value, so a warning would be about a value that is not in the file.
  const bool has_errors = std::any_of(
      settings.diagnostics.begin(), settings.diagnostics.end(),
      [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::kError; });
  if (has_errors) return {};
  const WlanConfig& config = settings.config;
  SettingsCheck check(file);
  if (config.use_dhcp) {
    if (Sets(settings, "ETHER_IP"))
      check.Warn("ETHER_IP has no effect with USE_DHCP=1: the network gives the address");
  } else {
    CheckAddresses(config, &check);
    if (!config.dns_default_domain.empty() && config.dns_server_1.empty())
      check.Warn("DNS_DEFDNAME has no effect without DNS_SERVER_1");
  }
  if (!config.wep_enable && Sets(settings, "WEPKEY"))
    check.Warn("WEPKEY has no effect with WEPENABLE=0");
  if (config.wep_enable && Sets(settings, "WEPENABLE") && !Sets(settings, "WEPKEY"))
    check.Warn("WEPENABLE is 1 and there is no WEPKEY; the robot takes that of Sony's file, AIBO2");
  if (config.ap_mode == 1 && Sets(settings, "CHANNEL"))
    check.Warn("CHANNEL has no effect with APMODE=1: it is for ad hoc networks");
  return check.Take();
}

}  // namespace openr_host
