#include <OPENR/OMemoryLocator.h>

ostream& operator<<(ostream& out, const OMemoryLocator& locator) {
  return out << "(mid:" << locator.mid << ",offset:" << locator.offset << ")";
}
