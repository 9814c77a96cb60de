// The data vectors that programs and the robot's devices exchange.
//
// A vector is one block of shared memory: an ODataVectorInfo, then an array of info blocks, then
// the data.  Info blocks refer to data by their offset from the start of the vector.  On every host
// the layout is that of the robot, byte for byte.  So members whose size differs between computers
// have types of 4 bytes here: longword in place of size_t, and OPhysAddr in place of the only
// pointer.
#ifndef OPENR_ODATAFORMATS_H_INCLUDED
#define OPENR_ODATAFORMATS_H_INCLUDED

#include <OPENR/OUnits.h>
#include <OPENR/formats/commands.h>
#include <OPENR/formats/images.h>
#include <OPENR/formats/primitive_map.h>
#include <OPENR/formats/sensors.h>
#include <OPENR/formats/sounds.h>
#include <OPENR/formats/vector_info.h>

#endif  // OPENR_ODATAFORMATS_H_INCLUDED
