// What the master does with questions of objects in other processes.
#pragma once

#include "distribution/wire.h"
#include "runtime/core/message.h"
#include "runtime/core/uplink.h"

namespace openr_host {

class Object;
class RemoteObject;
class System;

// REQUIRES: `self`, who asks, is the current object.
Answer AnswerQuestion(System* system, Object* self, const Question& question);

// The network stack of the robot of `self` takes or gives back a shared buffer.
void MapBuffer(Object* self, uint32_t cookie, uint32_t region, bool mapped);

// What a process says of an object that it has loaded.
void ApplyDescription(const openr_wire_LoadedObject& in, RemoteObject* object);

}  // namespace openr_host
