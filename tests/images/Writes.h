// The writes of Trouble and Teller to the stick, for tests of sticks that do not take them.
#ifndef Writes_h_DEFINED
#define Writes_h_DEFINED

// Writes in the ways of C and C++ programs, and prints what each call returns.
void WriteInAllWays();

// Writes to streams that forget their errors, or that are never closed.  Prints nothing.
void LeaveStreams();

#endif  // Writes_h_DEFINED
