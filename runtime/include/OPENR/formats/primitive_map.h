// Vectors that describe the robot's devices (primitives) and the components of its body; rarely
// used, mostly by the system.
#ifndef OPENR_FORMATS_PRIMITIVE_MAP_H_INCLUDED
#define OPENR_FORMATS_PRIMITIVE_MAP_H_INCLUDED

#include <OPENR/formats/vector_info.h>

// Describes one primitive, a device of the robot such as a joint.  This struct has 160 bytes.
struct OPrimitiveInfo {
  ODataType type;  // the type odataPRIMITIVE_INFO
  OPrimitiveID primitiveID;
  OPrimitiveType primitiveType;
  OSensorType sensorType;
  longword primitiveStatus;
  longword padding[3];
  char locator[ovrPATH_MAX + 1];
};

struct OPrimitiveMapData {
  ODataVectorInfo vectorInfo;
  OPrimitiveInfo info[1];  // in memory the array has vectorInfo.maxNumData elements

  void SetNumData(size_t n) { vectorInfo.numData = static_cast<longword>(n); }
  OPrimitiveInfo* GetInfo(int index) { return info + index; }
};

// Describes one plugged-in component of the robot's body.  This struct has 12 bytes.
struct OCPCInfo {
  ODataType type;  // the type odataCPC_INFO
  word cpcClass;
  word cpcSubClass;
  word cpcType;
  word numReceptors;
};

struct OCPCTreeData {
  ODataVectorInfo vectorInfo;
  OCPCInfo info[1];  // in memory the array has vectorInfo.maxNumData elements

  void SetNumData(size_t n) { vectorInfo.numData = static_cast<longword>(n); }
  OCPCInfo* GetInfo(int index) { return info + index; }
};

#endif  // OPENR_FORMATS_PRIMITIVE_MAP_H_INCLUDED
