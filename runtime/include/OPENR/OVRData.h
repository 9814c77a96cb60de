// Refers to a data vector in messages between the OPENR:: functions and the system.
#ifndef OPENR_OVRDATA_H_INCLUDED
#define OPENR_OVRDATA_H_INCLUDED

#include <OPENR/ODataFormats.h>
#include <OPENR/OStatus.h>

struct OVRData {
  OStatus status;
  ODataType type;
  MemoryRegionID dataVectorID;
  longword offset;  // bytes from the start of the region
};

// The name is ours; the number is the robot's.
const size_t ovrdataMAX_PER_MESSAGE = 8;

#endif  // OPENR_OVRDATA_H_INCLUDED
