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
  const std::string text = OcfTextOf(image.bytes);
  ParseOcf("object.ocf", text);
  return image.problem.empty() || text.size() > 3;
}

}  // namespace openr_host
