// Reports files of the stick whose bytes the host's disk has not taken, for instance because it is
// full.  Programs often ignore such an error.
#pragma once

#include <cstdio>

#include "runtime/core/object.h"

namespace openr_host {

// Adds a warning that bytes which the current object has written to `file` are not in the file,
// once for each file.  `error` is the errno of the write that failed; 0 if it is not known.  Keeps
// errno, because the object reads it.
void ReportWriteError(OpenFiles::File* file, int error);

// Writes the bytes that `stream` still holds to its `file`.  Reports, as ReportWriteError() does,
// if this write or an earlier one to the stream has failed.  Keeps errno.
void FlushStream(std::FILE* stream, OpenFiles::File* file);

// Reports, as ReportWriteError() does, if an earlier write to the stream `file` of the current
// object has failed.  Called before the stream's mark of an error is cleared.  Does nothing for a
// stream that is not a file of the object.
void ReportErrorMark(std::FILE* file);

// Writes to their files the bytes that are still in the buffers of the streams that `object` has
// left open.  Reports, as ReportWriteError() does, each file whose bytes the disk does not take,
// now or at an earlier write.  Called before an object is replaced, which closes its streams
// without a look at errors, and at the end of `openr run`.  Not called with --jobs, because the
// stick of its robots is write-protected.
void FlushStreams(Object* object);

}  // namespace openr_host
