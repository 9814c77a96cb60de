// The camera in the head: its settings, its colour tables, and the image vectors.
#pragma once

#include <OPENR/OPrimitiveControl.h>
#include <OPENR/RCRegion.h>

#include <memory>
#include <string>

#include "virtualrobot/body.h"
#include "virtualrobot/camera/colour_tables.h"
#include "virtualrobot/camera/image_layers.h"
#include "virtualrobot/camera/image_source.h"
#include "virtualrobot/primitive_table.h"
#include "virtualrobot/vector_memory.h"

namespace openr_host {

class Hasher;

class CameraDevice {
 public:
  // Null as `source` is the test pattern.  `model` must outlive the camera.
  CameraDevice(std::unique_ptr<ImageSource> source, const Camera& model, OPrimitiveID id);

  // Settings of the requests in OPrimitiveControl.h.  Return false for a value that is not listed
  // there.
  bool SetWhiteBalance(longword mode);
  bool SetGain(longword gain);
  bool SetShutter(longword shutter);
  void set_auto_exposure(bool on);
  void set_auto_white_balance(bool on);
  ColourTables& tables() { return tables_; }

  // Number of images since boot that are complete when frame `frame` begins.  An ERS-210 has one
  // every 5 frames.
  int64_t ImagesBefore(int64_t frame) const;
  // Whether an image was completed just before `frame`.
  bool Due(int64_t frame) const { return ImagesBefore(frame) > ImagesBefore(frame - 1); }

  // A vector with the image that was completed just before `frame`, in a region to which no object
  // refers.  The samples of frame `frame` - 1 belong to the image.  The one reference to the region
  // stays here.  *problem is "" or why the source has no picture; then the image is the last one.
  // Runs as code of an object.
  RCRegion* MakeVector(int64_t frame, const Body& body, std::string* problem);

  // The same image for a reader outside of the run, before it is split into layers: in the size of
  // the sensor, with gain, shutter and white balance.  Changes no state.  Returns "" or why there
  // is no picture.
  std::string TakePicture(int64_t frame, const Body& body, Picture* picture);

  void HashState(Hasher* hasher) const;

 private:
  CameraShot ShotBefore(int64_t frame, const Body& body) const;
  void ChooseExposure();
  RCRegion* FreeVector();
  void FillInfos(longword frame_number, OFbkImageVectorData* vector) const;

  std::unique_ptr<ImageSource> source_;
  const Camera& model_;
  const OPrimitiveID id_;
  ImageLayers layers_;
  ColourTables tables_;
  Picture picture_;
  Exposure exposure_;
  VectorPool pool_;

  // Defaults are those of Model Information ERS-210, 4.1.2.  Chosen: which of the two gains of 0 dB
  // is the default, and that both automatic functions are off.
  longword white_balance_ = ocamparamWB_FL_MODE;
  longword gain_ = ocamparamGAIN_MID;
  longword shutter_ = ocamparamSHUTTER_MID;
  bool auto_exposure_ = false;
  bool auto_white_balance_ = false;
};

}  // namespace openr_host
