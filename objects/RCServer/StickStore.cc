#include "StickStore.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "RemoteProtocol.h"
#include "StickFile.h"

#define IMAGE_DIRECTORY "/MS/OPEN-R/MW/OBJS/"

COMPILE_TIME_CHECK(UploadedMotionsCanBePlayed, (long)RC_MAX_MOTION == STICK_FILE_MAX);

StickStore::StickStore() : count_(0) {}

static bool
HasExtension(const char* name, const char* extension)
{
    const char* dot = strchr(name, '.');
    return dot != 0 && strcmp(dot, extension) == 0;
}

int
StickStore::CheckName(int kind, const std::string& given, StickName* file, std::string* why) const
{
    file->kind = kind;
    if (!MtnFileName(given.c_str(), file->name, why)) return rcerrorNO_SUCH_FILE;
    if (kind == rcfileMOTION && !HasExtension(file->name, ".MTN")) {
        *why = std::string(file->name) + ": the name of a motion ends in .MTN";
        return rcerrorNO_SUCH_FILE;
    }
    if (kind == rcfileIMAGE && strcmp(file->name, RC_IMAGE_NAME) != 0) {
        *why = std::string(file->name) + ": the only image here is " RC_IMAGE_NAME;
        return rcerrorNO_SUCH_FILE;
    }
    return rcOK;
}

std::string
StickStore::Path(int kind, const std::string& name) const
{
    return root_ + (kind == rcfileMOTION ? MTN_DIRECTORY : IMAGE_DIRECTORY) + name;
}

// ---- List of motions -----------------------------------------------------------------

void
StickStore::ReadMotions()
{
    ReadNames(".MTN");
}

// Reads the names of all files with the extension `extension` in the folder of motions.  Returns false
// if the folder cannot be read; `errno` then has the reason.
bool
StickStore::ReadNames(const char* extension)
{
    count_ = 0;
    DIR* folder = opendir(Path(rcfileMOTION, "").c_str());
    if (folder == 0) return false;
    while (const struct dirent* entry = readdir(folder)) {
        char name[MTN_NAME_SIZE];
        std::string why;
        if (MtnFileName(entry->d_name, name, &why) && HasExtension(name, extension)) Insert(name);
    }
    closedir(folder);
    return true;
}

// Inserts a file name into the sorted table of motions.  When the table is full, the last name is
// dropped.
void
StickStore::Insert(const char* name)
{
    int at = count_;
    while (at > 0 && strcmp(names_[at - 1], name) > 0) at--;
    if (at == MAX_MOTIONS) return;
    const int behind = (count_ < MAX_MOTIONS ? count_ : MAX_MOTIONS - 1) - at;
    memmove(names_[at + 1 < MAX_MOTIONS ? at + 1 : at], names_[at], (size_t)behind * NAME_SIZE);
    memcpy(names_[at], name, NAME_SIZE - 1);
    names_[at][NAME_SIZE - 1] = '\0';
    if (count_ < MAX_MOTIONS) count_++;
}

// ---- Files ---------------------------------------------------------------------------

// Opens a file for reading.  Returns 0 for a folder, which some systems open as a file.
static FILE*
OpenStickFile(const std::string& path)
{
    return IsStickFolder(path) ? 0 : fopen(path.c_str(), "rb");
}

static long
SizeOfOpenFile(FILE* file)
{
    return fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
}

long
StickStore::SizeOf(const std::string& path)
{
    FILE* file = OpenStickFile(path);
    if (file == 0) return -1;
    const long size = SizeOfOpenFile(file);
    fclose(file);
    return size;
}

int
StickStore::ReadPart(const std::string& path, Uint32 offset, Uint8* bytes, int count, Uint32* size)
{
    FILE* file = OpenStickFile(path);
    if (file == 0) return -1;
    const long whole = SizeOfOpenFile(file);
    int done = -1;
    if (whole >= 0 && offset <= (Uint32)whole && fseek(file, (long)offset, SEEK_SET) == 0)
        done = (int)fread(bytes, 1, (size_t)count, file);
    if (whole >= 0) *size = (Uint32)whole;
    fclose(file);
    return done;
}

