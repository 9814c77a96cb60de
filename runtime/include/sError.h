// Results of the functions of Aperios, the robot's operating system (Send, Call,
// NewSharedMemoryRegion ...); 0 is success.
//
// Two errors occurred often in practice: 13, because the receiver's queue of 32 messages is full,
// and 28, because no answer came in time.
#ifndef OPENR_SERROR_H_INCLUDED
#define OPENR_SERROR_H_INCLUDED

#include <Types.h>

// The first ten results of the functions of Aperios, the robot's operating system, are macros, as
// on the robot, so that the preprocessor can test them.
#define sSUCCESS 0
#define sUNDEF 1
#define sFAIL 2
#define sNOTSUPPORTED 3
#define sNOTENOUGHRES 4
#define sINVALIDARG 5
#define sNOMEMORY 6
#define sINVALIDOID 7
#define sNOTIMPLYET 9

const sError SystemErrorBase = 10;
const sError sOBJNOTFOUND = 12;
const sError sFULLMSGQENTRY = 13;  // the receiver's queue already has 32 messages
const sError sFULLMSGQENT = sFULLMSGQENTRY;
const sError sFULLMSGPOOL = 14;
const sError sEXCEEDEDSIZEOFMSG = 15;
const sError sEXCEEDEDSIZEOFENTRYTABLE = 16;  // the receiver has no entry with this selector
const sError sTIDCANNOTBECREATED = 17;
const sError sRBOXCANNOTBECREATED = sTIDCANNOTBECREATED;
const sError sINVALIDRID = 18;
const sError sINVALIDTID = sINVALIDRID;
const sError sRBOXALREADYUSED = 19;
const sError sINVALIDREPLY = sRBOXALREADYUSED;
const sError sRIDCANNOTBETREATED = 20;
const sError sTIDNOTFOUND = 21;
const sError sRIDNOTFOUND = sTIDNOTFOUND;
const sError sRBOXWASCLEANED = 22;
const sError sREPLIERFAILED = 23;
const sError sNOTENOUGHSIZEOFMSG = 24;
const sError sFULLEVENTENTRY = 25;
const sError sFULLREVENTENT = sFULLEVENTENTRY;
const sError sFULLTEVENTMSGPOOL = sFULLEVENTENTRY;
const sError sINVALIDEVENTID = 26;
const sError sINVALIDTEVENTINFO = 27;
const sError sTIMEOUT = 28;
const sError sMAILERNOTFOUND = 29;
const sError sFAILINTERCOM = 30;
const sError sINVALIDRESOURCE = 31;
const sError sMailer_FullSystemTimerEntry = 32;

const sError sALREADYATTACHEDSHAREDMEM = 41;
const sError sINVALIDSHAREDMEMID = 42;
const sError sINVALIDSHAREDMEMPROTECT = 43;
const sError sPERMISSIONDENIEDSHAREDMEM = 44;
const sError sSHMALREADYATTACHED = sALREADYATTACHEDSHAREDMEM;
const sError sSHMINVALIDBLOCKID = sINVALIDSHAREDMEMID;
const sError sSHMINVALIDPROTECT = sINVALIDSHAREDMEMPROTECT;
const sError sSHMPERMISSIONDENIED = sPERMISSIONDENIEDSHAREDMEM;

const sError sNOTIMERAVAILABLE = 80;

const sError sNOMODULE = 90;  // an image that OBJECT.CFG names is missing
const sError sBADFORMATMODULE = 91;
const sError sBADCONFIGMODULE = 92;
const sError sOBLETNOTFOUND = 93;
const sError sOBLETNAMETOOLONG = 94;

const sError APISpecificErrorBase = 2000;

#endif  // OPENR_SERROR_H_INCLUDED
