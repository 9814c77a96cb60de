// OVRData: names the region with a vector, in messages between the OPENR:: functions and the
// system.
#ifndef OPENR_OVRDATA_H_INCLUDED
#define OPENR_OVRDATA_H_INCLUDED

#include <OPENR/ODataFormats.h>
#include <OPENR/OStatus.h>

// The largest number of vectors to which one message between an OPENR:: function and the system
// refers.
const size_t ovrdataMAX_SIZE = 8;

struct OVRData {
  OStatus status;
  ODataType type;
  MemoryRegionID dataVectorID;
  longword offset;  // offset of the vector in bytes from the start of the region

  OVRData() { Set(oSUCCESS, odataUNDEF, 0); }
  OVRData(ODataType dataType, MemoryRegionID id) { Set(dataType, id); }
  OVRData(OStatus result, ODataType dataType, MemoryRegionID id) { Set(result, dataType, id); }

  void Set(ODataType dataType, MemoryRegionID id) { Set(oSUCCESS, dataType, id); }
  void Set(OStatus result, ODataType dataType, MemoryRegionID id) {
    status = result;
    type = dataType;
    dataVectorID = id;
    offset = 0;
  }
};

#endif  // OPENR_OVRDATA_H_INCLUDED
