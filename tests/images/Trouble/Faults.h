// Faults that stop the robot's processor; docs/limits.md lists them.
#ifndef Faults_h_DEFINED
#define Faults_h_DEFINED

// Does what `word` names; nothing if it names none of them.
void MakeFault(const char* word);

#endif  // Faults_h_DEFINED
