// IPAddress: an IPv4 address, stored as a number of 32 bits with the first octet highest.
#include <IPAddress.h>
#include <IPv4Types.h>
#include <OPENR/OSyslog.h>
#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <optional>
#include <string>

const IPAddress IP_ADDR_ANY(0u);
const IPAddress IP_ADDR_BROADCAST(0xffffffffu);

namespace {

// Parses a text such as "192.168.0.1": four numbers of 0 to 255 with dots between them.  Returns
// nullopt if `text` is anything else.
std::optional<uint32> Parse(const char* text) {
  const char* const end = text + std::strlen(text);
  uint32 address = 0;
  for (int i = 0; i < 4; ++i) {
    if (i > 0 && (text == end || *text++ != '.')) return std::nullopt;
    unsigned number = 0;
    const auto [rest, error] = std::from_chars(text, end, number);
    if (error != std::errc() || number > 255) return std::nullopt;
    address = address << 8 | number;
    text = rest;
  }
  if (text != end) return std::nullopt;
  return address;
}

std::string Text(uint32 a) {
  return fmt::format("{}.{}.{}.{}", a >> 24, a >> 16 & 255, a >> 8 & 255, a & 255);
}

}  // namespace

IPAddress::IPAddress(byte a, byte b, byte c, byte d)
    : address_(uint32{a} << 24 | uint32{b} << 16 | uint32{c} << 8 | uint32{d}) {}

IPAddress::IPAddress(const char* text) : address_(text == nullptr ? 0 : Parse(text).value_or(0)) {}

bool IPAddress::InMulticast() const { return address_ >> 28 == 14; }
bool IPAddress::InBroadcast() const { return address_ == 0xffffffffu; }
bool IPAddress::InLoop() const { return address_ >> 24 == 127; }
bool IPAddress::AllHostsGroup() const { return address_ == 0xe0000001u; }

char* IPAddress::GetAsString(char* text) const {
  return std::strcpy(text, Text(address_).c_str());  // fits `text`: at most 15 characters and NUL
}

void IPAddress::print() const { osysprint("%s\n", Text(address_).c_str()); }

std::ostream& operator<<(std::ostream& out, const IPAddress& address) {
  return out << Text(address.Address());
}
