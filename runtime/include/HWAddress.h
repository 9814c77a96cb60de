// The hardware address of a network device, together with the type of the address.
#ifndef OPENR_HWADDRESS_H_INCLUDED
#define OPENR_HWADDRESS_H_INCLUDED

#include <Types.h>

enum HWAddressType {
  HWADDRESS_INVALID = 0,
  HWADDRESS_MAC = 1  // 6 octets, as in EtherMACAddress
};

#define HWADDRESS_MAX_LEN 32  // in bytes; inferred from the size of the structure

// A hardware address, 40 bytes.
struct HWAddress {
  HWAddressType hwType;
  slongword hwLen;  // number of bytes of hwContent in use
  byte hwContent[HWADDRESS_MAX_LEN];
};

#endif  // OPENR_HWADDRESS_H_INCLUDED
