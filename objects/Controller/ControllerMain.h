//
// Calls the main function of a controller program, in C or C++, with or without arguments.
//

#ifndef ControllerMain_h_DEFINED
#define ControllerMain_h_DEFINED

// Calls the program's main() and returns its result; returns 0 if the image has no main() (an empty
// controller).
//
// The build of a controller generates this function (kit/controller_main.h).  The build
// compiles the program with -Dmain=controller_main, finds the symbol of that name (in C++ it
// contains the types of the arguments) and writes a call of the symbol.  A weak symbol would not
// work: the robot's image tool adds the load address to every word of the global offset table, so
// an undefined weak function is not null there.
int CallControllerMain();

#endif  // ControllerMain_h_DEFINED
