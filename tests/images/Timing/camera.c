/* Enables the camera, looks at three pictures, disables it. */
#include <device/camera.h>
#include <device/robot.h>

static DeviceTag camera;
static int iteration, pictures;

static void
tell(const unsigned char *image)
{
    const int width = camera_get_width(camera);
    const int height = camera_get_height(camera);
    int x;
    for (x = width / 16; x < width; x += width / 8) {
        robot_console_printf("%d,%d,%d ", camera_image_get_red(image, width, x, height / 4),
                             camera_image_get_green(image, width, x, height / 4),
                             camera_image_get_blue(image, width, x, height / 4));
    }
    robot_console_printf("picture\n");
}

static int
run(int ms)
{
    (void)ms;
    if (++iteration == 10) camera_enable(camera, 64);
    if (pictures < 3 && camera_get_image(camera) != 0) {
        tell(camera_get_image(camera));
        if (++pictures == 3) camera_disable(camera);
    }
    return 64;
}

int
main(void)
{
    camera = robot_get_device("PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1");
    robot_run(run);
    return 0;
}
