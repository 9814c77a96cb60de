#include "FileUpload.h"

#include <errno.h>

#include "Crc32.h"
#include "ImageFile.h"
#include "RemoteProtocol.h"
#include "StickFile.h"
#include "TextFormat.h"

static const char NO_UPLOAD[] = "no upload goes on; it ended with an error, or was not begun";

// Returns the reason why a file of the stick could not be written, as `errno` gives it.
static const char*
WriteErrorReason()
{
    if (errno == ENOSPC) return "the stick is full; delete files from it";
    if (errno == EROFS) return "the stick is write-protected";
    if (errno == EACCES) {
        return "the stick does not allow it: it is open already, or a link that leads out of the "
               "stick, or neither a file nor a folder";
    }
    return "is the stick full or write-protected?";
}

std::string
FileUpload::TemporaryName(const char* extension) const
{
    // Puts the number of the client into the file name, because several clients may upload at the
    // same time.
    return TextFormat("UPLOAD%d.%s", place_, extension);
}

void
FileUpload::Abort()
{
    if (file_ == 0) return;
    fclose(file_);
    file_ = 0;
    remove(path_.c_str());
}

std::string
FileUpload::RemoveLeftovers(const StickStore& store) const
{
    const std::string paths[] = { store.Path(rcfileMOTION, TemporaryName("TMP")),
                                  store.Path(rcfileIMAGE, TemporaryName("TMP")),
                                  store.Path(rcfileIMAGE, TemporaryName("OLD")) };
    std::string kept;
    for (int i = 0; i < 3; i++) {
        // Ignores ENOENT, because usually an earlier run has left no temporary file.
        if (remove(paths[i].c_str()) != 0 && errno != ENOENT) kept = paths[i];
    }
    return kept;
}

int
FileUpload::Fail(int status, const std::string& text, std::string* why)
{
    Abort();
    *why = text;
    return status;
}

int
FileUpload::Begin(const StickStore& store, const RcUploadBegin& request, std::string* why)
{
    Abort();
    const int status = store.CheckName(request.kind, request.name, &target_, why);
    if (status != rcOK) return status;
    const Uint32 most = request.kind == rcfileMOTION ? RC_MAX_MOTION : RC_MAX_IMAGE;
    if (request.size == 0 || request.size > most) {
        return Fail(rcerrorBAD_VALUE,
                    TextFormat("%s has %u bytes, must have 1 to %u", target_.name,
                               (unsigned)request.size, (unsigned)most),
                    why);
    }
    path_ = store.Path(request.kind, TemporaryName("TMP"));
    file_ = fopen(path_.c_str(), "wb");
    if (file_ == 0) {
        return Fail(rcerrorNOT_WRITTEN, path_ + ": cannot be made; " + WriteErrorReason(), why);
    }
    size_ = request.size;
    crc_ = request.crc;
    received_ = 0;
    crcSoFar_ = 0;
    return rcOK;
}

int
FileUpload::Append(Uint32 offset, const Uint8* bytes, int count, std::string* why)
{
    if (file_ == 0) return Fail(rcerrorNO_UPLOAD, NO_UPLOAD, why);
    if (offset != received_) {
        return Fail(rcerrorBAD_VALUE,
                    TextFormat("%s: data for offset %u, but the next is %u", target_.name,
                               (unsigned)offset, (unsigned)received_),
                    why);
    }
    if ((Uint32)count > size_ - received_) {
        return Fail(rcerrorBAD_VALUE,
                    TextFormat("%s: more data than the %u bytes that were announced", target_.name,
                               (unsigned)size_),
                    why);
    }
    // Flushes each part, because the C library would otherwise keep the bytes in its buffer.  In
    // this way the answer to a part says whether the stick had room for the part.
    if (fwrite(bytes, 1, (size_t)count, file_) != (size_t)count || fflush(file_) != 0) {
        return Fail(rcerrorNOT_WRITTEN,
                    TextFormat("%s: byte %u cannot be written; %s", target_.name,
                               (unsigned)received_, WriteErrorReason()),
                    why);
    }
    received_ += (Uint32)count;
    crcSoFar_ = Crc32(crcSoFar_, bytes, count);
    return rcOK;
}

// ---- End of an upload ----------------------------------------------------------------

