//
// states: a small state machine, in C++.  A touch of the back makes the dog sit down or stand up, a
// touch of the head makes it bow while it stands.  Every motion is played to its end.
//
//            back                 over           back                 over
//   STANDS ---------> SITS_DOWN ---------> SITS ---------> STANDS_UP ---------> STANDS
//
//            front of the head            over
//   STANDS ----------------------> BOWS ----------> STANDS
//

#include <device/led.h>
#include <device/mtn.h>
#include <device/robot.h>
#include <device/touch_sensor.h>

class Dog {
public:
    Dog() : state_(STANDS), playing_(0) {}

    void Find()
    {
        back_ = robot_get_device("PRM:/r6/s1-Sensor:s1");
        head_ = robot_get_device("PRM:/r1/c1/c2/c3/f2-Sensor:f2");
        green_ = robot_get_device("PRM:/r1/c1/c2/c3/l2-LED2:l2");
        red_ = robot_get_device("PRM:/r1/c1/c2/c3/l1-LED2:l1");
        sit_ = mtn_new("SIT.MTN");
        stand_ = mtn_new("STAND.MTN");
        bow_ = mtn_new("BOW.MTN");
    }

    void Step()
    {
        const bool isOver = mtn_is_over(playing_) != 0;
        switch (state_) {
        case STANDS:
            if (touch_sensor_get_value(back_)) Play(sit_, SITS_DOWN);
            else if (touch_sensor_get_value(head_)) Play(bow_, BOWS);
            break;
        case SITS_DOWN:
            if (isOver) state_ = SITS;
            break;
        case SITS:
            if (touch_sensor_get_value(back_)) Play(stand_, STANDS_UP);
            break;
        case STANDS_UP:
        case BOWS:
            if (isOver) state_ = STANDS;
            break;
        }
        led_set(green_, state_ == STANDS || state_ == SITS);
        led_set(red_, state_ != STANDS && state_ != SITS);
    }

private:
    enum State { STANDS, SITS_DOWN, SITS, STANDS_UP, BOWS };

    void Play(MTN* motion, State next)
    {
        playing_ = motion;
        mtn_play(motion);
        state_ = next;
    }

    State state_;
    MTN* playing_;
    MTN *sit_, *stand_, *bow_;
    DeviceTag back_, head_, green_, red_;
};

static Dog dog;

static void
reset()
{
    dog.Find();
}

static int
run(int)
{
    dog.Step();
    return 64;
}

int
main()
{
    robot_live(reset);
    robot_run(run);
    return 0;
}
