// Makes sticks with images of tests/images.
#pragma once

#include <filesystem>
#include <string>

#include "tests/distribution/same_run.h"

namespace openr_host {

// Makes a stick with these images only.
inline void MakeStick(const ScratchFolder& stick, const Words& images, const std::string& wiring) {
  std::string list;
  stick.Write("OPEN-R/MW/OBJS/README.TXT", "");
  for (const std::string& image : images) {
    list += "/MS/OPEN-R/MW/OBJS/" + image + "\n";
    std::filesystem::copy_file(std::string(OPENR_IMAGES) + "/" + image,
                               stick.File("OPEN-R/MW/OBJS/" + image));
  }
  stick.Write("OPEN-R/MW/CONF/OBJECT.CFG", list);
  stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", wiring);
}

// Makes a stick on which Bulk sends a megabyte twelve times to two other objects, which answer, and
// to itself.
inline void MakeBulkStick(const ScratchFolder& stick) {
  MakeStick(stick, {"BULK.BIN", "TAKER1.BIN", "TAKER2.BIN"},
            "Bulk.Out.Bytes.S Taker1.In.Bytes.O\n"
            "Bulk.Out.Bytes.S Bulk.In.Bytes.O\n"
            "Bulk.Out.Bytes.S Taker2.In.Bytes.O\n"
            "Taker1.Sum.Number.S Bulk.Sums.Number.O\n"
            "Taker2.Sum.Number.S Bulk.Sums.Number.O\n");
}

}  // namespace openr_host
