#include <OPENR/OMemoryLocator.h>

// Prints a place in shared memory: the id of a region and the offset in it.
ostream& operator<<(ostream& out, const OMemoryLocator& locator) {
  return out << "(mid:" << locator.mid << ",offset:" << locator.offset << ")";
}
