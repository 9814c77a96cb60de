#include "gait.h"

#include <device/mtn.h>

static MTN *begin, *cycle, *end;
static MTN *playing; /* null: the dog stands */

void
gait_load(void)
{
    begin = mtn_new("WALKSTA.MTN");
    cycle = mtn_new("WALK.MTN");
    end = mtn_new("WALKEND.MTN");
}

void
gait_step(int go)
{
    if (playing != 0 && !mtn_is_over(playing)) return;
    if (playing == 0 || playing == end) {
        playing = go ? begin : 0;
    } else {
        playing = go ? cycle : end;
    }
    if (playing != 0) mtn_play(playing);
}

int
gait_is_standing(void)
{
    return playing == 0;
}
