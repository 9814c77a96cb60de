// Sizes and offsets as the robot has them, compared with what this compiler makes of our headers.
#ifndef ABI_ABI_H_INCLUDED
#define ABI_ABI_H_INCLUDED

#include <stddef.h>

// Counts, and prints "file:line: what is N, on the robot M" when they differ.
void CheckNumber(const char* file, int line, const char* what, size_t here, size_t robot);

#define SIZE(type, bytes) CheckNumber(__FILE__, __LINE__, "sizeof(" #type ")", sizeof(type), bytes)
#define AT(type, member, offset) \
  CheckNumber(__FILE__, __LINE__, #type "." #member, offsetof(type, member), offset)

void CheckBasicTypes();
void CheckCoreMessages();
void CheckVectors();
void CheckValues();
void CheckPower();
void CheckEnvironment();
void CheckTcp();
void CheckUdp();
void CheckDns();
void CheckEther();
void CheckOriginalNames();  // made of tools/surface/original_names.tsv

#endif  // ABI_ABI_H_INCLUDED
