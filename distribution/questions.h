// The master's answers to questions of objects in workers (runtime/core/uplink.h).
#pragma once

#include "distribution/wire.h"
#include "runtime/core/message.h"
#include "runtime/core/uplink.h"

namespace openr_host {

class Object;
class RemoteObject;
class System;

// Answers a question of `self`.  REQUIRES: `self` is the current object.
Answer AnswerQuestion(System* system, Object* self, const Question& question);

// Maps or unmaps a shared buffer in the network stack of the robot of `self`.
void MapBuffer(Object* self, uint32_t cookie, uint32_t region, bool mapped);

// Copies what a worker reports of an object that it has loaded to the stand-in.
void ApplyDescription(const openr_wire_LoadedObject& in, RemoteObject* object);

}  // namespace openr_host
