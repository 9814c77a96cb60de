//
// The functions of include/device on one side, ControllerCore on the other.
//
// They are plain C functions without an argument that says which robot is meant, so there is
// one controller per image.
//

#ifndef ControllerApi_h_DEFINED
#define ControllerApi_h_DEFINED

#include "ControllerCore.h"

// Names the core the functions speak to; it must outlive their use.  0: none, then they do
// nothing and every value is 0.
void SetControllerCore(ControllerCore* core);
ControllerCore* GetControllerCore();

// News of JointMover for the motions.
void SetMotionValues(const SetValueMessage& message);

// Where the next image of the camera is to be written, width x height pixels of 3 bytes, red, green,
// blue, from the top left; 0 when no controller wants one.
Uint8* CameraBuffer();

#endif  // ControllerApi_h_DEFINED
