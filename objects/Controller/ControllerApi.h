//
// Connects the functions of include/device, which a controller program calls, with ControllerCore.
//
// The functions of include/device are C functions without an argument for the robot, so an image
// (the file of an object) has only one controller.
//

#ifndef ControllerApi_h_DEFINED
#define ControllerApi_h_DEFINED

#include "ControllerCore.h"

// Sets the core that the functions of include/device use.  `core` must exist as long as these
// functions may be called.  If `core` is 0, these functions do nothing and return 0.
void SetControllerCore(ControllerCore* core);
ControllerCore* GetControllerCore();

// Passes a report of JointMover to the functions of include/device/mtn.h.
void SetMotionValues(const SetValueMessage& message);

// Returns the memory for the next image of the camera: width x height pixels from the top left,
// with 3 bytes each for red, green and blue.  Returns 0 when the controller has not enabled the
// camera.
Uint8* CameraBuffer();

#endif  // ControllerApi_h_DEFINED
