#include "runtime/ipstack/parameters.h"

#include <IPAddress.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "runtime/base/hasher.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

constexpr char kConfFolder[] = "/MS/OPEN-R/SYSTEM/CONF/";

}  // namespace

uint32_t IpFromText(const std::string& text) { return IPAddress(text.c_str()).Address(); }

Parameters::Parameters(MemoryStick* stick, const std::string& address) {
  for (const char* name : {"WLANCONF.TXT", "WLANDFLT.TXT"}) {
    const auto text =
        stick == nullptr ? std::nullopt : stick->ReadFile(std::string(kConfFolder) + name);
    if (!text) continue;
    WlanResult result = ParseWlanConfig(name, *text);
    wlan_ = result.config;
    diagnostics_ = std::move(result.diagnostics);
    break;
  }
  if (!address.empty()) wlan_.ether_ip = address;
  values_ = {
      {"HOSTNAME", wlan_.hostname},
      {"ETHER_IP", wlan_.ether_ip},
      {"ETHER_NETMASK", wlan_.ether_netmask},
      {"IP_GATEWAY", wlan_.ip_gateway},
      {"ESSID", wlan_.essid},
      {"WEPENABLE", wlan_.wep_enable ? 1 : 0},
      {"APMODE", wlan_.ap_mode},
      {"CHANNEL", wlan_.channel},
      {"DNS_SERVER_1", wlan_.dns_server_1},
      {"DNS_DEFDNAME", wlan_.dns_default_domain},
      {"USE_DHCP", wlan_.use_dhcp ? 1 : 0},
  };
}

antError Parameters::Get(antEnvInitGetParamMsg* message) const {
  const auto found =
      values_.find(std::string(message->key, strnlen(message->key, sizeof message->key)));
  if (found == values_.end()) return ANT_REGISTRY_NO_KEY;
  std::memset(&message->value, 0, sizeof message->value);
  if (const int32_t* const number = std::get_if<int32_t>(&found->second)) {
    message->paramType = antEnv_InitParam_Int32;
    message->value.i32 = *number;
  } else {
    message->paramType = antEnv_InitParam_String;
    const std::string& text = std::get<std::string>(found->second);
    std::memcpy(message->value.str, text.data(),
                std::min(text.size(), sizeof message->value.str - 1));
  }
  return ANT_SUCCESS;
}

antError Parameters::Set(const antEnvInitSetParamMsg& message) {
  const std::string key(message.key, strnlen(message.key, sizeof message.key));
  if (message.paramType == antEnv_InitParam_Int32) {
    values_[key] = message.value.i32;
  } else if (message.paramType == antEnv_InitParam_String) {
    values_[key] =
        std::string(message.value.str, strnlen(message.value.str, sizeof message.value.str));
  } else {
    return ANT_REGISTRY_WRONG_TYPE;
  }
  return ANT_SUCCESS;
}

void Parameters::HashState(Hasher* hasher) const {
  for (const auto& [key, value] : values_) {
    hasher->AddText(key);
    if (const int32_t* const number = std::get_if<int32_t>(&value)) {
      hasher->Add(*number);
    } else {
      hasher->AddText(std::get<std::string>(value));
    }
  }
}

}  // namespace openr_host
