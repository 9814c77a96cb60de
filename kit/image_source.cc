#include "kit/image_source.h"

#include <fmt/format.h>

#include <string_view>

#include "runtime/core/image_info.h"

namespace openr_host {
namespace {

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '\r') continue;
    if (c == '\n') {
      quoted += "\\n\"\n    \"";
      continue;
    }
    if (c == '\\' || c == '"') quoted += '\\';
    quoted += c == '\t' || static_cast<unsigned char>(c) >= ' ' ? c : '?';
  }
  return quoted + '"';
}

constexpr std::string_view kOpening = R"(/* Generated. */
#ifdef __cplusplus
extern "C" {
#endif

struct ImageInfo {
    unsigned    version;
    unsigned    headers_version;
    const char* ocf;
};

/* In a section of its own, for those who ask a file who it is without loading it. */
static __attribute__((section("openr_ocf"), used)) const char openr_ocf_text[] =
    )";

// The part of the generated source that follows the text of the .ocf file.  It defines the
// description of the image.  The numbers kImageVersion and kHeadersVersion replace the two {}.
constexpr char kDescription[] = R"(;

extern __attribute__((visibility("default"))) const struct ImageInfo openr_image_info;
const struct ImageInfo openr_image_info = {{ {}, {}, openr_ocf_text }};
)";

// The end of the generated source: two helper functions.  If a function may end without returning
// a value, compile_tool.cc compiles its source so that all functions call the helpers at their
// beginning and end.  The helper at the end leaves 0 in the register for the return value.
constexpr std::string_view kRest = R"(
void openr_function_begins(void*, void*) __asm__("__cyg_profile_func_enter");
long openr_function_ends(void*, void*) __asm__("__cyg_profile_func_exit");
__attribute__((visibility("hidden"), no_instrument_function))
void openr_function_begins(void* function, void* caller) { (void)function; (void)caller; }
__attribute__((visibility("hidden"), no_instrument_function))
long openr_function_ends(void* function, void* caller) { (void)function; (void)caller; return 0; }

#ifdef __cplusplus
}
#endif
)";

}  // namespace

std::string MakeImageSource(const std::string& ocf) {
  return std::string(kOpening) + Quoted(ocf) +
         fmt::format(kDescription, kImageVersion, kHeadersVersion) + std::string(kRest);
}

}  // namespace openr_host
