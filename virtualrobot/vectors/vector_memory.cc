#include "virtualrobot/vectors/vector_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/system.h"
#include "virtualrobot/body/body.h"

namespace openr_host {
namespace {

// The longest delay that a vector may ask for without a report: 10 s, in frames of 8 ms.  A longer
// delay is probably a mistake of the program.  The number is our choice.
constexpr longword kWaitFrames = 1250;

// Returns how many bytes of the region of a vector may be read: the size that the sender says,
// limited by the size of the region's memory.
size_t BytesOf(const RCRegion& region, const RegionTable& regions) {
  if (region.Base() == nullptr) return 0;
  const size_t block = regions.SizeOf(region.MemID());
  // If the memory is not in the region table, its size is not known, so returns the size that the
  // sender says.
  if (block == 0) return region.Size();
  return std::min(region.Size(), block - std::min<size_t>(block, region.Offset()));
}

}  // namespace

char* SentVector::At(size_t offset, size_t size) const {
  return offset > bytes || size > bytes - offset ? nullptr : region->Base() + offset;
}

SentVector ReadSentVector(RCRegion* region, size_t info_size, const char* kind, System& system,
                          std::vector<std::string>* problems) {
  const RegionTable& regions = system.regions();
  SentVector vector;
  vector.region = region;
  vector.bytes = BytesOf(*region, regions);
  if (vector.bytes < sizeof(ODataVectorInfo)) {
    problems->push_back(
        fmt::format("{}: {} bytes hold no vector; it is ignored", kind, vector.bytes));
    return vector;
  }
  vector.header = reinterpret_cast<ODataVectorInfo*>(region->Base());
  const ODataVectorInfo& header = *vector.header;
  if (regions.WrittenBeyond(region->MemID())) {
    problems->push_back(
        fmt::format("{}: somebody wrote behind its end, over whatever lies there on the robot; "
                    "element {} is the last",
                    kind, static_cast<int64_t>(header.maxNumData) - 1));
  }
  // Limits the numbers of elements that the header names (numData and maxNumData) by the room in
  // the region, because an object can write any number into a header.
  const size_t room = (vector.bytes - sizeof header) / info_size;
  const size_t made_for = std::min<size_t>(header.maxNumData, room);
  if (header.numData > made_for) {
    problems->push_back(
        fmt::format("{}: SetNumData({}) on a vector made for {} elements; the rest is ignored",
                    kind, header.numData, made_for));
  }
  vector.elements = static_cast<int>(std::min<size_t>(header.numData, made_for));
  return vector;
}

bool NamesItsMemory(const SentVector& vector, System& system) {
  if (vector.header == nullptr) return false;
  const uint32_t id = vector.region->MemID();
  if (vector.header->memRegionID == id) return true;
  const Object* const maker = system.object(system.regions().MakerOf(id));
  return maker != nullptr && maker->is_system();
}

OVRSyncKey SyncKeyOf(const RCRegion& region) {
  return region.Base() == nullptr || region.Size() < sizeof(ODataVectorInfo)
             ? ovrsynckeyUNDEF
             : reinterpret_cast<const ODataVectorInfo*>(region.Base())->syncKey;
}

int64_t WaitOf(const SentVector& vector, std::vector<std::string>* problems) {
  if (vector.header == nullptr) return 0;
  const longword wait = vector.header->wait;
  if (wait > kWaitFrames) {
    problems->push_back(
        fmt::format("vector with wait = {}: it starts only after {:.0f} s (frames of 8 ms)", wait,
                    wait * kFrame_s));
  }
  return wait;
}

RCRegion* VectorPool::FindFree() const {
  for (RCRegion* region : regions_) {
    if (region->NumberOfReference() == 1) return region;  // free: only the pool refers to it
  }
  return nullptr;
}

void VectorPool::Add(RCRegion* region) {
  ASSERT(region->NumberOfReference() == 1, "{} references", region->NumberOfReference());
  regions_.push_back(region);
  if (regions_.size() != kMany) return;
  t_current.system->AddFinding(
      Severity::kWarning,
      fmt::format("objects keep {} vectors of one stream: an AddReference() without its "
                  "RemoveReference()? The robot's memory is full soon",
                  kMany));
}

void VectorPool::Clear() {
  for (RCRegion* const region : std::exchange(regions_, {})) region->RemoveReference();
}

RCRegion* NewVectorRegion(ODataType type, size_t info_size, size_t elements, size_t data_bytes) {
  RCRegion* const region =
      new RCRegion(sizeof(ODataVectorInfo) + elements * info_size + data_bytes);
  auto& header = *reinterpret_cast<ODataVectorInfo*>(region->Base());
  header.memRegionID = region->MemID();
  header.totalSize = static_cast<longword>(region->Size());
  header.type = type;
  header.infoOffset = sizeof header;
  header.infoSize = static_cast<longword>(info_size);
  header.maxNumData = static_cast<longword>(elements);
  header.numData = static_cast<longword>(elements);
  header.syncKey = ovrsynckeyUNDEF;
  return region;
}

}  // namespace openr_host
