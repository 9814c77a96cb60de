//
// The call of the controller's main function, in C or C++, with or without arguments.
//

#ifndef ControllerMain_h_DEFINED
#define ControllerMain_h_DEFINED

// Calls main() and returns its result; 0 if the image has no main() (an empty controller).
//
// The build of a controller generates this function (openr/kit/controller_main.h).  It compiles the
// controller with -Dmain=controller_main, finds the symbol of that name (in C++ it contains the
// arguments) and writes a call of it.  A weak symbol would not work: the robot's image tool adds
// the load address to every word of the global offset table, so an undefined weak function is not
// null there.
int CallControllerMain();

#endif  // ControllerMain_h_DEFINED
