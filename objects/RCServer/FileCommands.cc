//
// Answers the requests of the remote control for files of the Memory Stick, for shutdown and for
// reboot.
//

#include "RequestHandler.h"

#include "TextFormat.h"

// Answers with a part of the list of motions, from the index in the request on.  Reads the folder
// anew for each part, so that no list has to be kept for a client.  If files come or go between two
// parts, the indices change.
int
RequestHandler::ListMotions(RcReader* in, RcWriter* out)
{
    const int first = in->U16();
    if (!in->IsComplete()) return FailSize();
    store_.ReadMotions();
    if (first > store_.Count()) {
        return Fail(rcerrorBAD_VALUE, TextFormat("first is %d, but the stick has %d motions", first,
                                                 store_.Count()));
    }
    RcList list;
    list.total = (Uint16)store_.Count();
    list.first = (Uint16)first;
    for (int i = first; i < store_.Count() && (int)list.entries.size() < RC_MAX_LIST_ENTRIES; i++) {
        RcListEntry entry;
        entry.name = store_.Name(i);
        const long size = StickStore::SizeOf(store_.Path(rcfileMOTION, entry.name));
        entry.size = size < 0 ? 0 : (Uint32)size;
        list.entries.push_back(entry);
    }
    list.Write(out);
    return rcOK;
}

// ---- Upload --------------------------------------------------------------------------

int
RequestHandler::FailKind(int kind)
{
    return Fail(rcerrorBAD_VALUE,
                TextFormat("file kind %d is unknown; 0 is a motion, 1 a controller image", kind));
}

int
RequestHandler::BeginUpload(RcReader* in, RcWriter* out)
{
    RcUploadBegin request;
    // Ends an earlier upload of the client even if the new request is wrong, because the client has
    // given the earlier upload up.
    upload_[client_].Abort();
    if (!request.Read(in)) return FailSize();
    if (request.kind >= NUM_RC_FILE_KINDS) return FailKind(request.kind);
    const int status = upload_[client_].Begin(store_, request, &error_);
    if (status == rcOK) out->U16(RC_MAX_UPLOAD_DATA);
    return status;
}

int
RequestHandler::ReceiveUpload(RcReader* in, RcWriter* out)
{
    const Uint32 offset = in->U32();
    if (in->HasFailed() || in->RestSize() == 0) {
        upload_[client_].Abort();
        return FailSize();
    }
    FileUpload& upload = upload_[client_];
    const int status = upload.Append(offset, in->Rest(), in->RestSize(), &error_);
    if (status == rcOK) out->U32(upload.Received());
    return status;
}

int
RequestHandler::EndUpload(RcReader* in, RcWriter* out)
{
    FileUpload& upload = upload_[client_];
    if (!in->IsComplete()) {
        upload.Abort();
        return FailSize();
    }
    const int status = upload.End(&store_, robot_, &motion_, &error_);
    if (status == rcOK) out->U32(upload.Received());
    return status;
}

// ---- Other files ---------------------------------------------------------------------

int
RequestHandler::DeleteFile(RcReader* in)
{
    RcFileName request;
    StickName file;
    if (!request.Read(in)) return FailSize();
    if (request.kind >= NUM_RC_FILE_KINDS) return FailKind(request.kind);
    if (request.kind != rcfileMOTION) {
        return Fail(rcerrorBAD_VALUE, "only motions can be deleted, because without its image of "
                                      "the controller the robot would not boot");
    }
    const int status = store_.CheckName(request.kind, request.name, &file, &error_);
    if (status != rcOK) return status;
    const std::string path = store_.Path(file);
    if (StickStore::SizeOf(path) < 0) {
        return Fail(rcerrorNO_SUCH_FILE, path + ": no such file on the Memory Stick");
    }
    if (remove(path.c_str()) == 0) return rcOK;
    return Fail(rcerrorNOT_WRITTEN, path + ": cannot be deleted; is the stick write-protected?");
}

int
RequestHandler::Download(RcReader* in, RcWriter* out)
{
    RcDownload request;
    StickName file;
    if (!request.Read(in)) return FailSize();
    if (request.kind >= NUM_RC_FILE_KINDS) return FailKind(request.kind);
    const int status = store_.CheckName(request.kind, request.name, &file, &error_);
    if (status != rcOK) return status;
    const std::string path = store_.Path(file);
    Uint32 size = 0;
    const int count =
        StickStore::ReadPart(path, request.offset, part_, RC_MAX_DOWNLOAD_DATA, &size);
    if (count < 0 && request.offset > size && StickStore::SizeOf(path) >= 0) {
        return Fail(rcerrorBAD_VALUE, TextFormat("%s: offset %u is behind its %u bytes", file.name,
                                                 (unsigned)request.offset, (unsigned)size));
    }
    if (count < 0) return Fail(rcerrorNO_SUCH_FILE, path + ": no such file on the Memory Stick");
    out->U32(size);
    out->Bytes(part_, count);
    return rcOK;
}

int
RequestHandler::EndRun(RcReader* in, bool reboot)
{
    if (!in->IsComplete()) return FailSize();
    port_->EndRun(reboot);
    endsRun_ = true;
    return rcOK;
}
