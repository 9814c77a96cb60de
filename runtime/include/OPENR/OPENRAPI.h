// The functions of the robot: primitives, vectors, gains, power, files, time.
//
// All functions are synchronous and return a status.  Programs may call them from DoInit on, but
// not in constructors.  Results are written through pointers.  The errors that a function returns
// are in the comment "Errors of ..." below the function.  Four functions of the SDK, which make and
// delete sensor and image vectors, are left out, because the SDK says that programs must not use
// them.
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

// Opens a primitive, a device of the robot.  Every object gets the same id for it.  If the call
// fails, *id is oprimitiveID_UNDEF.
OStatus OpenPrimitive(const char* locator, OPrimitiveID* id);
// Errors of OpenPrimitive(): oNOT_FOUND (not on this robot), oOPEN_FAILURE, oINVALID_ARG (NULL),
// oFAIL

OStatus ClosePrimitive(OPrimitiveID id);
// Errors of ClosePrimitive(): oINVALID_PRIMITIVE_ID

// Sends a request of OPrimitiveControl.h; arguments that the request does not use are 0.
OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param, size_t paramSize,
                         void* result, size_t resultSize);
// Errors of ControlPrimitive(): oINVALID_PRIMITIVE_ID, oINVALID_ARG

// Return the present value of a joint or sensor, also while gains or motor power are off.
OStatus GetJointValue(OPrimitiveID id, OJointValue* value);
OStatus GetSensorValue(OPrimitiveID id, OSensorValue* value);
// Errors of GetJointValue() and GetSensorValue(): oINVALID_PRIMITIVE_ID

// ---- vectors in shared memory

// Make a vector with room for the given number of elements.  `*baseAddr` becomes the address of the
// vector, whose numData is 0.
OStatus NewCommandVectorData(size_t numCommands, MemoryRegionID* memID,
                             OCommandVectorData** baseAddr);
OStatus NewSoundVectorData(size_t numSounds, size_t dataSize, MemoryRegionID* memID,
                           OSoundVectorData** baseAddr);
OStatus NewCdtVectorData(MemoryRegionID* memID, OCdtVectorData** baseAddr);
// Errors of NewCommandVectorData(), NewSoundVectorData() and NewCdtVectorData(): oNO_MEMORY

OStatus DeleteCommandVectorData(MemoryRegionID memID);
OStatus DeleteSoundVectorData(MemoryRegionID memID);
OStatus DeleteCdtVectorData(MemoryRegionID memID);
// Errors of the three Delete...VectorData() functions: oINVALID_ARG (sound only), oFAIL

// Loads the tables of a colour detection vector into the camera.
OStatus SetCdtVectorData(MemoryRegionID memID);
// Errors of SetCdtVectorData(): oINVALID_ARG (wrong channel), oINVALID_PRIMITIVE_ID,
// oINVALID_DATA_TYPE, oFAIL

// ---- joint gains
//
// In all functions but the two Get functions, `id` may be oprimitiveID_UNDEF, which means every
// opened joint.  The six numbers of a joint are the gains P, I, D (pg, ig, dg) and the shifts P, I,
// D (ps, is, ds).  A gain g with the shift s acts as g * 2^(s - 16).

OStatus EnableJointGain(OPrimitiveID id);
// Errors of EnableJointGain(): oINVALID_PRIMITIVE_ID, oALERT_JOINT_UNCONTROLLABLE

// Sets the gains of the joint to zero, so that the joint moves freely.
OStatus DisableJointGain(OPrimitiveID id);
// Errors of DisableJointGain(): oINVALID_PRIMITIVE_ID, oFAIL

OStatus SetJointGain(OPrimitiveID id, word pg, word ig, word dg, word ps, word is, word ds);
// Errors of SetJointGain(): oINVALID_PRIMITIVE_ID, oGAIN_DISABLED (not enabled: nothing is set),
// oALERT_JOINT_UNCONTROLLABLE, oFAIL

// Returns the gains of the joint; if the call fails, all six numbers are 0.
OStatus GetJointGain(OPrimitiveID id, word* pg, word* ig, word* dg, word* ps, word* is, word* ds);
// Errors of GetJointGain(): those of SetJointGain()

// Stores gains for the joint; SetDefaultJointGain() later applies these gains.
OStatus RegisterDefaultJointGain(OPrimitiveID id, word pg, word ig, word dg, word ps, word is,
                                 word ds);
