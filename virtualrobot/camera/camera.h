// The camera in the robot's head: its settings, its colour tables, and the vectors (messages) with
// its images.  A frame is 8 ms of virtual time.
#pragma once

#include <OPENR/OPrimitiveControl.h>
#include <OPENR/RCRegion.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "virtualrobot/body/body.h"
#include "virtualrobot/camera/colour_tables.h"
#include "virtualrobot/camera/image_layers.h"
#include "virtualrobot/camera/image_source.h"
#include "virtualrobot/devices/primitive_table.h"
#include "virtualrobot/vectors/vector_memory.h"

namespace openr_host {

class Hasher;

class CameraDevice {
 public:
  // Makes a camera that takes its pictures from `source`.  `model` must outlive the camera.  `id`
  // identifies the camera in its image vectors.  REQUIRES: `source` is not null.
  CameraDevice(std::unique_ptr<ImageSource> source, const Camera& model, OPrimitiveID id);

  // The next functions change those settings of the camera for which OPrimitiveControl.h defines
  // requests.  The functions that return a bool return false for a value that is not listed in that
  // file.
  bool SetWhiteBalance(longword mode);
  bool SetGain(longword gain);
  bool SetShutter(longword shutter);
  void set_auto_exposure(bool on);
  void set_auto_white_balance(bool on);
  ColourTables& tables() { return tables_; }

  // Returns how many images the camera has completed since boot when frame `frame` begins.  An
  // ERS-210 completes an image every 5 frames.
  int64_t ImagesBefore(int64_t frame) const;
  // Returns whether the camera completed an image just before `frame`.
  bool Due(int64_t frame) const { return ImagesBefore(frame) > ImagesBefore(frame - 1); }

  // Returns a vector with the image that was completed just before frame `frame`.  The sensor
  // samples of frame `frame` - 1 belong to this image.  The vector is in a free region: only the
  // camera holds a reference to it.  Sets *problem to "", or to the reason why the source has no
  // picture; then the vector shows the previous picture again.  REQUIRES: a handler of an object
  // runs, because a new region belongs to the object that runs.
  RCRegion* MakeVector(int64_t frame, const Body& body, std::string* problem);

  // Copies the picture of the image that MakeVector() returns, for a reader outside the simulation.
  // The picture is not split into layers: it has the size of the sensor, with gain, shutter and
  // white balance applied.  Changes no state.  Returns "", or the reason why there is no picture.
  std::string CopyPicture(int64_t frame, const Body& body, Picture* picture);

  // Writes to `colours` how the robot's colour detection sees the image of CopyPicture(): layer C
  // of the image, with the colour of ColourOfChannel() in each pixel in which a channel was
  // detected, and black elsewhere.  Returns "", or the reason why there is no picture.
  std::string CopyColours(int64_t frame, const Body& body, Picture* colours);
  // Returns the colour (red, green and blue) that stands for a channel of the colour detection, 0
  // to 7, in a picture of CopyColours().
  static const std::array<uint8_t, 3>& ColourOfChannel(int channel);

  // Resets the camera because the robot is switched off in frame `frame`: the settings get their
  // values at boot, the colour tables are removed, and the references to the regions of all vectors
  // are given up.  After the next boot, the source of pictures goes on with its next picture.
  // REQUIRES: the object that sends the vectors is the current object.
  void SwitchOff(int64_t frame);

  void HashState(Hasher* hasher) const;

 private:
  // The settings of the camera.  Their values at boot are the values of Model Information ERS-210,
  // 4.1.2.  Two things are our choice: which of the two gains of 0 dB is the default, and that both
  // automatic functions are off.
  struct Settings {
    longword white_balance = ocamparamWB_FL_MODE;
    longword gain = ocamparamGAIN_MID;
    longword shutter = ocamparamSHUTTER_MID;
    bool auto_exposure = false;
    bool auto_white_balance = false;
  };

  CameraShot LastShot(int64_t frame, const Body& body) const;
  void ChooseExposure();
  RCRegion* FreeVector();
  size_t DataBytes() const;
  void FillInfos(longword frame_number, OFbkImageVectorData* vector) const;

  std::unique_ptr<ImageSource> source_;
  const Camera& model_;
  const OPrimitiveID id_;
  ImageLayers layers_;
  ColourTables tables_;
  Picture picture_;
  Exposure exposure_;
  VectorPool pool_;
  Settings settings_;
  int64_t earlier_images_ = 0;  // number of images that were completed before this boot
};

}  // namespace openr_host
