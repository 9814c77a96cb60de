// The elements of a command vector, checked so that they can be played.
#pragma once

#include <OPENR/ODataFormats.h>

#include <string>
#include <vector>

#include "virtualrobot/devices.h"
#include "virtualrobot/primitive_table.h"
#include "virtualrobot/vector_memory.h"

namespace openr_host {

// An element of a command vector.  Its data are in the region of the vector.
struct CommandElement {
  const Primitive* primitive = nullptr;  // null: the element takes its time and moves nothing
  const OCommandData* data = nullptr;
  ODataType type = odataUNDEF;
  int frames = 0;  // 0..ocommandMAX_FRAMES

  // Robot frames that command frame `i` lasts: 1 for a joint, 16 for an ear of an ERS-210 (128 ms;
  // Hohl 2004, 5.3.4), the period for a light or an ear of an ERS-7, where 0 counts as 1.
  uint32_t FrameLength(int i) const;

  // Set point of joint frame `i`.  REQUIRES: type is odataJOINT_COMMAND2.
  slongword Urad(int i) const;

  // Mode of light frame `i`.  REQUIRES: type is odataLED_COMMAND3.
  OLED3Mode Mode(int i) const;

  // Puts command frame `i` in force.  REQUIRES: primitive is not null, 0 <= i < frames.
  void Apply(int i, Devices* devices) const;
};

// Replaces *elements by all elements of `vector`.  Adds a text to `problems` for each element that
// has a mistake.  Writes `frame_number` into the infos of the vector, where its sender can read it.
void ReadCommandElements(const SentVector& vector, longword frame_number,
                         PrimitiveTable* primitives, std::vector<CommandElement>* elements,
                         std::vector<std::string>* problems);

}  // namespace openr_host
