// IPAddress: an IPv4 address, stored as a number of 32 bits with the first octet highest.
#include <IPAddress.h>
#include <IPv4Types.h>
#include <OPENR/OSyslog.h>
#include <fmt/format.h>

#include <cstring>
#include <string>

#include "runtime/base/parse_ip_address.h"

const IPAddress IP_ADDR_ANY(0u);
const IPAddress IP_ADDR_BROADCAST(0xffffffffu);

namespace {

std::string Text(uint32 a) {
  return fmt::format("{}.{}.{}.{}", a >> 24, a >> 16 & 255, a >> 8 & 255, a & 255);
}

}  // namespace

IPAddress::IPAddress(byte a, byte b, byte c, byte d)
    : address_(uint32{a} << 24 | uint32{b} << 16 | uint32{c} << 8 | uint32{d}) {}

IPAddress::IPAddress(const char* text)
    : address_(text == nullptr ? 0 : openr_host::ParseIpAddress(text).value_or(0)) {}

bool IPAddress::InMulticast() const { return address_ >> 28 == 14; }
bool IPAddress::InBroadcast() const { return address_ == 0xffffffffu; }
bool IPAddress::InLoop() const { return address_ >> 24 == 127; }
bool IPAddress::AllHostsGroup() const { return address_ == 0xe0000001u; }

char* IPAddress::GetAsString(char* text) const {
  // `text` has room for an address: 15 characters and a NUL.
  return std::strcpy(text, Text(address_).c_str());
}

void IPAddress::print() const { osysprint("%s\n", Text(address_).c_str()); }

std::ostream& operator<<(std::ostream& out, const IPAddress& address) {
  return out << Text(address.Address());
}
