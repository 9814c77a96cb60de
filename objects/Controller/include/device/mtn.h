/*
 * Motion files (Hohl 2004, section 5.3.7).
 *
 * Motions are in /MS/OPEN-R/MW/DATA/P and are named without this path: mtn_new("WALK.MTN").  All
 * functions accept a null pointer, which is a motion without length that is over.
 */

#ifndef DEVICE_MTN_H
#define DEVICE_MTN_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct MtnMotion MTN;

/* Loads a motion; null if that fails.  Lower case letters are converted to upper case. */
MTN *mtn_new(const char *filename);

/* The reason why the last mtn_new() failed; null if it did not fail. */
const char *mtn_get_error(void);

/* Frees the motion; the file stays. */
void mtn_delete(MTN *mtn);

/* Plays the motion once. */
void mtn_play(MTN *mtn);

/* Length of the motion, and time since its beginning (the length when it does not play), ms. */
int mtn_get_length(MTN *mtn);
int mtn_get_time(MTN *mtn);

/* 1 when the motion does not play, or no more; else 0. */
int mtn_is_over(MTN *mtn);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_MTN_H */