int
FileUpload::End(StickStore* store, const RobotConstants* robot, MtnFile* motion, std::string* why)
{
    if (file_ == 0) return Fail(rcerrorNO_UPLOAD, NO_UPLOAD, why);
    int status = CheckWhole(why);
    if (status != rcOK) return status;
    // Closes the file before it is checked, because the robot cannot open a file for reading that
    // is open for writing.
    const bool isWritten = fclose(file_) == 0;
    file_ = 0;
    status = isWritten ? CheckContent(robot, motion, why) : rcerrorNOT_WRITTEN;
    if (!isWritten) *why = std::string(target_.name) + ": cannot be written; " + WriteErrorReason();
    if (status == rcOK) status = PutInPlace(store, why);
    if (status != rcOK) remove(path_.c_str());
    return status;
}

int
FileUpload::CheckWhole(std::string* why)
{
    if (received_ != size_) {
        return Fail(rcerrorBAD_FILE,
                    TextFormat("%s: %u bytes have arrived, %u were announced", target_.name,
                               (unsigned)received_, (unsigned)size_),
                    why);
    }
    if (crcSoFar_ == crc_) return rcOK;
    return Fail(rcerrorBAD_FILE,
                TextFormat("%s: the CRC-32 is %08x, %08x was announced", target_.name,
                           (unsigned)crcSoFar_, (unsigned)crc_),
                why);
}

// Checks the uploaded file as it is on the stick, and not the bytes that have arrived, so that a
// write error is found, too.
int
FileUpload::CheckContent(const RobotConstants* robot, MtnFile* motion, std::string* why)
{
    if (StickStore::SizeOf(path_) != (long)size_) {
        *why = std::string(target_.name) + ": the stick has not kept all bytes; is it full?";
        return rcerrorNOT_WRITTEN;
    }
    if (target_.kind == rcfileIMAGE) return CheckImage(why);
    std::vector<Uint8> bytes;
    if (!ReadStickFile(path_, &bytes, why)) return rcerrorNOT_WRITTEN;
    const bool isGood = motion->Read(&bytes[0], bytes.size()) && motion->MapTo(robot);
    if (isGood) return rcOK;
    *why = std::string(target_.name) + ": " + motion->Error();
    return rcerrorBAD_FILE;
}

int
FileUpload::CheckImage(std::string* why) const
{
    Uint8 head[IMAGE_HEAD_SIZE];
    Uint32 size = 0;
    const int count = StickStore::ReadPart(path_, 0, head, IMAGE_HEAD_SIZE, &size);
    const ImageProcessor processor = ImageProcessorOf(head, count);
    if (processor == OwnProcessor() && processor != imageUNKNOWN) return rcOK;
    if (processor == imageUNKNOWN) {
        *why = std::string(target_.name) + ": is no image of an object";
    } else {
        *why = TextFormat("%s: is an image for %s; this robot needs one for %s", target_.name,
                          ImageProcessorName(processor), ImageProcessorName(OwnProcessor()));
    }
    return rcerrorBAD_FILE;
}

int
FileUpload::PutInPlace(StickStore* store, std::string* why)
{
    const std::string target = store->Path(target_);
    // Copies the old image instead of renaming it, so that the stick always has an image: without
    // an image the robot would not boot.
    if (target_.kind == rcfileIMAGE && StickStore::SizeOf(target) >= 0) {
        // Copies to another name first, so that CONTROLL.OLD is a whole image at every moment.
        const std::string copy = store->Path(rcfileIMAGE, TemporaryName("OLD"));
        if (!store->Copy(target, copy) ||
            !StickStore::Replace(copy, store->Path(rcfileIMAGE, "CONTROLL.OLD"))) {
            *why = std::string(target_.name) +
                   ": the old image cannot be kept as CONTROLL.OLD; " + WriteErrorReason();
            remove(copy.c_str());
            return rcerrorNOT_WRITTEN;
        }
    }
    if (StickStore::Replace(path_, target)) return rcOK;
    *why = target + ": cannot be replaced; " + WriteErrorReason();
    // Replaces the reason if `target` is a folder, because systems give different errors for it.
    if (IsStickFolder(target)) *why = target + ": is a folder, and a file cannot replace it";
    return rcerrorNOT_WRITTEN;
}
