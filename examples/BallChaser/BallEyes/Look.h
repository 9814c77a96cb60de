//
// The way of a ray of light: from a pixel back to the place where it came from.
//

#ifndef Look_h_DEFINED
#define Look_h_DEFINED

// A direction in the dog's own frame: x forward, y to the left, z up.
struct Ray {
    double x;
    double y;
    double z;
};

class Look {
public:
    // A look with the neck at these angles, in rad, for pictures of this size.
    Look(double tilt, double pan, int width, int height);

    // Returns the direction of a point of the picture.
    Ray RayOf(double pixelX, double pixelY) const;

    // Finds the place x, y, in mm from the dog's middle, of a thing whose middle is `height` mm
    // above the floor.  Returns false when the ray goes up, or down so little that the thing would
    // be farther away than the field is long.
    bool FindPlace(const Ray& ray, double height, double* x, double* y) const;

private:
    double cosTilt_;
    double sinTilt_;
    double cosPan_;
    double sinPan_;
    int width_;
    int height_;
    Ray lens_;  // place of the lens in the dog's own frame, in mm
};

#endif  // Look_h_DEFINED
