// RegionAccess: operations on RCRegions (references to shared memory) that the runtime may do and
// objects may not.
#pragma once

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>

namespace openr_host {

class System;

struct RegionAccess {
  // Returns the part of a notification that describes `region`: its id, and the offset and size of
  // its data.
  static TransferedData Describe(RCRegion* region) {
    return {region, region->id_, region->offset_, region->size_};
  }
  // Makes an RCRegion for an observer of `system`, with one reference.  `data` is the part of the
  // notification that describes the subject's RCRegion.  Both RCRegions refer to the same memory,
  // unless the observer gets a read-only copy (guard_pages.h).
  static RCRegion* Receive(System* system, const TransferedData& data);
  // Deletes `received`, an RCRegion that Receive() has made for an observer of `system`.
  static void GiveBack(System* system, RCRegion* received);
  // Sets the values that a new RCRegion lacks, because the program gave a region id without the
  // address or without the size.  Takes these values from the RegionTable.
  static void Complete(RCRegion* region);
  // The next two functions do what the functions of RCRegion with these names do.  They are inline,
  // because they run for every notification.
  static void AddReference(RCRegion* region) { ++region->count_; }
  static void RemoveReference(RCRegion* region) {
    if (region->count_ > 1) [[likely]]
      --region->count_;
    else
      region->RemoveReference();
  }
  static RCRegion* SourceOf(const RCRegion* received) { return received->source_; }

 private:
  static void UseReadOnlyCopy(RCRegion* region);
};

}  // namespace openr_host