// Errors of RegisterDefaultJointGain(): oINVALID_PRIMITIVE_ID

OStatus SetDefaultJointGain(OPrimitiveID id);
// Errors of SetDefaultJointGain(): those of SetJointGain()

OStatus GetDefaultJointGain(OPrimitiveID id, word* pg, word* ig, word* dg, word* ps, word* is,
                            word* ds);
// Errors of GetDefaultJointGain(): oFAIL; all six numbers are then 0

// ---- starting several vectors together

// Makes a sync key, with which several vectors start together; at most ovrsynckeyMAX_NUM_KEY keys
// exist at a time.  If the call fails, *key is ovrsynckeyUNDEF.
OStatus NewSyncKey(OVRSyncKey* key);
// Errors of NewSyncKey(): oNO_SYNC_KEY

OStatus CancelSyncKey(OVRSyncKey key);
// Errors of CancelSyncKey(): oINVALID_SYNC_KEY

// Divides a sync key into two parts, which are sync keys too.  The program puts each part into the
// syncKey of one vector; output begins when the vectors with all parts have arrived.
OStatus DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2);
// Errors of DivideSyncKey(): oFAIL

// ---- power

OStatus SetMotorPower(OPower power);
// Errors of SetMotorPower(): oFAIL

// Stores the conditions under which the robot boots again, and then begins the shutdown.  Returns
// before any object is stopped.
OStatus Shutdown(const OBootCondition& bootCondition);
// Stores in bootCondition->bitmap the reason why the robot booted; the other fields of
// *bootCondition then have no meaning.
OStatus GetBootCondition(OBootCondition* bootCondition);
OStatus GetPowerStatus(OPowerStatus* powerStatus);
// Errors of Shutdown(), GetBootCondition() and GetPowerStatus(): oFAIL, oNOT_FOUND

// Sends an OPowerStatusMessage to `entry` at every change that `notifyStatus` selects
// (power_constants.h), until UnobservePowerStatus() is called with the same entry.
OStatus ObservePowerStatus(const OPowerStatus& notifyStatus, const OServiceEntry& entry);
// Errors of ObservePowerStatus(): oFAIL, oNOT_FOUND

OStatus UnobservePowerStatus(const OServiceEntry& entry);
// Errors of UnobservePowerStatus(): oFAIL, oNOT_FOUND, oINVALID_ARG

// Switches the power of the robot off at once, without DoStop and DoDestroy.
OStatus Fatal(OFatal fatal);

// ---- the robot and its files

// Copies the file that DESIGNDB.CFG names for `keyword` into shared memory, decompressed if it is a
// gzip file.
OStatus FindDesignData(const char* keyword, ODesignDataID* id, byte** dataAddr, size_t* size);
// Errors of FindDesignData(): oNOT_FOUND, oDESIGNDATA_SIZE_ZERO, oNO_MEMORY, oFAIL

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
// Errors of DeleteDesignData(): oINVALID_ARG, oFAIL

// Writes a name such as "ERS-210" into `robotDesign`, which needs room for orobotdesignNAME_MAX + 1
// characters.
OStatus GetRobotDesign(char* robotDesign);
OStatus GetMemoryStickStatus(OMemoryStickStatus* status);
// Errors of GetRobotDesign() and GetMemoryStickStatus(): oFAIL

// ---- clock and volume switch

OStatus SetTime(const OTime& time);
OStatus GetTime(OTime* time);
OStatus SetTimeDifference(sbyte timeDif);  // hours, -12..12
OStatus GetTimeDifference(sbyte* timeDif);
// Errors of the functions SetTime() to GetTimeDifference(): oFAIL, oNOT_FOUND

OStatus SetVolumeSwitch(OVolumeSwitch volume);
OStatus GetVolumeSwitch(OVolumeSwitch* volume);
// Errors of SetVolumeSwitch() and GetVolumeSwitch(): oFAIL

// ---- functions of the "level 1" information service, for which there is no document

OStatus RequireMWInfo(MWIID id);
OStatus CancelMWInfo(MWIID id);
OStatus IsMWInfoRequired(MWIID id, bool* required);

}  // namespace OPENR

#endif  // OPENR_OPENRAPI_H_INCLUDED
