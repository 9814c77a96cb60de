#include "Leg.h"

#include "Maths.h"

// Lengths in millimetres, after the drawings of Model Information ERS-210, 1.2.  At zero angles
// the knee is KNEE_FORWARD before and KNEE_DOWN below the shoulder; the paw is behind and below
// the knee.  A hind leg is a fore leg seen in a mirror, with another shin: its knee points
// backward.
static const double SHOULDER_X = 59.5;
static const double SHOULDER_Y = 59.2;
static const double KNEE_FORWARD = 12.8;
static const double KNEE_DOWN = 64;
static const double FORE_SHIN_BACK = 11.764;
static const double FORE_SHIN_DOWN = 55.854;
static const double HIND_SHIN_BACK = 22.251;
static const double HIND_SHIN_DOWN = 60.718;

// Recommended limits in degrees (Model Information ERS-210, 2.2.1).
static const double LOWEST[JOINTS_PER_LEG] = {-117, -11, -27};
static const double HIGHEST[JOINTS_PER_LEG] = {117, 89, 147};

// Thigh and shin are two sides of a triangle, whose third side is the distance from the shoulder
// to the paw: the law of cosines gives the knee.  Then the spread brings the paw to its distance
// from the dog's middle, and the swing does the rest.
void
FindLegAngles(int leg, const Place& paw, double angle[JOINTS_PER_LEG])
{
    const double shinBack = IsFore(leg) ? FORE_SHIN_BACK : HIND_SHIN_BACK;
    const double shinDown = IsFore(leg) ? FORE_SHIN_DOWN : HIND_SHIN_DOWN;
    const double x = (IsFore(leg) ? paw.x : -paw.x) - SHOULDER_X;
    const double y = (IsLeft(leg) ? paw.y : -paw.y) - SHOULDER_Y;
    const double z = paw.z;

    const double thigh2 = KNEE_FORWARD * KNEE_FORWARD + KNEE_DOWN * KNEE_DOWN;
    const double shin2 = shinBack * shinBack + shinDown * shinDown;
    const double cosine = (x * x + y * y + z * z - thigh2 - shin2) / (2 * sqrt(thigh2 * shin2));
    // The angle between the directions of thigh and shin at J3 = 0.
    const double bend = ArcTan2(KNEE_FORWARD, KNEE_DOWN) + ArcTan2(shinBack, shinDown);
    angle[2] = ArcCos(cosine) + bend;
    angle[2] = Limit(angle[2], Rad(LOWEST[2]), Rad(HIGHEST[2]));

    // The paw in the plane of the leg, for J1 = J2 = 0.
    const double c = Cos(angle[2]);
    const double s = Sin(angle[2]);
    const double ahead = KNEE_FORWARD - shinBack * c + shinDown * s;
    const double down = KNEE_DOWN + shinBack * s + shinDown * c;

    const double spread = Limit(y / down, -1, 1);
    angle[1] = PI / 2 - ArcCos(spread);
    angle[1] = Limit(angle[1], Rad(LOWEST[1]), Rad(HIGHEST[1]));

    angle[0] = ArcTan2(x, -z) - ArcTan2(ahead, down * Cos(angle[1]));
    angle[0] = Limit(WrapAngle(angle[0]), Rad(LOWEST[0]), Rad(HIGHEST[0]));
}
