// The types of the data in vectors, and the header with which every vector begins.  A vector is
// shared memory with commands, sensor values, images or sounds.
#ifndef OPENR_FORMATS_VECTOR_INFO_H_INCLUDED
#define OPENR_FORMATS_VECTOR_INFO_H_INCLUDED

#include <MemoryRegion.h>
#include <OPENR/OPENR.h>

// The type of a single value, of a command for a primitive (a device of the robot), or of a whole
// vector (shared memory with such data).
typedef longword ODataType;
const ODataType odataUNDEF = 0;
const ODataType odataNO_DIMENSION = 1;
const ODataType odataLENGTH = 2;
const ODataType odataMASS = 3;
const ODataType odataTIME = 4;
const ODataType odataDATE = 5;
const ODataType odataANGULAR = 6;
const ODataType odataVELOCITY = 7;
const ODataType odataFORCE = 8;
const ODataType odataACCELERATION = 9;
const ODataType odataANGULAR_VELOCITY = 10;
const ODataType odataTEMPERATURE = 11;
const ODataType odataPRESSURE = 12;
const ODataType odataPERCENTAGE = 13;
const ODataType odataSWITCH = 14;
const ODataType odataLED = 15;
const ODataType odataSOUND = 16;
const ODataType odataIMAGE = 17;
const ODataType odataJOINT_VALUE = 18;
const ODataType odataFBK_YCrCb = 19;
const ODataType odataFBK_CDT = 20;
const ODataType odataCDT = 21;
const ODataType odataPRIMITIVE_INFO = 22;
const ODataType odataCPC_INFO = 23;
const ODataType odataFBK_YCrCb_HPF = 24;

const ODataType odataJOINT_COMMAND = 256;
const ODataType odataCAMERA_COMMAND = 257;
const ODataType odataLED_COMMAND = 258;
const ODataType odataJOINT_COMMAND2 = 259;
const ODataType odataLED_COMMAND2 = 260;
const ODataType odataJOINT_COMMAND3 = 261;
const ODataType odataJOINT_COMMAND4 = 262;
const ODataType odataLED_COMMAND3 = 263;

const ODataType odataRAW_JOINT_COMMAND = 512;
const ODataType odataRAW_CAMERA_COMMAND = 513;
const ODataType odataRAW_LED_COMMAND = 514;
const ODataType odataRAW_JOINT_COMMAND2 = 515;

const ODataType odataCOMMAND_VECTOR = 1024;
const ODataType odataSENSOR_FRAME_VECTOR = 1025;
const ODataType odataSOUND_VECTOR = 1026;
const ODataType odataFBKIMAGE_VECTOR = 1027;
const ODataType odataCDT_VECTOR = 1028;
const ODataType odataPRIMITIVE_MAP = 1029;
const ODataType odataCPC_TREE = 1030;

const ODataType odataDONT_CARE = 0xffffffff;

// A pointer of the robot, which has 32 bits.  On the host the pointers in vectors have no meaning
// and are always 0.  Converts to void* and from void*; bits beyond 32 are lost.
struct OPhysAddr {
  longword address;

  OPhysAddr& operator=(void* pointer) {
    address = static_cast<longword>(reinterpret_cast<size_t>(pointer));
    return *this;
  }
  operator void*() const { return reinterpret_cast<void*>(static_cast<size_t>(address)); }
};

const size_t odataOPTIONAL_MAX = 128;

// The header of a vector, 192 bytes.  A program makes an RCRegion from memRegionID, offset, the
// vector's address and totalSize, so these four values must be enough to find the memory.
struct ODataVectorInfo {
  MemoryRegionID memRegionID;  // region that holds the vector
  OPhysAddr physAddr;          // set by the robot for images and sound only; 0 on the host
  longword offset;             // offset in bytes from the start of the region to the vector
  longword totalSize;          // size of the whole vector in bytes
  ODataType type;              // a type odata..._VECTOR
  longword infoOffset;  // offset in bytes from the start of the vector to the first info block, 192
  longword infoSize;    // size of an info block in bytes
  longword maxNumData;  // number of info blocks
  longword numData;     // number of info blocks in use
  OVRSyncKey syncKey;   // ovrsynckeyUNDEF if the vector waits for no other vector
  longword wait;        // number of frames of 8 ms by which output is delayed
  longword optOffset;   // index of the first valid byte of `optional`
  longword optSize;     // number of valid bytes of `optional`
  longword padding[3];
  byte optional[odataOPTIONAL_MAX];  // copied from command vectors to sensor vectors
};

#endif  // OPENR_FORMATS_VECTOR_INFO_H_INCLUDED
