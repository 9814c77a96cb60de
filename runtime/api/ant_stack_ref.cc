#include <MCOOP.h>
#include <antStackRef.h>

// Finds a network stack by the name of its object.  If no object is called `name`, oid_ stays
// invalid.
antStackRef::antStackRef(const char* name) {
  dispatcher_ = nullptr;
  Find(name, &oid_);
}
