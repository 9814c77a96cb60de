// Finds connections that send a struct which the two objects lay out differently.  Only bytes are
// passed, so the observer then reads something else than the subject has written, and no message
// says so (field-notes.md, 2.8).  That happens when each object has its own definition of the
// struct, or when one of the objects was not built again after the header had changed.
#pragma once

#include "kit/check_images.h"
#include "kit/object_parts.h"
#include "kit/remarks.h"
#include "runtime/config/connect_config.h"

namespace openr_host {

// Warns of each connection of `wires` whose two objects lay out its struct differently.  To raise
// no false alarm, warns only if all of this holds:
// - the data type in the names of the services is the name of the struct;
// - both images are built, and their debug information has one definition of the struct;
// - sources of the subject's object pass such a struct to SetData(), with its size;
// - sources of the observer's object use received data as such a struct;
// - a member differs in one of two ways:
//   - sources of both objects name the member, and it lies at another place or has another size;
//   - the member is only in the observer's struct, behind the last byte that the subject sends, and
//     the observer's object names it and asks nowhere for the size of the data.
// An array at the end of the struct may have another length in the two objects, because data of
// variable length are sent in this way.
//
// Adds a note about a struct with a member of type long or size_t, or with a pointer, if the first
// four of these conditions hold.  Such a member has different sizes on the host and on the robot
// (field-notes.md, 12.4).
//
// Adds a note about a member of an object's class that is an array of 2 MB or more, because the
// compiler of the first SDKs crashed at such a member (field-notes.md, 3.9).
void CheckLayouts(const ConnectConfig& wires, const StickImages& images, const ObjectParts& parts,
                  Remarks* remarks);

}  // namespace openr_host
