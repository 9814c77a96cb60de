/*
 * Walking that can be told to stop.
 */

#ifndef GAIT_H
#define GAIT_H

void gait_load(void);

/* To be called in every step: walks on while `go`, otherwise ends the walk and stands. */
void gait_step(int go);

/* 1 when the dog stands. */
int gait_is_standing(void);

#endif
