# Writes OUT, a source that holds the text of the .ocf file OCF; see ImageInfo in
# runtime/core/image.h.
file(READ ${OCF} text)
string(REPLACE "\\" "\\\\" text "${text}")
string(REPLACE "\"" "\\\"" text "${text}")
string(REPLACE "\r" "" text "${text}")
string(REPLACE "\n" "\\n\"\n    \"" text "${text}")
file(WRITE ${OUT} "// Generated.
#include <Types.h>

struct ImageInfo {
    longword    version;
    longword    reserved;
    const char* ocf;
};

extern \"C\" __attribute__((visibility(\"default\"))) const ImageInfo openr_image_info;
const ImageInfo openr_image_info = { 1, 0,
    \"${text}\"
};

// Linked last, so the constructor without a priority is the last of all.
extern \"C\" void openr_image_constructors(int begin);
__attribute__((constructor(101))) static void BeforeConstructors() { openr_image_constructors(1); }
__attribute__((constructor)) static void AfterConstructors() { openr_image_constructors(0); }
")
