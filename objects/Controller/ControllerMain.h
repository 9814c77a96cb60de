//
// The controller's main function, whatever its language and its arguments.
//

#ifndef ControllerMain_h_DEFINED
#define ControllerMain_h_DEFINED

// Calls it; returns what it returns, 0 if the image has none (an empty controller).
//
// The build of a controller writes this function: it compiles the controller with
// -Dmain=controller_main, looks which symbol that gave (in C++ the arguments are part of it), and
// generates the call (kit/controller_main.h).  Weak symbols would not do: the robot's image
// tool adds the load address to every word of the global offset table, so an undefined weak
// function is not null there.
int CallControllerMain();

#endif  // ControllerMain_h_DEFINED
