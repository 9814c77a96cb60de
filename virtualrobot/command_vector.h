// A command vector as its subject filled it, checked so that it can be played.
#pragma once

#include <OPENR/ODataFormats.h>

#include <string>
#include <vector>

#include "virtualrobot/devices.h"
#include "virtualrobot/primitive_table.h"
#include "virtualrobot/vector_memory.h"

namespace openr_host {

// One element.  Its data stay readable while the region is referred to.
struct CommandElement {
  const Primitive* primitive = nullptr;  // null: takes its time and moves nothing
  const OCommandData* data = nullptr;
  ODataType type = odataUNDEF;
  int frames = 0;  // 0..ocommandMAX_FRAMES

  // Robot frames that command frame `i` lasts: 1 for a joint, 16 for an ERS-210 ear (128
  // ms; seed report, 5.3.4), the period of a light or an ERS-7 ear, where 0 counts as 1.
  uint32_t FrameLength(int i) const;

  // Set point of joint frame `i`.  REQUIRES: type is odataJOINT_COMMAND2.
  slongword Urad(int i) const;

  // Mode of light frame `i`.  REQUIRES: type is odataLED_COMMAND3.
  OLED3Mode Mode(int i) const;

  // Puts command frame `i` in force.  REQUIRES: primitive is not null.
  void Apply(int i, Devices* devices) const;
};

// All elements of `vector`; what is wrong with one is described in `problems`.  Writes
// `frame_number` into the infos.
void ReadCommandElements(const SentVector& vector, longword frame_number,
                         PrimitiveTable* primitives, std::vector<CommandElement>* elements,
                         std::vector<std::string>* problems);

}  // namespace openr_host
