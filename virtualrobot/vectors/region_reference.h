// RegionReference: a handle that holds a reference to a region (shared memory with a vector), and
// gives the reference back when the handle is destroyed or released.
#pragma once

#include <OPENR/RCRegion.h>

#include <utility>

namespace openr_host {

// A reference to a region.  REQUIRES: constructed and released in handlers of the same object,
// because the references to a region are counted separately for each object.
class RegionReference {
 public:
  RegionReference() = default;  // makes a handle without a region

  // Adds a reference to `region`.  REQUIRES: `region` is not null.
  explicit RegionReference(RCRegion* region) : region_(region) { region_->AddReference(); }
  RegionReference(RegionReference&& other) noexcept
      : region_(std::exchange(other.region_, nullptr)) {}
  RegionReference& operator=(RegionReference&& other) noexcept {
    std::swap(region_, other.region_);
    other.Release();
    return *this;
  }
  ~RegionReference() { Release(); }

  // Gives the reference back now.  Does nothing when the handle has no region.
  void Release() {
    if (RCRegion* const region = std::exchange(region_, nullptr)) region->RemoveReference();
  }

  RCRegion* get() const { return region_; }
  RCRegion* operator->() const { return region_; }
  RCRegion& operator*() const { return *region_; }
  explicit operator bool() const { return region_ != nullptr; }

 private:
  RCRegion* region_ = nullptr;
};

}  // namespace openr_host
