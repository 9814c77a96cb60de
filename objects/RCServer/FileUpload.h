//
// FileUpload: the upload of one client, that is, a file that arrives in parts.
//
// The parts go to a temporary file beside the target, UPLOADn.TMP, where n is the client's number.
// End() checks the whole file and renames it.  So the target is always either the old or the
// complete new file.  Every error ends the upload and removes the temporary file.
//

#ifndef FileUpload_h_DEFINED
#define FileUpload_h_DEFINED

#include <stdio.h>

#include "MtnFile.h"
#include "StickStore.h"

class FileUpload {
public:
    FileUpload() : file_(0), place_(0), size_(0), received_(0), crc_(0), crcSoFar_(0) {}
    ~FileUpload() { Abort(); }

    // Sets the number of the client, which becomes a part of the name of the temporary file of an
    // upload.
    void SetPlace(int place) { place_ = place; }

    // Begins the upload that `request` describes.  First ends an earlier upload of this client that
    // has not ended yet.
    int Begin(const StickStore& store, const RcUploadBegin& request, std::string* why);

    // Appends data to the temporary file of the upload; `offset` must be the number of bytes
    // received so far.
    int Append(Uint32 offset, const Uint8* bytes, int count, std::string* why);

    // Checks the whole uploaded file and renames it from its temporary to its final name.  Checks a
    // motion for `robot` by reading it into `motion`; for an image, neither argument is used.
    int End(StickStore* store, const RobotConstants* robot, MtnFile* motion, std::string* why);

    // Ends the upload, if there is one, and removes its temporary file.
    void Abort();

    // Removes the temporary files (UPLOADn.TMP and UPLOADn.OLD) that uploads of the client with
    // this number have left behind in an earlier run.  Returns "" or the path of a file that could
    // not be removed.
    std::string RemoveLeftovers(const StickStore& store) const;

    bool IsOpen() const { return file_ != 0; }
    Uint32 Received() const { return received_; }

private:
    FileUpload(const FileUpload&);
    FileUpload& operator=(const FileUpload&);

    std::string TemporaryName(const char* extension) const;
    int Fail(int status, const std::string& text, std::string* why);
    int CheckWhole(std::string* why);
    int CheckContent(const RobotConstants* robot, MtnFile* motion, std::string* why);
    int CheckImage(std::string* why) const;
    int PutInPlace(StickStore* store, std::string* why);

    FILE* file_;  // the temporary file; 0 if there is no upload
    std::string path_;
    StickName target_;
    int place_;
    Uint32 size_;      // size of the whole file, in bytes
    Uint32 received_;  // number of bytes received so far
    Uint32 crc_;       // CRC-32 that the whole file must have
    Uint32 crcSoFar_;
};

#endif  // FileUpload_h_DEFINED
