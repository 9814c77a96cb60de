// The fuzz target image: images of objects, compressed or not.
#include "runtime/config/ocf.h"
#include "runtime/core/image_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::image(std::string_view bytes) {
  const ImageFile image = CheckImage(std::string(bytes));
  FunctionsIn(image.bytes);
  ServicesInImage(image.bytes);
  SanitizerOf(image.bytes);
  const OcfResult result = ParseOcf("object.ocf", OcfTextOf(image.bytes));
  if (image.problem.empty() && result.ocf) {
    // Notes what the .ocf of an accepted image says, because nearly all inputs that are kept are
    // images that are refused, each for another reason.
    const Ocf& ocf = *result.ocf;
    const uint64_t words = (ocf.is_cached ? 1 : 0) + (ocf.is_translated ? 2 : 0) +
                           (ocf.is_user_mode ? 4 : 0) + (image.is_compressed ? 8 : 0);
    ReachFuzzState(words * 16 + static_cast<uint64_t>(ocf.priority) / 16);
  }
  return image.problem.empty() && result.ocf && result.ocf->priority > 200;
}

}  // namespace openr_host
