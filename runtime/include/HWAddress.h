// The address of a network device, of any kind.
#ifndef OPENR_HWADDRESS_H_INCLUDED
#define OPENR_HWADDRESS_H_INCLUDED

#include <Types.h>

enum HWAddressType {
  HWADDRESS_INVALID = 0,
  HWADDRESS_MAC = 1  // 6 octets, as in EtherMACAddress
};

#define HWADDRESS_MAX_LEN 32  // bytes; inferred from the size of the structure

// 40 bytes.
struct HWAddress {
  HWAddressType hwType;
  slongword hwLen;  // bytes used of hwContent
  byte hwContent[HWADDRESS_MAX_LEN];
};

#endif  // OPENR_HWADDRESS_H_INCLUDED
