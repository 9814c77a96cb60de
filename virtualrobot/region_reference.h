// A reference to a region, given back when this handle is destroyed or released.
#pragma once

#include <OPENR/RCRegion.h>

#include <utility>

namespace openr_host {

// Runs as code of the object to which the region belongs, because RCRegion counts per object.
class RegionReference {
 public:
  RegionReference() = default;  // refers to no region

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

  // Gives the reference back now.  Without a region nothing happens.
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
