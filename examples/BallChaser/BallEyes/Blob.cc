#include "Blob.h"

Blob
BlobFinder::FindLargest(const byte* pixels, int width, int height, byte colour)
{
    Blob largest = {0, 0, 0, 0, 0, 0, 0};
    const int numPixels = width * (height - 1);
    if (numPixels > MAX_PIXELS) return largest;
    for (int i = 0; i < numPixels; i++) isNew_[i] = (pixels[i] & colour) != 0;
    for (int i = 0; i < numPixels; i++) {
        if (!isNew_[i]) continue;
        const Blob blob = TakeBlob(i, width, height - 1);
        if (blob.numPixels > largest.numPixels) largest = blob;
    }
    return largest;
}

// Puts a pixel on the stack, once only, so that the stack never holds more pixels than the
// picture.
void
BlobFinder::Push(int pixel)
{
    if (!isNew_[pixel]) return;
    isNew_[pixel] = 0;
    stack_[numStacked_++] = pixel;
}

// Measures the blob that contains the pixel `first`.
Blob
BlobFinder::TakeBlob(int first, int width, int height)
{
    Blob blob = {0, 0, 0, width, -1, height, -1};
    numStacked_ = 0;
    Push(first);
    while (numStacked_ > 0) {
        const int pixel = stack_[--numStacked_];
        const int x = pixel % width;
        const int y = pixel / width;
        blob.numPixels++;
        blob.x += x + 0.5;
        blob.y += y + 0.5;
        if (x < blob.left) blob.left = x;
        if (x > blob.right) blob.right = x;
        if (y < blob.top) blob.top = y;
        if (y > blob.bottom) blob.bottom = y;
        if (x > 0) Push(pixel - 1);
        if (x < width - 1) Push(pixel + 1);
        if (y > 0) Push(pixel - width);
        if (y < height - 1) Push(pixel + width);
    }
    blob.x /= blob.numPixels;
    blob.y /= blob.numPixels;
    return blob;
}
