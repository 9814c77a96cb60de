// The functions of the robot: primitives, vectors, gains, power, files, time.
//
// All are synchronous and return a status; they may be called from DoInit on, not from
// constructors.  Pointers are where results go.  What a function answers besides oSUCCESS
// is listed behind its declaration.  Four more functions of the SDK, which make and delete
// sensor and image vectors, are marked there as not for use and left out here.
#ifndef OPENR_OPENRAPI_H_INCLUDED
#define OPENR_OPENRAPI_H_INCLUDED

#include <OPENR/MWInformationTypes.h>
#include <OPENR/ODataFormats.h>
#include <OPENR/OPENR.h>
#include <OPENR/OPower.h>
#include <OPENR/OPrimitiveControl.h>
#include <OPENR/OTime.h>
#include <OPENR/SizeResult.h>

namespace OPENR {

// ---- primitives

// The same primitive has the same id in every object.  On failure *id is
// oprimitiveID_UNDEF.
OStatus OpenPrimitive(const char* locator, OPrimitiveID* id);
// oNOT_FOUND (not on this robot), oOPEN_FAILURE, oINVALID_ARG (NULL), oFAIL

OStatus ClosePrimitive(OPrimitiveID id);
// oINVALID_PRIMITIVE_ID

// Requests are in OPrimitiveControl.h; what a request does not use is 0.
OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param, size_t paramSize,
                         void* result, size_t resultSize);
// oINVALID_PRIMITIVE_ID, oINVALID_ARG

// Present values, whether or not gains and motor power are on.
OStatus GetJointValue(OPrimitiveID id, OJointValue* value);
OStatus GetSensorValue(OPrimitiveID id, OSensorValue* value);
// oINVALID_PRIMITIVE_ID

// ---- vectors in shared memory

// `*baseAddr` points to a vector with room for that many elements and numData 0.
OStatus NewCommandVectorData(size_t numCommands, MemoryRegionID* memID,
                             OCommandVectorData** baseAddr);
OStatus NewSoundVectorData(size_t numSounds, size_t dataSize, MemoryRegionID* memID,
                           OSoundVectorData** baseAddr);
OStatus NewCdtVectorData(MemoryRegionID* memID, OCdtVectorData** baseAddr);
// oNO_MEMORY

OStatus DeleteCommandVectorData(MemoryRegionID memID);
OStatus DeleteSoundVectorData(MemoryRegionID memID);
OStatus DeleteCdtVectorData(MemoryRegionID memID);
// oINVALID_ARG (sound only), oFAIL

// Loads the colour tables into the camera.
OStatus SetCdtVectorData(MemoryRegionID memID);
// oINVALID_ARG (channel), oINVALID_PRIMITIVE_ID, oINVALID_DATA_TYPE, oFAIL

// ---- joint gains
//
// `id` may be oprimitiveID_UNDEF in all but the two Get functions: every opened joint.
// Order of the numbers: gains P, I, D, then shifts P, I, D.

OStatus EnableJointGain(OPrimitiveID id);
// oINVALID_PRIMITIVE_ID, oALERT_JOINT_UNCONTROLLABLE

// Zeroes the gains; the joint goes limp.
OStatus DisableJointGain(OPrimitiveID id);
// oINVALID_PRIMITIVE_ID, oFAIL

OStatus SetJointGain(OPrimitiveID id, word pg, word ig, word dg, word ps, word is, word ds);
// oINVALID_PRIMITIVE_ID, oGAIN_DISABLED (not enabled: nothing is set),
// oALERT_JOINT_UNCONTROLLABLE, oFAIL

// All six are 0 unless the answer is oSUCCESS.
OStatus GetJointGain(OPrimitiveID id, word* pg, word* ig, word* dg, word* ps, word* is, word* ds);
// as SetJointGain

// A set of gains remembered for the joint, and applied by SetDefaultJointGain().
OStatus RegisterDefaultJointGain(OPrimitiveID id, word pg, word ig, word dg, word ps, word is,
                                 word ds);
// oINVALID_PRIMITIVE_ID
OStatus SetDefaultJointGain(OPrimitiveID id);
// as SetJointGain
OStatus GetDefaultJointGain(OPrimitiveID id, word* pg, word* ig, word* dg, word* ps, word* is,
                            word* ds);
// oFAIL, with all six 0

// ---- starting several vectors together

// At most ovrsynckeyMAX_NUM_KEY alive; on failure *key is ovrsynckeyUNDEF.
OStatus NewSyncKey(OVRSyncKey* key);
// oNO_SYNC_KEY
OStatus CancelSyncKey(OVRSyncKey key);
// oINVALID_SYNC_KEY
// Each part goes into the syncKey of one vector; output begins when all parts are there.
OStatus DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2);
// oFAIL

// ---- power

OStatus SetMotorPower(OPower power);
// oFAIL

// Stores what may boot the robot again and begins the shutdown.  Returns before any object
// is stopped.
OStatus Shutdown(const OBootCondition& bootCondition);
OStatus GetBootCondition(OBootCondition* bootCondition);  // only `bitmap` is valid
OStatus GetPowerStatus(OPowerStatus* powerStatus);
// oFAIL, oNOT_FOUND

// An OPowerStatusMessage goes to `entry` at every change that `notifyStatus` selects
// (power_constants.h), until Unobserve is called with the same entry.
OStatus ObservePowerStatus(const OPowerStatus& notifyStatus, const OServiceEntry& entry);
// oFAIL, oNOT_FOUND
OStatus UnobservePowerStatus(const OServiceEntry& entry);
// oFAIL, oNOT_FOUND, oINVALID_ARG

// Power off at once: no DoStop, no DoDestroy.
OStatus Fatal(OFatal fatal);

// ---- the robot and its files

// A copy of the file that DESIGNDB.CFG names under `keyword`, gunzipped, in shared memory.
OStatus FindDesignData(const char* keyword, ODesignDataID* id, byte** dataAddr, size_t* size);
// oNOT_FOUND, oDESIGNDATA_SIZE_ZERO, oNO_MEMORY, oFAIL
#if OPENR_WIDE_SIZE
template <class Number>
inline typename openr_host::IfUnsigned<Number, OStatus>::Type FindDesignData(const char* keyword,
                                                                             ODesignDataID* id,
                                                                             byte** dataAddr,
                                                                             Number* size) {
  return FindDesignData(keyword, id, dataAddr, openr_host::SizeResult(size));
}
#endif
OStatus DeleteDesignData(ODesignDataID id);
// oINVALID_ARG, oFAIL

// Writes "ERS-210" or the like; room for orobotdesignNAME_MAX + 1 characters.
OStatus GetRobotDesign(char* robotDesign);
OStatus GetMemoryStickStatus(OMemoryStickStatus* status);
// oFAIL

// ---- clock and volume switch

OStatus SetTime(const OTime& time);
OStatus GetTime(OTime* time);
OStatus SetTimeDifference(sbyte timeDif);  // hours, -12..12
OStatus GetTimeDifference(sbyte* timeDif);
// oFAIL, oNOT_FOUND

OStatus SetVolumeSwitch(OVolumeSwitch volume);
OStatus GetVolumeSwitch(OVolumeSwitch* volume);
// oFAIL

// ---- "level 1" information, undocumented

OStatus RequireMWInfo(MWIID id);
OStatus CancelMWInfo(MWIID id);
OStatus IsMWInfoRequired(MWIID id, bool* required);

}  // namespace OPENR

#endif  // OPENR_OPENRAPI_H_INCLUDED
