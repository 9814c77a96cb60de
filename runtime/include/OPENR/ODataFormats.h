// The data vectors that travel between a program and the robot's devices.
//
// A vector is one block of shared memory: an ODataVectorInfo, then an array of info
// blocks, then the data, which the info blocks point to by their offset from the start.
// The layouts are byte for byte the robot's on every host: a size_t of the robot is a
// longword here, and the one pointer is an OPhysAddr.
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
