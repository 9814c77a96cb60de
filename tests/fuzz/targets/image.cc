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
  return image.problem.empty() && result.ocf && result.ocf->priority > 200;
}

}  // namespace openr_host
