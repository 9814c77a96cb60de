// Functions that read the state of the wireless card (ERA201D1.h).  Because the host has no such
// card, they return the settings in WLANCONF.TXT, and constants that mean a perfect connection.
#include <ERA201D1.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "runtime/core/current.h"
#include "runtime/ipstack/ip_stack.h"

using openr_host::ApiScope;
using openr_host::IpStack;
using openr_host::IpStackOptions;
using openr_host::WlanConfig;

namespace {

// The length of a radio frame above which the card first asks the other stations for permission to
// send it (RTS), and the length above which the card splits a frame.  These are the default values
// of 802.11b.  No frame is so long, so a card with these values never asks and never splits.
constexpr int32 kRtsThreshold = 2347;
constexpr int32 kFragmentationThreshold = 2346;

// Clears `msg`.  If the robot has a wireless card and its driver, calls `fill`, which stores the
// state of the card in `msg`.  Sets msg->status to ETHER_OK, or to an error if the card or the
// driver is missing, and returns this status.
template <typename Msg, typename Fill>
EtherStatus Ask(Msg* msg, Fill fill) {
  const ApiScope scope;
  std::memset(static_cast<void*>(msg), 0, sizeof *msg);
  const IpStack* const stack = IpStack::OfCurrent();
  using Card = IpStackOptions::Card;
  if (stack == nullptr || stack->options().card == Card::kNoCard) {
    msg->status = ETHER_INVALID_PORT;
  } else if (stack->options().card == Card::kNoDriver) {
    msg->status = ETHER_UNSUPPORTED;
  } else {
    fill(*stack);
    msg->status = ETHER_OK;
  }
  return msg->status;
}

template <size_t N>
void CopyText(char (&to)[N], const std::string& from) {
  std::memcpy(to, from.data(), std::min(from.size(), N - 1));
}

}  // namespace

extern "C" {

EtherStatus ERA201D1_GetMACAddress(EtherDriverGetMACAddressMsg* msg) {
  return Ask(msg, [msg](const IpStack& stack) {
    // Makes a MAC address that no real card has: the first octet, 0x02, marks an address that a
    // user has chosen (IEEE 802, locally administered).  The last octets are the number of the
    // robot, so each robot has an address of its own.
    const int robot = stack.host().robot + 1;
    const byte octets[6] = {0x02,
                            0x00,
                            0x00,
                            static_cast<byte>(robot >> 16),
                            static_cast<byte>(robot >> 8),
                            static_cast<byte>(robot)};
    std::memcpy(msg->address.octet, octets, sizeof octets);
  });
}

EtherStatus ERA201D1_GetEtherStatistics(EtherDriverGetStatisticsMsg* msg) {
  return Ask(msg, [](const IpStack&) {});  // all error counters are 0, because the host has no card
}

EtherStatus ERA201D1_GetWLANSettings(EtherDriverGetWLANSettingsMsg* msg) {
  return Ask(msg, [msg](const IpStack& stack) {
    const WlanConfig& wlan = stack.parameters().wlan();
    msg->mode = wlan.ap_mode == 0 ? ETHER_WLAN_MODE_ADHOC : ETHER_WLAN_MODE_AP;
    CopyText(msg->essid, wlan.essid);
    CopyText(msg->stationName, wlan.hostname);
    msg->channel = wlan.channel;
    msg->encryption = wlan.wep_enable ? ETHER_WLAN_ENC_WEP : ETHER_WLAN_ENC_OFF;
    msg->rate = ETHER_WLAN_RATE_AUTO;
    msg->rts = kRtsThreshold;
    msg->fragmentation = kFragmentationThreshold;
    msg->sensitivity = ETHER_WLAN_DENSITY_LOW;
  });
}

EtherStatus ERA201D1_GetWLANStatistics(EtherDriverGetWLANStatisticsMsg* msg) {
  return Ask(msg, [msg](const IpStack&) {
    msg->statistics.link = 100;
    msg->statistics.signal = 100;
  });
}

}  // extern "C"
