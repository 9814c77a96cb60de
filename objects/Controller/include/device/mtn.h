/*
 * Motion files (Hohl 2004, section 5.3.7).
 *
 * Motions lie in /MS/OPEN-R/MW/DATA/P and are named without it: mtn_new("WALK.MTN").  A null
 * pointer is allowed everywhere and stands for a motion of no length that is over.
 */

#ifndef DEVICE_MTN_H
#define DEVICE_MTN_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct MtnMotion MTN;

/* Loads a motion; null if that fails.  Lower case letters are converted to upper case. */
MTN *mtn_new(const char *filename);

/* Why the last mtn_new() failed; null if it did not. */
const char *mtn_get_error(void);

/* Frees the motion; the file stays. */
void mtn_delete(MTN *mtn);

/* Plays it once. */
void mtn_play(MTN *mtn);

/* Milliseconds: of the whole motion, and of the position in it (the end when it does not play). */
int mtn_get_length(MTN *mtn);
int mtn_get_time(MTN *mtn);

/* 1 when it does not play (any more). */
int mtn_is_over(MTN *mtn);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_MTN_H */
