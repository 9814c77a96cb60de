// Fetches pictures of a robot's camera, by the remote control.
#pragma once

#include <cstdint>
#include <string>

#include "RemoteCamera.h"

namespace openr_host {

class RemoteClient;

// A layer of a picture.  Its bands are interleaved row by row: a row of Y, one of Cr, one of Cb,
// and three more, then the next row.  Layer C has one band, the detected colours.
struct RemotePicture {
  uint32_t frame = 0;  // frame number of the picture
  int layer = 0;       // 0 H, 1 M, 2 L, 3 C
  int bands = 0;
  int width = 0;
  int height = 0;
  std::string bytes;

  // Returns the picture as a file: .ppm (P6), or .pgm (P5) for layer C.
  std::string File() const;
};

// Asks for a picture and waits for it.  Throws the errors of RemoteClient; std::runtime_error when
// the camera sends no picture within `timeout_ms`.  The client uses version 2 of the protocol from
// then on.
RemotePicture FetchPicture(RemoteClient* client, int layer, int timeout_ms);

}  // namespace openr_host
