//
// Finds the largest blob of a colour in a picture of layer C.
//
// A pixel of this layer has one bit for each colour table.  A blob is a set of pixels of one
// colour that touch each other.
//

#ifndef Blob_h_DEFINED
#define Blob_h_DEFINED

#include <Types.h>

struct Blob {
    int numPixels;  // 0: no pixel has this colour
    double x;       // middle of the blob, in pixels from the left and upper edge of the picture
    double y;
    int left;  // the first and the last column, and the first and the last row
    int right;
    int top;
    int bottom;
};

class BlobFinder {
public:
    static const int MAX_PIXELS = 104 * 80;  // layer C of the largest camera, the ERS-7's

    // Returns the largest blob of the colour with the bit `colour`.  `pixels` has width * height
    // bytes, row by row.  The last row is left out, because it begins with a tag of 16
    // bytes (OPENR/OFbkImage.h).
    Blob FindLargest(const byte* pixels, int width, int height, byte colour);

private:
    Blob TakeBlob(int first, int width, int height);
    void Push(int pixel);

    byte isNew_[MAX_PIXELS];  // 1 for pixels of the colour that belong to no blob yet
    int stack_[MAX_PIXELS];   // pixels of the present blob whose neighbours are not yet looked at
    int numStacked_;
};

#endif  // Blob_h_DEFINED
