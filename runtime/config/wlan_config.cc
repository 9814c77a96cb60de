#include "runtime/config/wlan_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "runtime/base/characters.h"
#include "runtime/base/spelling.h"
#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

// The longest host name and the longest name of a wireless network (ESSID) in WLANCONF.TXT, in
// characters (Installation Guide, 3.2.2).
constexpr size_t kHostNameMax = 8;
constexpr size_t kEssidMax = 32;

// Parses a number without a sign.  Returns -1 if `text` is not a number without a sign, or if the
// number is greater than `max`.
int ParseSmallNumber(std::string_view text, int max) {
  int value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = status == std::errc() && end == text.data() + text.size();
  return whole && IsDigit(text.front()) && value <= max ? value : -1;
}

// Stores an IPv4 address such as "10.0.1.100" in `*target`.  If `value` is no address, returns
// false and stores nothing.  The other functions Set...() of this file handle an invalid value in
// the same way.
bool SetAddress(std::string_view value, std::string* target) {
  std::string_view rest = value;
  for (int part = 0; part < 4; ++part) {
    const size_t dot = rest.find('.');
    if ((dot == std::string_view::npos) != (part == 3)) return false;
    if (ParseSmallNumber(rest.substr(0, dot), 255) < 0) return false;
    if (part < 3) rest.remove_prefix(dot + 1);
  }
  *target = value;
  return true;
}

bool SetFlag(std::string_view value, bool* target) {
  if (value != "0" && value != "1") return false;
  *target = value == "1";
  return true;
}

bool SetHostName(std::string_view value, std::string* target) {
  if (value.empty() || value.size() > kHostNameMax) return false;
  const bool plain =
      std::all_of(value.begin(), value.end(), [](char c) { return IsDigit(c) || IsLetter(c); });
  if (!plain || std::none_of(value.begin(), value.end(), IsLetter)) return false;
  *target = value;
  return true;
}

bool SetEssid(std::string_view value, std::string* target) {
  if (value.empty() || value.size() > kEssidMax) return false;
  *target = value;
  return true;
}

bool SetWepKey(std::string_view value, std::string* target) {
  const bool is_hex = value.substr(0, 2) == "0x" && (value.size() == 12 || value.size() == 28) &&
                      std::all_of(value.begin() + 2, value.end(), IsHexDigit);
  if (!is_hex && value.size() != 5 && value.size() != 13) return false;
  *target = value;
  return true;
}

bool SetNumber(std::string_view value, int min, int max, int* target) {
  const int number = ParseSmallNumber(value, max);
  if (number < min) return false;
  *target = number;
  return true;
}

bool SetDomain(std::string_view value, std::string* target) {
  if (value.empty() || value.find(' ') != std::string_view::npos) return false;
  *target = value;
  return true;
}

struct Key {
  const char* name;
  const char* expected;  // completes the message "KEY must be ..."
  bool (*set)(std::string_view value, WlanConfig* config);
};

using View = std::string_view;
using Config = WlanConfig;

constexpr const char* kAddress = "a dotted address such as 10.0.1.100";
constexpr const char* kFlag = "0 or 1";

constexpr Key kKeys[] = {
    {"HOSTNAME", "1 to 8 letters and digits, at least one letter",
     [](View v, Config* c) { return SetHostName(v, &c->hostname); }},
    {"ETHER_IP", kAddress, [](View v, Config* c) { return SetAddress(v, &c->ether_ip); }},
    {"ETHER_NETMASK", kAddress, [](View v, Config* c) { return SetAddress(v, &c->ether_netmask); }},
    {"IP_GATEWAY", kAddress, [](View v, Config* c) { return SetAddress(v, &c->ip_gateway); }},
    {"ESSID", "1 to 32 characters", [](View v, Config* c) { return SetEssid(v, &c->essid); }},
    {"WEPENABLE", kFlag, [](View v, Config* c) { return SetFlag(v, &c->wep_enable); }},
    {"WEPKEY", "5 or 13 characters, or 0x and 10 or 26 hexadecimal digits",
     [](View v, Config* c) { return SetWepKey(v, &c->wep_key); }},
    {"APMODE", "0 (ad hoc demo), 1 (infrastructure) or 2 (automatic)",
     [](View v, Config* c) { return SetNumber(v, 0, 2, &c->ap_mode); }},
    {"CHANNEL", "a number from 1 to 11",
     [](View v, Config* c) { return SetNumber(v, 1, 11, &c->channel); }},
    {"DNS_SERVER_1", kAddress, [](View v, Config* c) { return SetAddress(v, &c->dns_server_1); }},
    {"DNS_DEFDNAME", "a domain name",
     [](View v, Config* c) { return SetDomain(v, &c->dns_default_domain); }},
    {"USE_DHCP", kFlag, [](View v, Config* c) { return SetFlag(v, &c->use_dhcp); }},
};

const Key* FindKey(std::string_view name) {
  for (const Key& key : kKeys) {
    if (name == key.name) return &key;
  }
  return nullptr;
}

std::vector<std::string> KeyNames() {
  std::vector<std::string> names;
  for (const Key& key : kKeys) names.push_back(key.name);
  return names;
}

std::string_view TrimEnd(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

void ReadSetting(const FilePosition& line, WlanResult* result) {
  const std::string_view text = TrimEnd(line.text);
  const size_t equals = text.find('=');
  const auto error = [&](size_t offset, std::string message) {
    result->diagnostics.push_back(
        ErrorAt(AtColumn(line, static_cast<int>(offset) + 1), std::move(message)));
  };
  if (equals == std::string_view::npos) {
    error(0, "no '='; write KEY=VALUE, or '#' at the start of a comment");
    return;
  }
  const std::string_view name = text.substr(0, equals);
  const std::string_view value = text.substr(equals + 1);
  const size_t blank = text.substr(0, equals + 2).find_first_of(" \t");
  if (blank != std::string_view::npos) {
    error(blank,
          "blank beside the key or '='; write KEY=VALUE without blanks, the robot does not "
          "accept them");
    return;
  }
  const Key* const key = FindKey(name);
  if (key == nullptr) {
    result->diagnostics.push_back(WarningAt(
        line, fmt::format("unknown key '{}' is ignored{}", name, DidYouMean(name, KeyNames()))));
    return;
  }
  if (!key->set(value, &result->config)) {
    error(equals + 1, fmt::format("{} must be {}", name, key->expected));
    return;
  }
  if (std::find(result->keys.begin(), result->keys.end(), name) == result->keys.end()) {
    result->keys.emplace_back(name);
  } else {
    result->diagnostics.push_back(
        WarningAt(line, fmt::format("{} is set a second time; this line holds", name)));
  }
}

}  // namespace

WlanResult ParseWlanConfig(const std::string& file, std::string_view text) {
  WlanResult result;
  for (const FilePosition& line : SplitLines(file, text, &result.diagnostics)) {
    const std::string_view content = TrimEnd(line.text);
    if (content.empty() || content.front() == '#') continue;
    ReadSetting(line, &result);
  }
  return result;
}

}  // namespace openr_host
