#include "StickFile.h"

#include <dirent.h>
#include <stdio.h>

#include "TextFormat.h"

bool
IsStickFolder(const std::string& path)
{
    DIR* folder = opendir(path.c_str());
    if (folder == 0) return false;
    closedir(folder);
    return true;
}

bool
ReadStickFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error)
{
    bytes->clear();
    // Folders are refused here, because some systems open a folder as a file, with a size that
    // means nothing.
    if (IsStickFolder(path)) {
        *error = path + ": is a folder, not a file";
        return false;
    }
    FILE* file = fopen(path.c_str(), "rb");
    if (file == 0) {
        *error = path + ": no such file on the Memory Stick";
        return false;
    }
    long size = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    if (size > STICK_FILE_MAX) {
        *error = path + TextFormat(" has %ld bytes, more than the %ld a motion may have", size,
                                   STICK_FILE_MAX);
    } else if (size < 0 || fseek(file, 0, SEEK_SET) != 0) {
        *error = path + ": its size cannot be told";
    } else {
        bytes->resize((size_t)size);
        if (size > 0 && fread(&(*bytes)[0], 1, (size_t)size, file) != (size_t)size) {
            *error = path + ": reading failed";
            bytes->clear();
            size = -1;
        }
    }
    fclose(file);
    return size >= 0 && size <= STICK_FILE_MAX;
}
