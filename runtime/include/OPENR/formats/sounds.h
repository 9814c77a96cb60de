// Sound vectors, for speaker and microphone.
//
// Speaker: 8 kHz 8 bit mono (256 bytes per 32 ms) unless switched to 16 kHz 16 bit mono
// (1024 bytes).  Microphone: 16 kHz 16 bit stereo, 2048 bytes per 32 ms.
#ifndef OPENR_FORMATS_SOUNDS_H_INCLUDED
#define OPENR_FORMATS_SOUNDS_H_INCLUDED

#include <OPENR/formats/vector_info.h>

// Only PCM is supported.  The names of 0, 2 and 3 are inferred.
typedef word OSoundFormat;
const OSoundFormat osoundformatUNDEF = 0;
const OSoundFormat osoundformatPCM = 1;
const OSoundFormat osoundformatUSB_MIDI = 2;
const OSoundFormat osoundformatSMF = 3;

// The names of 0 and 2 are inferred.
typedef word OSoundChannel;
const OSoundChannel osoundchannelUNDEF = 0;
const OSoundChannel osoundchannelMONO = 1;
const OSoundChannel osoundchannelSTEREO = 2;

// 64 bytes.
struct OSoundInfo {
  ODataType type;            // odataSOUND; programs write odataSOUND_VECTOR as well
  OPrimitiveID primitiveID;  // speaker or microphone
  longword frameNumber;      // of the first output, or of the capture
  longword frameSize;        // bytes of a sound frame
  longword dataOffset;       // from the start of the vector
  longword maxDataSize;      // bytes there is room for
  longword dataSize;         // bytes in use
  OSoundFormat format;
  OSoundChannel channel;
  word samplingRate;  // Hz
  word bitsPerSample;
  longword actualDataSize;  // bytes the device really moved
  longword padding[6];

  void Set(ODataType dataType, OPrimitiveID id, size_t size) {
    type = dataType;
    primitiveID = id;
    dataSize = static_cast<longword>(size);
  }
};

struct OSoundVectorData {
  ODataVectorInfo vectorInfo;
  OSoundInfo info[1];  // really vectorInfo.maxNumData of them

  void SetNumData(size_t n) { vectorInfo.numData = static_cast<longword>(n); }
  OSoundInfo* GetInfo(int index) { return info + index; }
  byte* GetData(int index) { return reinterpret_cast<byte*>(this) + GetInfo(index)->dataOffset; }
};

struct OSoundSampleStereo16 {
  sword L;
  sword R;
};

#endif  // OPENR_FORMATS_SOUNDS_H_INCLUDED
