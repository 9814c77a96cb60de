// A source in the manner of old OPEN-R programs, checked by the compiler only.
//
// The source uses names as such programs do: C functions and std names without their
// headers, structures and calls that come along with OObject.h, conversions that the SDK's
// signatures allow.  gnu++98 to gnu++14.
#include <OPENR/ODataArchive.h>
#include <OPENR/ODebug.h>
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSubject.h>

class OldObject : public OObject {
 public:
  virtual OStatus DoInit(const OSystemEvent& event);
  void UpdatePowerStatus(void* msg);
  void Ready(const OReadyEvent& event);

  OSubject* subject[1];
  OObserver* observer[1];

 private:
  int WriteFile(const char* name);
  RCRegion* region;
  OPrimitiveID joint[2];
  OPowerStatus status;
};

using namespace std;

OStatus OldObject::DoInit(const OSystemEvent&) {
  MemoryRegionID id;
  OCommandVectorData* vector;
  if (OPENR::NewCommandVectorData(2, &id, &vector) != oSUCCESS) return oFAIL;
  vector->SetNumData(2);
  for (int i = 0; i < 2; i++) {
    OCommandInfo* info = vector->GetInfo(i);
    info->Set(odataJOINT_COMMAND2, joint[i], ocommandMAX_FRAMES);
    OJointCommandValue2* value = (OJointCommandValue2*)vector->GetData(i)->value;
    for (size_t k = 0; k < ocommandMAX_FRAMES; k++)
      value[k].value = oradians(10 * sin(M_PI * k / 8));
  }
  region = new RCRegion(vector->vectorInfo.memRegionID, vector->vectorInfo.offset, (void*)vector,
                        vector->vectorInfo.totalSize);
  subject[0]->SetData(region);
  subject[0]->NotifyObservers();

  OServiceEntry entry(myOID_, 12);
  OPowerStatus observe;
  observe.Set(orsbALL, obsbALL, opsoREMAINING_CAPACITY_NOT_NOTIFY, opsoTEMPERATURE_NOT_NOTIFY,
              opsoTIME_DIF_NOT_NOTIFY, opsoVOLUME_NOT_NOTIFY);
  return OPENR::ObservePowerStatus(observe, entry);
}

void OldObject::UpdatePowerStatus(void* msg) {
  OPowerStatus* power = &((OPowerStatusMessage*)msg)->powerStatus;
  if (power->robotStatus & orsbPAUSE) {
    OPENR::SetMotorPower(opowerOFF);
    OPENR::Shutdown(OBootCondition(obcbPAUSE_SW));
  }
  OBootCondition reboot(obcbBOOT_TIMER, 0, obcbttRELATIVE);
  OSYSLOG1((osyslogERROR, "%s %x", "status", power->robotStatus));
}

void OldObject::Ready(const OReadyEvent& event) {
  char line[80];
  char design[orobotdesignNAME_MAX + 1];
  if (OPENR::GetRobotDesign(design) == oSUCCESS && strcmp(design, "ERS-210") == 0) gets(line);
  if (!stricmp(line, "stop") || !strnicmp(line, "go", 2)) OSYSPRINT(("%d\n", atoi(line)));
  list<int> numbers;
  map<int, int> table;
  numbers.push_back(abs(-1));
  cout << "ready " << event.SbjIndex() << endl;
  ODesignDataID id;
  MemoryRegionID* region_id = (MemoryRegionID*)&id;
  cout << (region_id != 0);
}

int OldObject::WriteFile(const char* name) {
  FILE* file = fopen(name, "w");
  if (file == NULL) return FALSE;
  fprintf(file, "%d %ld\n", INT_MAX, strtol("12", 0, 10));
  char* copy = (char*)malloc(strlen(name) + 1);
  strcpy(copy, name);
  for (char* c = copy; *c; c++) *c = toupper(*c);
  free(copy);
  fclose(file);
  SystemTime now;
  sError error = GetSystemTime(&now);
  return error == sSUCCESS ? TRUE : FALSE;
}
