//
// The connection between the functions of include/device and ControllerCore.
//
// These are C functions without an argument for the robot, so an image has one controller.
//

#ifndef ControllerApi_h_DEFINED
#define ControllerApi_h_DEFINED

#include "ControllerCore.h"

// Sets the core that the functions use.  It must exist while they are called.  With 0 they do
// nothing and return 0.
void SetControllerCore(ControllerCore* core);
ControllerCore* GetControllerCore();

// Gives a report of JointMover to the motions.
void SetMotionValues(const SetValueMessage& message);

// Memory for the next image of the camera: width x height pixels of 3 bytes, red, green, blue, from
// the top left.  0 when the controller has not enabled the camera.
Uint8* CameraBuffer();

#endif  // ControllerApi_h_DEFINED
