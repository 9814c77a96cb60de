//
// The controller's main function, whatever its language and its arguments.
//

#ifndef ControllerMain_h_DEFINED
#define ControllerMain_h_DEFINED

// Calls it; returns what it returns, 0 if the image has none (an empty controller).
int CallControllerMain();

#endif  // ControllerMain_h_DEFINED
