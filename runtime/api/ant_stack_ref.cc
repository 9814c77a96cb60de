#include <MCOOP.h>
#include <antStackRef.h>

// Find() leaves oid_ invalid when there is no object of that name.
antStackRef::antStackRef(const char* name) {
  dispatcher_ = nullptr;
  Find(name, &oid_);
}