// Returns the spare name of the file `path`, which this file has while Replace() puts another file
// in its place.  The spare name is `path` with a tilde as the first character of the extension, so
// that PutBack() can find the old name.
static std::string
SpareName(const std::string& path)
{
    std::string spare = path;
    spare[spare.rfind('.') + 1] = '~';
    return spare;
}

bool
StickStore::Replace(const std::string& from, const std::string& to)
{
    if (rename(from.c_str(), to.c_str()) == 0) return true;
    // Goes on only after EEXIST or EACCES, which mean that the file system may refuse to replace a
    // file.  After another error, such as that of a full or damaged stick, a second rename() might
    // put an incomplete file in the place of a complete one.
    if (errno != EEXIST && errno != EACCES) return false;
    // The file system may refuse to rename `from` to a name that exists.  No source says whether
    // the robot's file system refuses this.  So gives the file `to` a spare name first, and then
    // renames `from`.  Does not remove `to` before that, because on a full or damaged stick the
    // renaming may fail as well.
    const int error = errno;
    const std::string spare = SpareName(to);
    bool isReplaced = false;
    // Goes on only if `from` and `to` are files, because a folder may not be replaced.
    if (SizeOf(from) >= 0 && SizeOf(to) >= 0) {
        remove(spare.c_str());  // left by an earlier run; usually there is no such file
        if (rename(to.c_str(), spare.c_str()) == 0) {
            isReplaced = rename(from.c_str(), to.c_str()) == 0;
            if (isReplaced) {
                remove(spare.c_str());
            } else {
                rename(spare.c_str(), to.c_str());
            }
        }
    }
    errno = error;
    return isReplaced;
}

// Returns whether the file `path` can be opened for reading; if not, `errno` has the reason.
static bool
CanOpen(const std::string& path)
{
    FILE* file = fopen(path.c_str(), "rb");
    if (file == 0) return false;
    fclose(file);
    // Refuses a folder, which some systems open as a file.
    DIR* folder = opendir(path.c_str());
    if (folder == 0) return true;
    closedir(folder);
    errno = EINVAL;
    return false;
}

// Completes or undoes a Replace() of `path` that was interrupted.  If there is no file `path`,
// renames the spare file (the old file) to `path` again.  If there is a file `path`, removes the
// spare file, because the file `path` is the new file, or the old file with its name back.  Returns
// whether no spare file is left.
static bool
PutBackOne(const std::string& path)
{
    const std::string spare = SpareName(path);
    // Returns true after ENOENT, because then there is no spare file (the usual case).  After any
    // other error there may be a spare file, so returns false and renames nothing.
    if (!CanOpen(spare)) return errno == ENOENT;
    if (CanOpen(path)) return remove(spare.c_str()) == 0;
    return errno == ENOENT && rename(spare.c_str(), path.c_str()) == 0;
}

std::string
StickStore::PutBack()
{
    std::string left;
    const std::string images[] = { Path(rcfileIMAGE, RC_IMAGE_NAME),
                                   Path(rcfileIMAGE, "CONTROLL.OLD") };
    for (int i = 0; i < 2; i++) {
        if (!PutBackOne(images[i])) left = SpareName(images[i]);
    }
    // Ignores ENOENT, because a stick without motions may lack the folder of the motions.
    if (!ReadNames(".~TN") && errno != ENOENT) left = Path(rcfileMOTION, "");
    for (int j = 0; j < count_; j++) {
        std::string motion = Path(rcfileMOTION, names_[j]);
        motion[motion.rfind('.') + 1] = 'M';
        if (!PutBackOne(motion)) left = SpareName(motion);
    }
    count_ = 0;
    return left;
}

bool
StickStore::Copy(const std::string& from, const std::string& to)
{
    FILE* source = fopen(from.c_str(), "rb");
    if (source == 0) return false;
    FILE* copy = fopen(to.c_str(), "wb");
    bool isGood = copy != 0;
    size_t count = 1;
    while (isGood && count > 0) {
        count = fread(copied_, 1, sizeof(copied_), source);
        isGood = ferror(source) == 0 && fwrite(copied_, 1, count, copy) == count;
    }
    int error = isGood ? 0 : errno;
    fclose(source);
    if (copy != 0 && fclose(copy) != 0 && isGood) {
        error = errno;
        isGood = false;
    }
    if (!isGood && copy != 0) remove(to.c_str());
    if (!isGood) errno = error;
    return isGood;
}
