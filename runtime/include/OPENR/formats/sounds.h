// Sound vectors, for speaker and microphone.
//
// The speaker plays 8 kHz, 8 bits, mono (256 bytes per 32 ms); after the request
// oprmreqSPEAKER_SET_SOUND_TYPE it can play 16 kHz, 16 bits, mono (1024 bytes).  The microphone
// records 16 kHz, 16 bits, stereo (2048 bytes per 32 ms).
#ifndef OPENR_FORMATS_SOUNDS_H_INCLUDED
#define OPENR_FORMATS_SOUNDS_H_INCLUDED

#include <OPENR/formats/vector_info.h>

// The format of a sound.  Only PCM is supported.  The names of the values 0, 2 and 3 are inferred.
typedef word OSoundFormat;
const OSoundFormat osoundformatUNDEF = 0;
const OSoundFormat osoundformatPCM = 1;
const OSoundFormat osoundformatUSB_MIDI = 2;
const OSoundFormat osoundformatSMF = 3;

// The channels of a sound: mono or stereo.  The names of the values 0 and 2 are inferred.
typedef word OSoundChannel;
const OSoundChannel osoundchannelUNDEF = 0;
const OSoundChannel osoundchannelMONO = 1;
const OSoundChannel osoundchannelSTEREO = 2;

// Describes one sound of a vector; 64 bytes.
struct OSoundInfo {
  ODataType type;            // odataSOUND; odataSOUND_VECTOR, which some programs set, works too
  OPrimitiveID primitiveID;  // id of the speaker or of the microphone
  longword frameNumber;      // frame in which the output or the recording began
  longword frameSize;        // size of a sound frame in bytes
  longword dataOffset;       // offset of the sound in bytes from the start of the vector
  longword maxDataSize;      // number of bytes of memory for the sound
  longword dataSize;         // number of bytes in use
  OSoundFormat format;
  OSoundChannel channel;
  word samplingRate;  // in Hz
  word bitsPerSample;
  longword actualDataSize;  // number of bytes that the device has played or recorded so far
  longword padding[6];

  void Set(ODataType dataType, OPrimitiveID id, size_t size) {
    type = dataType;
    primitiveID = id;
    dataSize = static_cast<longword>(size);
  }
};

struct OSoundVectorData {
  ODataVectorInfo vectorInfo;
  OSoundInfo info[1];  // in memory the array has vectorInfo.maxNumData elements

  void SetNumData(size_t n) { vectorInfo.numData = static_cast<longword>(n); }
  OSoundInfo* GetInfo(int index) { return info + index; }
  byte* GetData(int index) { return reinterpret_cast<byte*>(this) + GetInfo(index)->dataOffset; }
};

struct OSoundSampleStereo16 {
  sword L;
  sword R;
};

#endif  // OPENR_FORMATS_SOUNDS_H_INCLUDED
