// The type of an IPv4 address and the type of a port number.
#ifndef OPENR_IPADDRESS_H_INCLUDED
#define OPENR_IPADDRESS_H_INCLUDED

#include <antTypes.h>

#include <iostream>

typedef uint16 Port;  // in the byte order of the host

// An IPv4 address, 4 bytes in the byte order of the host: 10.0.1.2 is 0x0a000102.
class IPAddress {
 public:
  IPAddress() : address_(0) {}
  IPAddress(uint32 address) : address_(address) {}
  IPAddress(int address) : address_(static_cast<uint32>(address)) {}
  IPAddress(byte a, byte b, byte c, byte d);  // makes the address a.b.c.d

  // Parses four decimal numbers of 0..255 with dots between them; any other text gives address 0.
  IPAddress(const char* text);

  uint32 Address() const { return address_; }

  bool operator==(const IPAddress& other) const { return address_ == other.address_; }
  bool operator!=(const IPAddress& other) const { return address_ != other.address_; }
  bool operator<(const IPAddress& other) const { return address_ < other.address_; }
  IPAddress operator&(const IPAddress& other) const { return address_ & other.address_; }
  IPAddress operator^(const IPAddress& other) const { return address_ ^ other.address_; }

  bool InMulticast() const;    // whether the address is 224.0.0.0 to 239.255.255.255
  bool InBroadcast() const;    // whether the address is 255.255.255.255
  bool InLoop() const;         // whether the address is 127.0.0.0 to 127.255.255.255
  bool AllHostsGroup() const;  // whether the address is 224.0.0.1

  // Writes the address in the form "10.0.1.2" into `text`, which needs room for 16 characters.
  // Returns `text`.
  char* GetAsString(char* text) const;

  // Prints the address on the console, in the form "10.0.1.2".
  void print() const;

 private:
  uint32 address_;
};

std::ostream& operator<<(std::ostream& out, const IPAddress& address);

#endif  // OPENR_IPADDRESS_H_INCLUDED
