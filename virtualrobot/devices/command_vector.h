// The elements of a command vector, checked so that they can be played.  A command vector is a
// message that moves joints and sets lights; each of its elements has up to 16 command frames for
// one primitive (joint, light or ear).
#pragma once

#include <OPENR/ODataFormats.h>

#include <string>
#include <vector>

#include "virtualrobot/devices/devices.h"
#include "virtualrobot/devices/primitive_table.h"
#include "virtualrobot/vectors/vector_memory.h"

namespace openr_host {

// An element of a command vector.  `data` points into the region of the vector, so the region must
// exist as long as the element.
struct CommandElement {
  // The primitive that the element sets.  Null: the element sets nothing, but the vector lasts at
  // least as long as this element.
  const Primitive* primitive = nullptr;
  const OCommandData* data = nullptr;
  ODataType type = odataUNDEF;
  int frames = 0;  // number of command frames, 0 to ocommandMAX_FRAMES

  // Returns how many robot frames of 8 ms the command frame `i` lasts.  For a joint this is 1; for
  // an ear of an ERS-210 it is 16 (128 ms; Hohl 2004, 5.3.4).  For a light, or an ear of an ERS-7,
  // it is the member `period` of the command frame; a period of 0 counts as 1.
  uint32_t FrameLength(int i) const;

  // Returns the set point of command frame `i` in microradians.  REQUIRES: type is
  // odataJOINT_COMMAND2.
  slongword Urad(int i) const;

  // Returns the light mode of command frame `i`.  REQUIRES: type is odataLED_COMMAND3.
  OLED3Mode Mode(int i) const;

  // Sets the joint, light or ear in `devices` as command frame `i` demands.  REQUIRES: primitive is
  // not null, 0 <= i < frames.
  void Apply(int i, Devices* devices) const;
};

// Replaces the content of `elements` by all elements of `vector`.  Adds to `problems` a text for
// each element that has a mistake.  Writes `frame_number`, the number of the frame in which the
// vector begins, into the OCommandInfo of each element, where the sender of the vector can read it.
void ReadCommandElements(const SentVector& vector, longword frame_number,
                         PrimitiveTable* primitives, std::vector<CommandElement>* elements,
                         std::vector<std::string>* problems);

}  // namespace openr_host
